"""Circles and thin lines that look alike and are not: what each is, by where it stands and whose it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import Figure, View
from ...board.paper.marks import Arc, GearMark, Mark, Point, RackMark, Role, Segment
from ...board.paper.titled import ALONG_AXIS, CRANKSHAFT, SUMS_OF_LENGTHS
from ...words import Words
from .kind import Kind
from .letters import is_of_cam, is_of_curvature, is_of_gear
from .met import Met, imagined, is_outline, of_rotor, on_curvature, traced
from .samples import line

_ON = 0.05  # mm: a circle passes through a point that is no farther from it


def is_return_circle(figure: Figure, mark: Mark) -> bool:
    """Whether it is the mirror image of the inflection circle, as large as that."""
    inflection = (one.radius for one in figure.marks if isinstance(one, Arc) and one.role is Role.GIVEN)
    drawn = on_curvature(Role.HIDDEN, Arc)(figure, mark)
    return drawn and isinstance(mark, Arc) and any(abs(mark.radius - radius) < 1e-6 for radius in inflection)


def osculating(figure: Figure, mark: Mark) -> bool:
    """Whether it is the circle that a path has in common with its centre of curvature."""
    return on_curvature(Role.HIDDEN, Arc)(figure, mark) and not is_return_circle(figure, mark)


def of_rack(*, generating: bool) -> Met:
    """Whether it is another position of a rack that generates a gear, or of something else."""
    drawn = traced(Role.PLACE, Segment)
    return lambda figure, mark: drawn(figure, mark) and is_of_gear(figure) is generating


def _seen(*names: str) -> Met:
    """Whether it stands on a figure of these kinds."""
    return lambda figure, _: figure.view.name in names


def _titled(title: Words) -> Met:
    """Whether it stands on the figure of this title."""
    return lambda figure, _: figure.title == title


def _on(*names: str) -> Met:
    """Whether it stands on a figure of the mechanism of one of these names."""
    return lambda figure, _: figure.view is View.MECHANISM and figure.name in names


def _of(what: str) -> Met:
    """Whether it belongs to the symbol of a joint, or of a link."""
    return lambda _, mark: mark.owner.split()[:1] == [what]


def _on_gear(figure: Figure, _: Mark) -> bool:
    return is_of_gear(figure)


def _geared(figure: Figure, mark: Mark) -> bool:
    """Whether it is the circle of a wheel, among others that mesh with it."""
    return _of("link")(figure, mark) and any(isinstance(one, GearMark | RackMark) for one in figure.marks)


def _on_cam(figure: Figure, _: Mark) -> bool:
    return is_of_cam(figure)


def _on_body(figure: Figure, _: Mark) -> bool:
    return figure.view is View.BODY


def _on_images(figure: Figure, _: Mark) -> bool:
    return figure.view.images


def _on_rotor(figure: Figure, _: Mark) -> bool:
    return of_rotor(figure) or figure.title == ALONG_AXIS


def _through(label: str) -> Met:
    """Whether it is a circle on the drawing of a cam that passes through the point of this letter."""
    return lambda figure, mark: (
        isinstance(mark, Arc)
        and is_of_cam(figure)
        and any(
            isinstance(one, Point) and one.label == label and abs(abs(one.at - mark.centre) - mark.radius) < _ON
            for one in figure.marks
        )
    )


def _each(drawn: Met, *told: tuple[str, str, Met], plain: bool = False) -> Iterator[Kind]:
    """A kind for each of these words, of the marks that are drawn so and pass its test and none of those before it."""
    for n, (zh, en, test) in enumerate(told):
        before = [other for _, _, other in told[:n]]

        def met(figure: Figure, mark: Mark, test: Met = test, before: Sequence[Met] = before) -> bool:
            return drawn(figure, mark) and test(figure, mark) and not any(one(figure, mark) for one in before)

        yield Kind(words=Words(zh, en), met=met, sample=line, plain=plain)


def _any(_: Figure, __: Mark) -> bool:
    return True


ROUNDS = tuple(
    _each(
        traced(Role.CENTRE, Arc),
        ("齿轮的影像", "image of a gear", _on_images),
        ("齿顶圆、分度圆、齿根圆", "tip, reference, root circle", _on_gear),
        ("节圆", "pitch circle", _geared),
        ("偏距圆", "offset circle", _of("joint")),
        ("偏距圆", "offset circle", _through("C_0")),
        ("摆轴中心所在的圆", "circle of the pivots", _through("A")),
        ("基圆", "base circle", _of("link")),
        ("基圆", "base circle", _on_cam),
        ("加重圆", "circle of the correction weights", _on_rotor),
        ("以 $V_0$ 为半径的圆", "circle of radius $V_0$", _seen("vibration", "vibration-speed")),
        ("以 $F_1$、$F_2$ 为半径的圆", "circles of radius $F_1$, $F_2$", _seen("hodograph")),
        ("销的轨迹圆", "circle of a pin", _any),
    )
)
FINE = tuple(
    _each(
        imagined,
        ("代换高副的构件", "link in place of a contact", _of("joint")),
        ("中间平面", "middle plane", _titled(CRANKSHAFT)),
        ("会交的力作用线", "lines of action that meet", _on_body),
        ("延长线、辅助线", "extended or auxiliary line", _any),
    )
)
THIN = tuple(
    _each(
        is_outline,
        ("滚子", "roller", _of("link")),
        ("转子的轮廓", "outline of the rotor", _on_rotor),
        ("齿条的齿廓", "flank of the rack", _on_gear),
        ("传动带、绳", "belt, rope", _on("train")),
        ("反向截取的杆长", "length laid off backwards", _titled(SUMS_OF_LENGTHS)),
        ("支承环面", "bearing ring", _on("collar")),
        ("选定的曲柄线", "crank line that is kept", _on("trial cranks")),
        ("自变量的区间", "range of the variable", _on("precision points")),
        ("曲率驻点曲线的直线", "line of the cubic", lambda figure, _: is_of_curvature(figure)),
        ("轮廓、连线", "outline or connecting line", _any),
        plain=True,
    )
)
