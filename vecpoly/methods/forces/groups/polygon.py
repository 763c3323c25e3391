"""One force polygon for a whole class II group: both links' forces in turn, then the reactions;
every reaction is a side or a diagonal.

Vertices: the polygon starts with R^t of link j's parent, goes on with the forces of link j (to J), the forces of link k
and R^t of its parent (to K), and meets in the corner X.
Then R_pj joins X to the end of its R^t, R_kj joins J to X, and R_qk is the rest.
"""

from __future__ import annotations

from collections.abc import Sequence

from ....algebra.formula import sym
from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....mechanism.groups.assur import Dyad
from ....plane import Points, nominal
from ....vector.close import close
from ....vector.equation import Equation, Term
from ....words import Words
from ..acting import NO_LETTER, Acting, Drawn
from ..bodies.link_polygon import corner_letters
from ..lines.arms import acting_on
from ..readings import SAME, measured, say_measured
from ..state import Statics
from .body import polygon_title
from .corners import Corners, Reaction


def draw_group(st: Statics, d: Dyad, first: Reaction, last: Reaction) -> Corners:
    """ΣF = 0 of the whole group, closed by the two outer reactions; keeps nothing yet."""
    if _free(st, d, first, last):
        return _nothing(st, d)
    pane = _begin(st, d, d.link_j, d.link_k)
    letters = corner_letters(st, pane)
    lead = first.found(st, letters[1])
    terms = [*lead, *_forces(st, letters, d.link_j, len(lead))]
    at_j = len(terms)
    terms += _forces(st, letters, d.link_k, at_j)
    terms += last.found(st, letters[len(terms) + 1])
    eq = Equation(left=(*terms, last.sought(st), first.sought(st)))
    vertices, x = closed(st, pane, letters, eq, terms)
    n = len(terms)
    at_k, corner_x = n - len(last.found(st, "")), (letters[n + 1], x)
    return Corners(
        pane=pane,
        p=(corner_x, (letters[len(lead)], vertices[len(lead)])),
        j=(letters[at_j], vertices[at_j]),
        k=(letters[at_k], vertices[at_k]),
        x=corner_x,
    )


def draw_link_j(st: Statics, d: Dyad, first: Reaction, inner: Reaction) -> Corners:
    """ΣF = 0 of link j alone, closed by R_kj and R_pj; then the forces of link k from J."""
    if _free(st, d, first):
        return _nothing(st, d)
    pane = _begin(st, d, d.link_j)
    letters = corner_letters(st, pane)
    lead = first.found(st, letters[1])
    terms = [*lead, *_forces(st, letters, d.link_j, len(lead))]
    vertices, x = closed(st, pane, letters, Equation(left=(*terms, inner.sought(st), first.sought(st))), terms)
    n = len(terms)
    corner_j, corner_x = (letters[n], vertices[n]), (letters[n + 1], x)
    corner_k = _carry_on(st, pane, letters, (d.link_j, d.link_k, d.parent_k), corner_j, n + 1)
    return Corners(
        pane=pane, p=(corner_x, (letters[len(lead)], vertices[len(lead)])), j=corner_j, k=corner_k, x=corner_x
    )


def draw_link_k(st: Statics, d: Dyad, inner: Reaction, last: Reaction) -> Corners:
    """ΣF = 0 of link k alone, from J over its forces to K, closed by R_qk and R_jk;
    then the forces of link j, which end in J."""
    if _free(st, d):
        return _nothing(st, d)
    pane = _begin(st, d, d.link_k)
    letters = corner_letters(st, pane)
    terms = _forces(st, letters, d.link_k, 0)
    vertices, x = closed(st, pane, letters, Equation(left=(*terms, last.sought(st), inner.sought(st))), terms)
    n = len(terms)
    end = _carry_on(st, pane, letters, (d.link_k, d.link_j, d.parent_j), (letters[n + 1], x), n + 1)
    return Corners(
        pane=pane, p=(end, (letters[0], 0j)), j=(letters[0], 0j), k=(letters[n], vertices[n]), x=(letters[n + 1], x)
    )


def _free(st: Statics, d: Dyad, *outer: Reaction) -> bool:
    """Whether no known force acts on the group, but couples at most."""
    return not acting_on(st, d.link_j) and not acting_on(st, d.link_k) and not any(one.part for one in outer)


def _nothing(st: Statics, d: Dyad) -> Corners:
    """No polygon: two unknown forces of different directions sum to zero only where both are zero."""
    numbers = "、".join(map(st.mech.number, (d.link_j, d.link_k)))
    st.board.step(
        Words(
            f"构件 {numbers} 上无已知力作用（至多有力偶）；两个方向不同的未知反力之和为零，故二者皆为零。",
            f"No known force acts on links {numbers.replace('、', ' and ')}, but couples at "
            "most; two unknown forces of different directions sum to zero only if both are "
            "zero.",
        )
    )
    pane, none = (
        st.polygon(f"{st.mech.number(d.link_j)}-{st.mech.number(d.link_k)}", polygon_title(st, d.link_j, d.link_k)),
        (NO_LETTER, 0j),
    )
    return Corners(pane=pane, p=(none, none), j=none, k=none, x=none)


