"""The kinds of line and symbol that a legend explains: how each is known, how its sample looks, what it stands for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ...board.construction import Figure, View
from ...board.paper.marks import (
    Arc,
    Curve,
    Dot,
    FrictionCircle,
    GearMark,
    Hatched,
    ImageOf,
    Mark,
    Passing,
    Point,
    Role,
    Segment,
    Vector,
    Weld,
)
from ...board.paper.tones import key_of
from ...foundation.slotted import dataclass
from ...words import Lang, Words
from ..beside import ASIDE, beside
from ..hues import dash_of
from ..labels.actions import is_line_of_action
from ..style import Dash
from ..symbols.around import RING
from .entry import HALF, MIDDLE, WIDE, Entry, drawn_as_on
from .letters import is_of_curvature

Marks = tuple[Mark, ...]
LEAST = 8.0  # mm²: an image with a smaller area is a line


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """met: whether a mark of a figure is one; sample: how it looks, by one that was met."""

    words: Words
    met: Callable[[Figure, Mark], bool]
    sample: Callable[[Mark], Marks]
    black: bool = False
    plain: bool = False


def kinds_met(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """An entry for each kind that these figures have, in the order of KINDS."""
    marks = [(figure, mark) for figure in figures for mark in figure.marks]
    for kind in KINDS:
        first = next(((figure, mark) for figure, mark in marks if kind.met(figure, mark)), None)
        if first is not None:
            figure, mark = first
            yield Entry(drawn_as_on(figure, kind.sample(mark), lang, black=kind.black), kind.words, kind.plain)


def side_by_side(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """Where vectors that lie on one line are drawn beside each other."""
    for figure in figures:
        if beside(figure.view, figure.marks) is not figure.marks:
            pair = tuple(Vector(a=1j * y, b=WIDE + 1j * y, role=Role.RESULT) for y in (ASIDE / 2, -ASIDE / 2))
            words = Words("并排的矢量实际共线", "side by side: on one line")
            yield Entry(drawn_as_on(figure, pair, lang, black=True), words)
            return


def _polygon(figure: Figure) -> bool:
    """Whether vectors are laid end to end on it."""
    return not figure.view.bodies and figure.view is not View.MECHANISM and figure.view.across is None


def _line(mark: Mark) -> Marks:
    role = getattr(mark, "role", Role.CENTRE)
    return (Segment(a=0j, b=complex(WIDE), role=role, key=mark.key),)


def _arrow(role: Role, key: str = "") -> Marks:
    return (Vector(a=0j, b=complex(WIDE), role=role, key=key),)


def _traced(role: Role, *types: type[Mark]) -> Callable[[Figure, Mark], bool]:
    return lambda _, mark: isinstance(mark, types) and getattr(mark, "role", None) is role


def _dot(dot: Dot) -> Callable[[Figure, Mark], bool]:
    return lambda _, mark: isinstance(mark, Point) and mark.dot is dot


def _pinned(dot: Dot) -> Callable[[Mark], Marks]:
    return lambda _: (Segment(a=0j, b=complex(WIDE), role=Role.LINK), Point(at=MIDDLE, label="", dot=dot))


def _in_centre_polygon(figure: Figure) -> bool:
    return figure.name == "centre polygon"


def _profile(role: Role) -> Callable[[Figure, Mark], bool]:
    """Whether it is the pitch curve of a cam, or its profile beside that."""
    return lambda figure, mark: (
        isinstance(mark, Curve)
        and mark.role is role
        and {Role.HIDDEN, Role.LINK} <= {one.role for one in figure.marks if isinstance(one, Curve)}
    )


def _on_curvature(role: Role, *types: type[Mark]) -> Callable[[Figure, Mark], bool]:
    traced = _traced(role, *types)
    return lambda figure, mark: traced(figure, mark) and is_of_curvature(figure)


def _imagined(figure: Figure, mark: Mark) -> bool:
    hidden = isinstance(mark, Segment) and mark.role is Role.HIDDEN
    return hidden and not _in_centre_polygon(figure) and not _of_rotor(figure)


def _of_rotor(figure: Figure) -> bool:
    return figure.view.name == "end-view"


def _area(points: Sequence[complex]) -> float:
    """Of a polygon, mm²."""
    return abs(sum((a.conjugate() * b).imag for a, b in zip(points, (*points[1:], *points[:1]), strict=True))) / 2


def _hatched(rising: bool) -> Kind:
    corners = (-1j * HALF, WIDE - 1j * HALF, WIDE + 1j * HALF, 1j * HALF)
    return Kind(
        words=Words("盈功", "surplus of work") if rising else Words("亏功", "deficit of work"),
        met=lambda _, mark: isinstance(mark, Hatched) and mark.rising is rising,
        sample=lambda _: (Hatched(points=corners, rising=rising),),
    )


def _image(_: Mark) -> Marks:
    a, b, c = -1j * HALF, WIDE - 1j * HALF, WIDE * 0.7 + 1j * HALF
    sides = tuple(Segment(a=p, b=q, role=Role.CONSTRUCTION) for p, q in ((a, b), (b, c), (c, a)))
    return (ImageOf(points=(a, b, c)), *sides)


def _passing(_: Mark) -> Marks:
    bar = Segment(a=0j, b=complex(WIDE), role=Role.LINK)
    return (bar, Passing(at=MIDDLE, along=1 + 0j), Point(at=MIDDLE, label="", dot=Dot.JOINT))


def _welded(_: Mark) -> Marks:
    at, up = MIDDLE - 1j * HALF, 1j * 2 * HALF
    bars = (Segment(a=at - WIDE / 2, b=at + WIDE / 2, role=Role.LINK), Segment(a=at, b=at + up, role=Role.LINK))
    return (*bars, Weld(at=at, u=1 + 0j, v=1j))


KNOWN = Kind(
    words=Words("已知矢量", "known vector"),
    met=lambda figure, mark: isinstance(mark, Vector) and mark.role is Role.GIVEN and _polygon(figure),
    sample=lambda _: _arrow(Role.GIVEN),
    black=True,
)
FOUND = Kind(
    words=Words("求得的矢量", "vector found"),
    met=lambda figure, mark: isinstance(mark, Vector) and mark.role is Role.RESULT and _polygon(figure),
    sample=lambda _: _arrow(Role.RESULT),
    black=True,
)
KINDS: tuple[Kind, ...] = (
    KNOWN,
    FOUND,
    Kind(
        words=Words("不计摩擦时的力", "force without friction"),
        met=lambda _, mark: isinstance(mark, Vector) and dash_of(key_of(mark)) is not Dash.FULL,
        sample=lambda mark: _arrow(Role.RESULT, key_of(mark)),
    ),
    Kind(
        words=Words("力的作用线", "line of action"),
        met=lambda _, mark: is_line_of_action(mark) and getattr(mark, "role", None) is Role.DIRECTION,
        sample=_line,
    ),
    Kind(
        words=Words("不计摩擦时的作用线", "the same without friction"),
        met=lambda _, mark: is_line_of_action(mark) and getattr(mark, "role", None) is Role.IDEAL,
        sample=_line,
    ),
    Kind(
        words=Words("构件的影像", "image of a link"),
        met=lambda _, mark: isinstance(mark, ImageOf) and _area(mark.points) > LEAST,
        sample=_image,
    ),
    Kind(
        words=Words("已知瞬心", "known centre"),
        met=lambda figure, mark: _in_centre_polygon(figure) and _traced(Role.GIVEN, Segment)(figure, mark),
        sample=_line,
    ),
    Kind(
        words=Words("待求瞬心", "centre to be found"),
        met=lambda figure, mark: _in_centre_polygon(figure) and _traced(Role.HIDDEN, Segment)(figure, mark),
        sample=_line,
    ),
    Kind(words=Words("实际廓线", "cam profile"), met=_profile(Role.LINK), sample=_line),
    Kind(words=Words("理论廓线", "pitch curve"), met=_profile(Role.HIDDEN), sample=_line),
    Kind(words=Words("机构的另一位置", "another position"), met=_traced(Role.OTHER, Segment), sample=_line),
    Kind(
        words=Words("平衡质量的方位", "place of a balancing mass"),
        met=lambda figure, mark: _of_rotor(figure) and _traced(Role.HIDDEN, Segment)(figure, mark),
        sample=_line,
    ),
    Kind(
        words=Words("被代换的高副", "higher pair replaced"),
        met=lambda figure, mark: figure.name == "low" and _traced(Role.HIDDEN, Arc)(figure, mark),
        sample=_line,
    ),
    Kind(words=Words("拐点圆", "inflection circle"), met=_on_curvature(Role.GIVEN, Arc), sample=_line),
    Kind(words=Words("曲率圆", "osculating circle"), met=_on_curvature(Role.HIDDEN, Arc), sample=_line),
    Kind(words=Words("其余各位置", "its other places"), met=_traced(Role.PLACE, Segment), sample=_line),
    Kind(words=Words("假想的连线", "imagined line"), met=_imagined, sample=_line),
    Kind(words=Words("节圆", "pitch circle"), met=lambda _, mark: isinstance(mark, GearMark), sample=_line, black=True),
    Kind(words=Words("轨迹圆、基准圆", "path or base circle"), met=_traced(Role.CENTRE, Arc), sample=_line),
    _hatched(True),
    _hatched(False),
    Kind(
        words=Words("摩擦圆", "friction circle"),
        met=lambda _, mark: isinstance(mark, FrictionCircle),
        sample=lambda _: (FrictionCircle(centre=MIDDLE, radius=HALF + 0.4), Point(at=MIDDLE, label="", dot=Dot.POLE)),
    ),
    Kind(words=Words("复合铰链", "multiple joint"), met=_dot(Dot.MULTIPLE), sample=_pinned(Dot.MULTIPLE)),
    Kind(
        words=Words("杆件连续，销在杆中", "bar runs on past the pin"),
        met=lambda _, mark: isinstance(mark, Passing),
        sample=_passing,
    ),
    Kind(words=Words("质心", "centre of mass"), met=_dot(Dot.MASS), sample=_pinned(Dot.MASS)),
    Kind(words=Words("固连为一体", "rigidly joined"), met=lambda _, mark: isinstance(mark, Weld), sample=_welded),
    Kind(
        words=Words("作图线", "construction line"),
        met=lambda _, mark: (
            isinstance(mark, Segment | Arc)
            and mark.role in (Role.DIRECTION, Role.CONSTRUCTION)
            and mark.owner != RING
            and not is_line_of_action(mark)
        ),
        sample=lambda _: (Segment(a=0j, b=complex(WIDE), role=Role.CONSTRUCTION),),
        plain=True,
    ),
)
