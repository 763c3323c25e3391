"""A link under three forces (三力汇交): known load, a reaction of known line,
a third through their meeting point; ΣF = 0 closes the polygon."""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....errors import NoMethodError
from ....mechanism.model import Joint, Prismatic, Revolute
from ....plane import Line, Points, cross, foot, lines_meet, nominal
from ....vector.equation import Term
from ....words import Words
from ..bodies.link_polygon import draw_polygon, pane_of
from ..readings import say_measured, write_sizes
from ..senses import at_normal, inclined, pin_words, slide_words
from ..state import Statics
from .links_of_group import Held
from .meeting import draw_meeting, draw_resultant, known_forces, line_of_load, meeting_letter, resultant_of
from .parallel_forces import PARALLEL, balance_parallel, off_sheet
from .resultant import Resultant

KNOWN = Words("作用线已知", "line of action known")


def balance(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """Find the reaction of `by` (on its line) and of the parent on the held link."""
    link = held.link
    parallel = abs(float(nominal(cross(load.line.along, line.along)))) < PARALLEL
    if parallel or (isinstance(held.joint, Revolute) and off_sheet(load, line, st.desk.at[held.joint.point])):
        balance_parallel(st, held, load, line, by)
        return
    letter = meeting_letter(st, lines_meet(load.line, line), line.at)
    st.board.step(_taken(st, held, load, line, by, letter), View.MECHANISM)
    if not (pin := _pin(st, held, load, line)):  # what passes through a pin is not joined first
        draw_resultant(st, link, load)
    x = st.desk.at[pin] if pin else _meeting(st, held, load, line, by)
    u, sense = direction_through(st, held.joint, held.parent, link, x)
    lettered = "" if pin else letter
    draw_meeting(
        st,
        x,
        (line_of_load(load), (st.named(by, link), line.at)),
        (u, st.at_joint(held.joint, Line(x, u))),
        (lettered, st.named(held.parent, link)),
    )
    polygon(st, held, load, (by, line.along, line.at), (u, x, sense), pin or letter)


def _meeting(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> Points:
    """Where the lines of the load and of the reaction of `by` meet."""
    number, key = st.mech.number(held.link), st.named(by, held.link).key
    what = Words(f"构件 {number}：载荷与 {key} 的作用线", f"link {number}: line of the load and line of {key}")
    return st.board.meet(load.line, line, what)


def _taken(st: Statics, held: Held, load: Resultant, line: Line, by: str, letter: str) -> Words:
    """Three forces balance: they meet in one point, which may be a pin already; several known ones are joined first."""
    number, one, two = (
        st.mech.number(held.link),
        f"${st.named(by, held.link).symbol}$",
        f"${st.named(held.parent, held.link).symbol}$",
    )
    if pin := _pin(st, held, load, line):
        known = load.symbols
        return Words(
            f"取构件 {number} 为分离体：{known.zh}、{one}、{two} 平衡；{known.zh}、{one} 均过 ${pin}$，"
            f"故 {two} 必过 ${pin}$。",
            f"Isolate link {number}: {known.en}, {one} and {two} are in equilibrium; {known.en} "
            f"and {one} pass through ${pin}$, so {two} must pass through it too.",
        )
    known, single = known_forces(st, held.link, load), load.is_single
    short = known if single else Words.same(f"${resultant_of(st, held.link)}$")
    spot = f" ${letter}$" if letter else ""
    point = Words(spot or "此点", spot.strip() or "this point")
    where = f"in{spot}" if spot else "in one point"
    return Words(
        f"取构件 {number} 为分离体：受{' ' if single else ''}{known.zh}、{one}、{two} 三力而平衡，"
        f"三力必汇交于一点；先求 {short.zh} 与 {one} 作用线的交点{spot}，{two} 过{point.zh}。",
        f"Isolate link {number}: three forces, {known.en}, {one} and {two}, are in equilibrium and "
        f"therefore concurrent: the lines of {short.en} and {one} "
        f"meet {where}; {two} passes through {point.en}.",
    )


def _pin(st: Statics, held: Held, load: Resultant, line: Line) -> str:
    """The letter of the pin through which the lines of the load and of the reaction of known line both pass, if they
    do: both start there, or the load does, and the reaction at a contact lies along a normal through that point."""
    aside = float(nominal(cross(line.along, load.at - line.at)))
    return _pin_at(st, held.link, load.at) if abs(aside) < NO_LENGTH else ""


def _pin_at(st: Statics, link: str, at: Points) -> str:
    """The letter of the link's point here, if it has one."""
    return next((p for p in st.mech.link(link).points if abs(complex(nominal(st.desk.at[p] - at))) < NO_LENGTH), "")


def direction_through(st: Statics, joint: Joint, by: str, on: str, x: Points) -> tuple[Points, int]:
    """Direction of R_by,on through a point of its line, and the sense of its moment about the pin (0: none)."""
    i, j = st.mech.number(by), st.mech.number(on)
    if isinstance(joint, Prismatic):
        st.board.remark(slide_words(st, joint, by, on))
        return inclined(st, joint, by, on), 0
    if not isinstance(joint, Revolute):
        raise NoMethodError(
            Words(
                f"没有求构件 {i} 与 {j} 间反力的图解法，因为两者作纯滚动；仍可用 vecpoly exact 求解",
                f"no graphical method on file finds the reaction of links {i} and {j}: they roll on each other; "
                "'vecpoly exact' still answers",
            )
        )
    centre = st.desk.at[joint.point]
    sense = st.moment_sense(joint.point, by, on)
    before = st.pushed_before(by, on)
    u = st.board.tangent_from(
        x, centre, st.rho(joint.point), sense, centre - x if before is None else before, key=st.named(by, on).key
    )
    st.board.remark(pin_words(st, joint.point, by, on, foot(Line(x, u), centre)))
    return u, sense


def polygon(
    st: Statics,
    held: Held,
    load: Resultant,
    known_line: tuple[str, Points, Points],
    through: tuple[Points, Points, int],
    meets: str = "",
) -> None:
    """ΣF = 0 with two unknown magnitudes; keeps both reactions. meets: the letter of the point of concurrency."""
    (by, along, at), (u, x, sense) = known_line, through
    link, number = held.link, st.mech.number(held.link)
    one, two = st.named(by, link), st.named(held.parent, link)
    st.board.step(
        Words(
            f"列构件 {number} 的力平衡方程，按 $μ_F$ 作力多边形，各力首尾相接。",
            f"Write the equilibrium of link {number} and draw its polygon to $μ_F$, the forces head to tail.",
        ),
        pane_of(st, link),
    )
    drawn = draw_polygon(
        st,
        link,
        load,
        (
            Term(rel=one, symbol=one.symbol, direction=KNOWN, magnitude="?", along=along),
            Term(rel=two, symbol=two.symbol, direction=_lies(st, held, meets), magnitude="?", along=u),
        ),
    )
    side, last = drawn[one.key], drawn[two.key]
    first = st.settle(by, link, side.end - side.start, at, side)
    other = st.settle(held.parent, link, last.end - last.start, st.at_joint(held.joint, Line(x, u)), last, sense)
    say_measured(st, ((one.symbol, side), (two.symbol, last)))
    write_sizes(st, first, other)


def _lies(st: Statics, held: Held, meets: str) -> Words:
    """What is known of the line of the parent's reaction."""
    through = Words(
        f"过 ${meets}$" if meets else "过交点", f"through ${meets}$" if meets else "through the meeting point"
    )
    if isinstance(held.joint, Prismatic):
        return at_normal(st, held.joint)
    if isinstance(held.joint, Revolute) and st.rho(held.joint.point):
        return through + Words("，切于摩擦圆", ", tangent to the circle")
    return through