def reactions(st: Statics, d: Dyad, corners: Corners) -> tuple[Drawn, Drawn, Drawn]:
    """R_pj, R_kj and R_qk as sides and diagonals of the polygon, named in the step."""
    names = [
        st.named(by, on).symbol for by, on in ((d.parent_j, d.link_j), (d.link_k, d.link_j), (d.parent_k, d.link_k))
    ]
    found = corners.side(*corners.p), corners.side(corners.j, corners.x), corners.side(corners.k, corners.x)
    if corners.x[0] != NO_LETTER:
        say_measured(st, tuple(zip(names, found, strict=True)))
    for drawn, by, on in zip(found, (d.parent_j, d.link_k, d.parent_k), (d.link_j, d.link_j, d.link_k), strict=True):
        name_side(st, drawn, by, on)
    return found


def name_side(st: Statics, drawn: Drawn, by: str, on: str) -> None:
    """Draw a reaction on the polygon and write what is measured between its letters."""
    named = st.named(by, on)
    start, end = complex(nominal(drawn.start)), complex(nominal(drawn.end))
    if abs(end - start) < SAME:
        return
    if not st.board.stands(drawn.place, start, end):
        st.board.arrow(drawn.place, drawn.start, drawn.end, Role.RESULT, key=named.key, label=named.symbol)
    if drawn.laid is None:
        st.board.write_worked(sym(named.symbol), measured(st, drawn), "N")


def _begin(st: Statics, d: Dyad, *alone: str) -> Pane:
    pane = st.polygon(f"{st.mech.number(d.link_j)}-{st.mech.number(d.link_k)}", polygon_title(st, d.link_j, d.link_k))
    links, links_en = "、".join(map(st.mech.number, alone)), " and ".join(map(st.mech.number, alone))
    st.board.step(
        Words(
            f"列构件 {links} 的力平衡方程，按 $μ_F$ 作力多边形，各力首尾相接。",
            f"Write the equilibrium of link{'s' if len(alone) > 1 else ''} {links_en} and draw the polygon to "
            "$μ_F$, the forces head to tail.",
        ),
        pane,
    )
    st.board.plot(pane, 0j, corner_letters(st, pane)[0], Dot.POINT)
    return pane


def _forces(st: Statics, letters: Sequence[str], link: str, after: int) -> list[Term]:
    return [term_of(force, letters[after + i + 1]) for i, force in enumerate(acting_on(st, link))]


def term_of(force: Acting, tip: str) -> Term:
    """A known force as a side of the polygon."""
    return Term(
        rel=force.named,
        symbol=force.named.symbol,
        direction=force.direction,
        magnitude=force.size,
        vector=force.vector,
        tip=tip,
    )


def closed(
    st: Statics, pane: Pane, letters: Sequence[str], eq: Equation, terms: list[Term]
) -> tuple[list[Points], Points]:
    """All vertices of the known chain, and the corner."""
    st.board.equate(eq.table())
    letter = letters[len(terms) + 1]
    closed = close(st.board, pane, 0j, eq, corner=letter)
    corner = closed.ends[eq.left[-1].rel.key][0]
    st.board.plot(pane, corner, letter)
    return [0j, *(closed.ends[term.rel.key][1] for term in terms)], corner


def _carry_on(
    st: Statics, pane: Pane, letters: Sequence[str], links: tuple[str, str, str], start: tuple[str, Points], used: int
) -> tuple[str, Points]:
    """Lay the known forces of the other link off, from a corner: links are that whose polygon is closed, the other one,
    and its neighbour outside, whose reaction closes."""
    letter, here = start
    forces = acting_on(st, links[1])
    if forces:
        _say_other(st, links, forces, letter, letters[used + len(forces)])
    for i, force in enumerate(forces):
        tip = here + st.board.hand.carry_vector(force.vector)
        st.board.arrow(pane, here, tip, Role.GIVEN)
        letter, here = letters[used + i + 1], tip
        st.board.plot(pane, here, letter)
    return letter, here


def _say_other(st: Statics, links: tuple[str, str, str], forces: Sequence[Acting], start: str, end: str) -> None:
    """ΣF = 0 of the other link, on the same polygon: what the first does to it is known, one reaction is sought."""
    (closed_link, link, outside), number = links, st.mech.number(links[1])
    sought = st.named(outside, link).symbol
    symbols = (st.named(closed_link, link).symbol, *(force.named.symbol for force in forces), sought)
    sum_zero = f"{' + '.join(f'${symbol}$' for symbol in symbols)} = 0"
    st.board.remark(
        Words(
            f"再列构件 {number} 的力平衡方程 {sum_zero}，力多边形由 ${start}$ 续作：依次作构件 {number} 的已知力，至 "
            f"${end}$，封闭边即 ${sought}$。",
            f" Then write the equilibrium of link {number}, {sum_zero}, and go on with the polygon from ${start}$: lay "
            f"off the known forces of link {number}, to ${end}$; the side that closes is ${sought}$.",
        )
    )
