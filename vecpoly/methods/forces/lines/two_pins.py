"""A link with two pins and no load (二力杆): one line of action, tangent to both friction circles."""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.model import Revolute
from ....names import Named
from ....plane import Line, Points, dot, foot, nominal, unit
from ....words import Words
from ...registry import Stage, method
from ..senses import pin_words
from ..state import Statics
from .links_of_group import TwoForce

_SOURCE = "机械原理, friction circle; the two-force link"


@method(
    stage=Stage.FORCE,
    group="two-force link R-R",
    source=_SOURCE,
    example="4-3a",
    title=Words("二力杆：作用线切于两摩擦圆", "Two-force link: its line touches both friction circles"),
)
def line_of_two_pins(st: Statics, two: TwoForce) -> Line:
    """Line of the force of the link on the loaded link, along that force.

    Without friction the line passes through both pins. With friction the reaction at each pin has a moment about it
    against the relative turning there; of the four common tangents of the friction circles this leaves one.
    """
    assert isinstance(two.inner, Revolute) and isinstance(two.outer, Revolute)
    p, q = two.inner.point, two.outer.point
    at_p, at_q = st.desk.at[p], st.desk.at[q]
    board = st.board
    if st.ideal is None:
        return _without_friction(st, two, (p, q))
    on = _exerted(st.ideal, two)
    if abs(complex(nominal(on))) < NO_LENGTH and _overlap(st, two, (p, q)):
        return _passing_nothing(st, two, (p, q))
    compressed = float(nominal(dot(on, at_p - at_q))) > 0
    board.step(_pressed(st, two, compressed, (p, q)), View.MECHANISM)
    line = board.tangent_to_both(
        at_p,
        st.rho(p),
        st.moment_sense(p, two.on, two.link),
        at_q,
        st.rho(q),
        st.moment_sense(q, two.by, two.link),
        1 if compressed else -1,
        key=st.named(two.on, two.link).key,
    )
    board.remark(pin_words(st, q, two.by, two.link, foot(line, at_q)))
    board.remark(pin_words(st, p, two.on, two.link, line.at))
    board.remark(_tangent(st, (p, st.moment_sense(p, two.on, two.link)), (q, st.moment_sense(q, two.by, two.link))))
    _draw(st, line, (at_p, at_q), st.named(two.on, two.link))
    return Line(line.at, -line.along)


def _without_friction(st: Statics, two: TwoForce, pins: tuple[str, str]) -> Line:
    """The line through both pins; on the diagram where that with friction will stand beside it."""
    at_p, at_q = (st.desk.at[pin] for pin in pins)
    number, bar = st.mech.number(two.link), st.desk.bar(two.link, *pins)
    st.board.step(
        Words(
            f"构件 {number} 不受外力，为二力杆，两端反力等值、反向、共线，沿 ${bar}$。",
            f"No load acts on link {number}: it is a two-force link, and the equal and "
            f"opposite forces at its pins act along ${bar}$.",
        ),
        View.MECHANISM,
    )
    line = Line(at_p, unit(at_p - at_q))
    if st.preliminary:
        _draw(st, line, (at_p, at_q), st.named(two.on, two.link))
    return line


def _overlap(st: Statics, two: TwoForce, pins: tuple[str, str]) -> bool:
    """Whether the friction circles have no common tangent against the turning at both pins."""
    (p, q), senses = pins, (st.moment_sense(pins[0], two.on, two.link), st.moment_sense(pins[1], two.by, two.link))
    arms = senses[0] * st.rho(p) + senses[1] * st.rho(q)
    return abs(arms) >= abs(complex(nominal(st.desk.at[q] - st.desk.at[p])))


