"""The kinds of line and symbol that a legend explains: how each is known, how its sample looks, what it stands for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from ...board.construction import Figure
from ...board.paper.marks import (
    Arc,
    Dot,
    FrictionCircle,
    GearMark,
    Hatched,
    ImageOf,
    Point,
    RackMark,
    Role,
    Segment,
    Vector,
    Weld,
)
from ...board.paper.tones import key_of
from ...words import Lang, Words
from ..beside import ASIDE, beside
from ..hues import dash_of
from ..labels.actions import is_line_of_action
from ..style import Dash
from ..symbols.around import RING
from .bodies import BODIES, CURVES
from .circles import FINE, ROUNDS, THIN, is_return_circle, of_rack, osculating
from .covered import is_centre_line, is_passing
from .entry import HALF, MIDDLE, WIDE, Entry, drawn_as_on
from .kind import Kind
from .met import (
    designed,
    dotted,
    has_lobes,
    in_axial_view,
    in_centre_polygon,
    in_polygon,
    is_lone_profile,
    is_other_position,
    is_other_solution,
    of_profile,
    of_rotor,
    on_curvature,
    osculates,
    to_counterweight,
    traced,
)
from .samples import arrow, image, line, passing, pinned, welded

LEAST, NARROW = 8.0, 1.0  # mm², mm: an image with a smaller area, or not as wide, is seen as a line


def _area(points: Sequence[complex]) -> float:
    """Of a polygon, mm²."""
    return abs(sum((a.conjugate() * b).imag for a, b in zip(points, (*points[1:], *points[:1]), strict=True))) / 2


def is_seen(image: Sequence[complex]) -> bool:
    """Whether the tint of an image shows between its sides."""
    return _area(image) > LEAST and _area(image) > NARROW * max(abs(a - b) for a, b in combinations(image, 2)) / 2


def kinds_met(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """An entry for each kind that these figures have, in the order of KINDS."""
    marks = [(figure, mark) for figure in figures for mark in figure.marks]
    for kind in KINDS:
        first = next(((figure, mark) for figure, mark in marks if kind.met(figure, mark)), None)
        if first is not None:
            figure, mark = first
            yield Entry(
                drawn_as_on(figure, kind.sample(mark), lang, black=kind.black), kind.words, kind.plain, kind.brief
            )


def side_by_side(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """Where vectors that lie on one line are drawn beside each other."""
    for figure in figures:
        if not figure.view.bodies and beside(figure.view, figure.marks) is not figure.marks:
            pair = tuple(Vector(a=1j * y, b=WIDE + 1j * y, role=Role.RESULT) for y in (ASIDE / 2, -ASIDE / 2))
            words = Words("并排的矢量实际共线", "drawn side by side, in fact collinear")
            yield Entry(drawn_as_on(figure, pair, lang, black=True), words)
            return


def _hatched(rising: bool) -> Kind:
    corners = (-1j * HALF, WIDE - 1j * HALF, WIDE + 1j * HALF, 1j * HALF)
    return Kind(
        words=Words("盈功", "surplus of work") if rising else Words("亏功", "deficit of work"),
        met=lambda figure, mark: isinstance(mark, Hatched) and mark.rising is rising and has_lobes(figure),
        sample=lambda _: (Hatched(points=corners, rising=rising),),
    )


KNOWN = Kind(
    words=Words("已知矢量", "known vector"),
    met=lambda figure, mark: isinstance(mark, Vector) and mark.role is Role.GIVEN and in_polygon(figure),
    sample=lambda _: arrow(Role.GIVEN),
    black=True,
)
FOUND = Kind(
    words=Words("求得的矢量", "vector found"),
    met=lambda figure, mark: isinstance(mark, Vector) and mark.role is Role.RESULT and in_polygon(figure),
    sample=lambda _: arrow(Role.RESULT),
    black=True,
)
KINDS: tuple[Kind, ...] = (
    KNOWN,
    FOUND,
    Kind(
        words=Words("不计摩擦时的力", "force without friction"),
        met=lambda _, mark: isinstance(mark, Vector) and dash_of(key_of(mark)) is not Dash.FULL,
        sample=lambda mark: arrow(Role.RESULT, key_of(mark)),
    ),
    Kind(
        words=Words("力的作用线", "line of action"),
        met=lambda _, mark: is_line_of_action(mark) and getattr(mark, "role", None) is Role.DIRECTION,
        sample=line,
    ),
    Kind(
        words=Words("不计摩擦时的作用线、力臂", "line of action or arm without friction"),
        met=traced(Role.IDEAL, Segment),
        sample=line,
    ),
    Kind(
        words=Words("构件的影像", "image of a link"),
        met=lambda figure, mark: isinstance(mark, ImageOf) and is_seen(mark.points) and figure.view.images,
        sample=image,
    ),
    Kind(
        words=Words("三弧围成的误差三角形", "triangle of error between the arcs"),
        met=lambda figure, mark: isinstance(mark, ImageOf) and is_seen(mark.points) and not figure.view.images,
        sample=image,
        brief=Words("误差三角形", "triangle of error"),
    ),
    Kind(
        words=Words("已知瞬心", "known centre"),
        met=lambda figure, mark: in_centre_polygon(figure) and traced(Role.GIVEN, Segment)(figure, mark),
        sample=line,
    ),
    Kind(
        words=Words("待求瞬心", "centre to be found"),
        met=lambda figure, mark: in_centre_polygon(figure) and traced(Role.HIDDEN, Segment)(figure, mark),
        sample=line,
    ),
    Kind(words=Words("实际廓线", "cam profile"), met=of_profile(Role.LINK), sample=line),
    Kind(words=Words("凸轮廓线", "profile of the cam"), met=is_lone_profile, sample=line),
    Kind(words=Words("理论廓线", "pitch curve"), met=of_profile(Role.HIDDEN), sample=line),
    Kind(
        words=Words("机构的另一位置", "another position"),
        met=is_other_position,
        sample=line,
        brief=Words("另一位置", "another position"),
    ),
    Kind(words=Words("给定位置", "given position"), met=designed(Role.GIVEN, given=True), sample=line),
    Kind(words=Words("给定的其余位置", "other given positions"), met=designed(Role.HIDDEN, given=True), sample=line),
    Kind(words=Words("另一解", "other solution"), met=is_other_solution, sample=line),
    Kind(words=Words("舍去的解", "solution rejected"), met=designed(Role.HIDDEN, given=False), sample=line),
    Kind(
        words=Words("平衡质量的方位", "position of a balancing mass"),
        met=lambda figure, mark: of_rotor(figure) and traced(Role.HIDDEN, Segment)(figure, mark),
        sample=line,
    ),
    Kind(
        words=Words("被代换的高副", "higher pair replaced"),
        met=lambda figure, mark: figure.name == "low" and traced(Role.HIDDEN, Arc)(figure, mark),
        sample=line,
    ),
    Kind(words=Words("拐点圆", "inflection circle"), met=on_curvature(Role.GIVEN, Arc), sample=line),
    Kind(words=Words("回归圆", "return circle"), met=is_return_circle, sample=line),
    Kind(words=Words("曲率圆", "osculating circle"), met=osculating, sample=line),
    Kind(words=Words("齿条依次的位置", "successive positions of the rack"), met=of_rack(generating=True), sample=line),
    Kind(words=Words("其余各位置", "other positions"), met=of_rack(generating=False), sample=line),
    Kind(words=Words("校正平面", "correction plane"), met=in_axial_view, sample=line),
    Kind(words=Words("配重的方位", "position of a counterweight"), met=to_counterweight, sample=line),
    *FINE,
    Kind(
        words=Words("节圆、节线", "pitch circle or line"),
        met=lambda _, mark: isinstance(mark, GearMark | RackMark),
        sample=line,
        black=True,
        brief=Words("节圆", "pitch circle"),
    ),
    *ROUNDS,
    *CURVES,
    *THIN,
    _hatched(True),
    _hatched(False),
    Kind(
        words=Words("摩擦圆", "friction circle"),
        met=lambda _, mark: isinstance(mark, FrictionCircle),
        sample=lambda _: (FrictionCircle(centre=MIDDLE, radius=HALF + 0.4), Point(at=MIDDLE, label="", dot=Dot.POLE)),
    ),
    Kind(words=Words("复合铰链", "multiple joint"), met=dotted(Dot.MULTIPLE), sample=pinned(Dot.MULTIPLE)),
    Kind(words=Words("杆件连续，销在杆中", "bar runs on past the pin"), met=is_passing, sample=passing),
    Kind(words=Words("质心", "centre of mass"), met=dotted(Dot.MASS), sample=pinned(Dot.MASS)),
    *BODIES,
    Kind(words=Words("固连为一体", "rigidly joined"), met=lambda _, mark: isinstance(mark, Weld), sample=welded),
    Kind(
        words=Words("作图线", "construction line"),
        met=lambda figure, mark: (
            isinstance(mark, Segment | Arc)
            and mark.role in (Role.DIRECTION, Role.CONSTRUCTION)
            and mark.owner != RING
            and not is_line_of_action(mark)
            and not osculates(figure, mark)
        ),
        sample=lambda _: (Segment(a=0j, b=complex(WIDE), role=Role.CONSTRUCTION),),
        plain=True,
    ),
    Kind(
        words=Words("中心线、基准线", "centre or reference line"),
        met=is_centre_line,
        sample=line,
        plain=True,
        brief=Words("中心线", "centre line"),
    ),
)
