"""A link under three forces (三力汇交): known load, a reaction of known line, a third through their meeting point; ΣF = 0 closes the polygon."""

from __future__ import annotations

from ...board.construction import Pane, View
from ...board.marks import Dot, Role
from ...errors import NoMethodError
from ...mechanism.model import Joint, Prismatic, Revolute
from ...plane import Line, Points, cross, dot, nominal, unit
from ...vector.close import close
from ...vector.equation import Equation, Term
from ...words import Words
from .parallel_forces import PARALLEL, balance_parallel
from .pieces import Held
from .readings import write_sizes
from .resultant import Resultant
from .senses import inclined, pin_words, slide_words
from .state import Drawn, Statics

LETTERS = "abcdefghklmnqrstuvw"


def balance(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """Find the reaction of `by` (on its line) and of the parent on the held link."""
    link, number = held.link, st.mech.number(held.link)
    one, two, known = f"$R_{{{st.mech.number(by)}{number}}}$", f"$R_{{{st.mech.number(held.parent)}{number}}}$", load.symbols
    st.board.step(Words(f"取构件 {number}：在 {known.zh}、{one}、{two} 作用下平衡，作用线汇交于一点，即已知外力与 {one} 作用线的交点，{two} 过此点。",
                        f"Link {number} is in equilibrium under {known.en}, {one} and {two}, whose lines meet in one point: where the line of the known load meets that of {one}; {two} passes through it."), View.MECHANISM)
    if abs(float(nominal(cross(load.line.along, line.along)))) < PARALLEL:
        balance_parallel(st, held, load, line, by)
        return
    x = st.board.meet(load.line, line, f"link {number}: line of the load and line of R_{st.mech.number(by)}{number}")
    u, sense = direction_through(st, held.joint, held.parent, link, x)
    _draw(st, x, u, load.at, _touch(st, held.joint, x, u))
    polygon(st, held, load, (by, line.along, line.at), (u, x, sense))


def direction_through(st: Statics, joint: Joint, by: str, on: str, x: Points) -> tuple[Points, int]:
    """Direction of R_by,on through a point of its line, and the sense of its moment about the pin (0: none)."""
    i, j = st.mech.number(by), st.mech.number(on)
    towards = _ideal(st, by, on)
    if isinstance(joint, Prismatic):
        st.board.remark(slide_words(st, joint, by, on))
        return inclined(st, joint, by, on, towards if towards is not None else 1j * st.desk.guide_line(joint).along), 0
    if not isinstance(joint, Revolute):
        raise NoMethodError(f"no graphical method on file finds the reaction of links {i} and {j}: they roll on each other; 'vecpoly exact' still answers")
    st.board.remark(pin_words(st, joint.point, by, on))
    centre = st.desk.at[joint.point]
    sense = st.moment_sense(joint.point, by, on)
    ahead = towards if towards is not None else centre - x
    return st.board.tangent_from(x, centre, st.rho(joint.point), sense, ahead), sense


def polygon(st: Statics, held: Held, load: Resultant, known_line: tuple[str, Points, Points], through: tuple[Points, Points, int]) -> Pane:
    """ΣF = 0 with two unknown magnitudes; keeps both reactions."""
    (by, along, at), (u, x, sense) = known_line, through
    link, number = held.link, st.mech.number(held.link)
    one, two = st.named(by, link), st.named(held.parent, link)
    pane = st.polygon(number, Words(f"构件 {number} 的力多边形", f"Force polygon of link {number}"))
    terms = [Term(rel=f.named, symbol=f.named.symbol, direction=f.direction, magnitude=f.size, vector=f.vector, tip=LETTERS[i + 1]) for i, f in enumerate(load.forces)]
    terms += [Term(rel=one, symbol=one.symbol, direction=Words("作用线已知", "line known"), magnitude="?", along=along),
              Term(rel=two, symbol=two.symbol, direction=Words("过交点", "through the point"), magnitude="?", along=u)]
    eq = Equation(left=tuple(terms), right=())
    st.board.step(Words(f"构件 {number} 的力平衡方程，按 $μ_F$ 作力多边形（各力首尾相接）。", f"Equilibrium of link {number}; its polygon to $μ_F$, the forces head to tail."), pane)
    st.board.equate(eq.table())
    st.board.plot(pane, 0j, LETTERS[0], Dot.POINT)
    closed = close(st.board, pane, 0j, eq)
    n = len(load.forces)
    (start, corner), (_, end) = closed.ends[one.key], closed.ends[two.key]
    st.board.plot(pane, corner, LETTERS[n + 1], Dot.POINT)
    first = st.settle(by, link, corner - start, at, Drawn(place=pane, start=start, end=corner, letters=f"{LETTERS[n]} {LETTERS[n + 1]}"))
    other = st.settle(held.parent, link, end - corner, _touch(st, held.joint, x, u), Drawn(place=pane, start=corner, end=end, letters=f"{LETTERS[n + 1]} {LETTERS[0]}"), sense)
    st.board.remark(Words("由图量得：", " Measured:"))
    write_sizes(st, first, other)
    return pane


def _touch(st: Statics, joint: Joint, x: Points, u: Points) -> Points:
    """The point of the line nearest to the pin (where it touches the circle), or where it meets the guide."""
    if isinstance(joint, Revolute):
        return x + u * dot(u, st.desk.at[joint.point] - x)
    return x


def _draw(st: Statics, x: Points, u: Points, load_at: Points, touch: Points) -> None:
    """The meeting point, and the lines that pass through it, on the diagram: the reaction's from the meeting point to its pin."""
    if st.ideal is None and st.loads.friction:
        return
    board = st.board
    reach = float(nominal(dot(u, touch - x)))
    low, high = (min(0.0, reach) - 12.0, max(0.0, reach) + 12.0) if abs(reach) < 260.0 else (-22.0, 22.0)
    board.join(View.MECHANISM, x + u * low, x + u * high, Role.DIRECTION)
    if abs(nominal(load_at - x)) > 1.0:
        board.join(View.MECHANISM, load_at, x + unit(x - load_at) * 6.0, Role.DIRECTION)


def _ideal(st: Statics, by: str, on: str) -> Points | None:
    found = st.ideal.push(by, on) if st.ideal is not None else None
    return None if found is None else found.vector