def _passing_nothing(st: Statics, two: TwoForce, pins: tuple[str, str]) -> Line:
    """The line through both pins, of a link that passes on no force: where nothing presses friction locks nothing.

    Where a force is found along it after all the next round knows its sense, and that there is no tangent.
    """
    number, bar, symbol = st.mech.number(two.link), st.desk.bar(two.link, *pins), st.named(two.link, two.on).symbol
    st.board.step(
        Words(
            f"构件 {number} 不受外力，为二力杆。摩擦圆过大，无公切线，不能传力；而此处也不须传力：作用线取 ${bar}$，"
            f"得 ${symbol}$ = 0，两端无压力，亦无摩擦。",
            f"No load acts on link {number}: it is a two-force link. With friction as large as here no line touches as "
            f"both ends ask, and it could pass on no force; but none is asked of it: along ${bar}$ one finds "
            f"${symbol}$ = 0, and where nothing presses nothing rubs.",
        ),
        View.MECHANISM,
    )
    at_p, at_q = (st.desk.at[pin] for pin in pins)
    return Line(at_p, unit(at_p - at_q))


def _exerted(st: Statics, two: TwoForce) -> Points:
    """The force of the link on the loaded one in a finished pass:
    it pushes away from the far pin where the link is compressed."""
    found = st.push(two.link, two.on)
    return 0j if found is None else found.vector


def _pressed(st: Statics, two: TwoForce, compressed: bool, pins: tuple[str, str]) -> Words:
    """Whether the link is pressed or pulled, and how one knows."""
    number, bar, (p, q) = st.mech.number(two.link), st.desk.bar(two.link, *pins), pins
    first = st.without_friction
    symbol, before = first.named(two.link, two.on).symbol, _exerted(first, two)
    state, state_en = ("压", "compression") if compressed else ("拉", "tension")
    start, end = (q, p) if compressed else (p, q)
    if (
        abs(nominal(before)) > NO_LENGTH
        and (float(nominal(dot(before, st.desk.at[p] - st.desk.at[q]))) > 0) == compressed
    ):
        return Words(
            f"构件 {number} 不受外力，为二力杆；由不计摩擦时的分析，${symbol}$ 由 ${start}$ 指向 ${end}$，"
            f"知杆 ${bar}$ 受{state}。",
            f"No load acts on link {number}: it is a two-force link. Without friction ${symbol}$ "
            f"points from ${start}$ to ${end}$, so ${bar}$ is in {state_en}.",
        )
    return Words(
        f"构件 {number} 不受外力，为二力杆；计入摩擦后试作知杆 ${bar}$ 受{state}。",
        f"No load acts on link {number}: it is a two-force link. With friction a trial shows ${bar}$ in {state_en}.",
    )


def _tangent(st: Statics, one: tuple[str, int], two: tuple[str, int]) -> Words:
    """Which common tangent it is: the forces at the ends are opposite,
    so equal senses of their moments mean opposite sides."""
    (p, sense_p), (q, sense_q) = one, two
    if sense_p and sense_q:
        kind, kind_en = ("内", "inner") if sense_p == sense_q else ("外", "outer")
        same, same_en = ("同", "the same sense") if sense_p == sense_q else ("反", "opposite senses")
        return Words(
            f"两端反力等值、反向、共线，对各自铰链中心之矩{same}向，故作用线为两摩擦圆的{kind}公切线。",
            f" The two forces are equal, opposite and in one line, with moments of {same_en}: the "
            f"line is the {kind_en} common tangent of the two circles.",
        )
    centre, circle = (q, p) if sense_p else (p, q)
    if not sense_p and not sense_q:
        return Words(
            f"两端无摩擦，作用线过 ${p}$、${q}$。",
            f" Without friction at both ends the line passes through ${p}$ and ${q}$.",
        )
    return Words(
        f"故作用线过 ${centre}$，切于 ${circle}$ 处摩擦圆。",
        f" So the line passes through ${centre}$ and touches the circle at ${circle}$.",
    )


def _draw(st: Statics, line: Line, pins: tuple[Points, Points], named: Named) -> None:
    """The tangent on the diagram, a little longer than the link."""
    ends = [foot(line, pin) for pin in pins]
    over = unit(ends[1] - ends[0]) * 12.0
    st.board.join(View.MECHANISM, ends[0] - over, ends[1] + over, st.ruled(Role.DIRECTION), key=named.key)
    st.board.plot(View.MECHANISM, ends[1] + over, named.symbol, Dot.NONE, key=named.key)
