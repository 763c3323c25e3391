"""Closing a vector polygon: the four classical cases, written once for velocities, accelerations, forces and products.

Two magnitudes unknown: line ∩ line. Magnitude and direction of one vector: the closing side. Two directions: arc ∩ arc.
One magnitude and one direction: line ∩ arc.
"""

from __future__ import annotations

from collections.abc import Callable

from ..board.board import Board
from ..board.paper.marks import Role
from ..board.place import Place
from ..errors import DeadPointError, EquilibriumError, bilingual
from ..foundation.indices import ON_LINE
from ..foundation.slotted import dataclass
from ..names import At, Kind, Named, Rel
from ..plane import Line, Points, nominal, unit
from ..words import Words
from .equation import Equation, Term

RIGHT_ANGLE_FROM = 6.0  # mm: shorter sides carry no mark
NO_ARROW = 1e-6  # mm: shorter vectors are not drawn

Choice = Callable[[Points, Points], Points]
Ends = dict[str, tuple[Points, Points]]


@dataclass(frozen=True, slots=True)
class Closed:
    """Where every term starts and ends on the polygon, by its key; and where the two chains meet."""

    ends: Ends
    meeting: Points


def close(
    board: Board,
    view: Place,
    pole: Points,
    eq: Equation,
    choose: Choice | None = None,
    *,
    to: str = "",
    of: At | None = None,
    corner: str = "",
) -> Closed:
    """Draw the equation as a polygon from the pole (without a right side: back to it); gives the ends of its vectors.

    choose: which of two arc meetings is meant (cases with an unknown direction).
    to: the letter of the point where the chains meet; of: the point of the mechanism for which it stands;
    corner: the letter of the point between two unknown vectors of one side.
    """
    ends: Ends = {}
    left, open_left = _known_chain(board, view, pole, eq.left, ends)
    right, open_right = _known_chain(board, view, pole, eq.right, ends)
    unknown = [(t, True) for t in open_left] + [(t, False) for t in open_right]
    if len(unknown) == 1:
        return _closing_side(board, view, left, right, unknown[0], ends, to, of)
    (one, on_left), (two, also_left) = unknown
    if on_left == also_left:  # both at the end of one side: walk to the other side's end
        start, meeting = (left, right) if on_left else (right, left)
        at = _corner(board, view, (one, start), (two, meeting), str(eq), choose)
        if corner:
            at = board.locate(view, corner, at)
        ends[one.rel.key], ends[two.rel.key] = (start, at), (at, meeting)
    else:
        at = _corner(board, view, (one, left), (two, right), str(eq), choose)
        if to:
            at = board.locate(view, to, at, of)
        ends[one.rel.key], ends[two.rel.key] = (left, at), (right, at)
        meeting = at
    for term, _ in unknown:
        _arrow(board, view, term, ends, Role.RESULT)
        _right_angle(board, view, term, ends)
    return Closed(ends, meeting)


def _right_angle(board: Board, view: Place, term: Term, ends: Ends) -> None:
    """Mark the right angle between a normal and the tangential component that follows it."""
    if isinstance(term.rel, Named) or term.rel.kind is not Kind.AT:
        return
    normal = ends.get(Rel(Kind.AN, term.rel.to, term.rel.ref).key)
    if normal is None:
        return
    (foot, corner), (tail, head) = ends[term.rel.key], normal
    if abs(nominal(head - foot)) > NO_ARROW:
        return  # another term stands between the two
    if min(abs(nominal(corner - foot)), abs(nominal(tail - foot))) > RIGHT_ANGLE_FROM:
        board.right_angle(view, foot, unit(tail - foot), unit(corner - foot))


def _arrow(board: Board, view: Place, term: Term, ends: Ends, role: Role) -> None:
    """Draw the vector; a force carries its symbol, a velocity or an acceleration is told by its letters."""
    start, end = ends[term.rel.key]
    board.arrow(view, start, end, role, key=term.key, label=term.symbol if isinstance(term.rel, Named) else "")


def _known_chain(
    board: Board, view: Place, pole: Points, chain: tuple[Term, ...], ends: Ends
) -> tuple[Points, list[Term]]:
    """Lay the known terms of one side tip to tail; the unknown ones wait."""
    here, waiting = pole, []
    for term in chain:
        if term.unknowns:
            waiting.append(term)
            continue
        if term.vector is not None:
            tip = _gone_along(board, view, here, term.vector, term)
        else:
            assert term.along is not None and term.mm is not None
            tip = board.lay_off(here, term.along, term.mm, key=term.key)
        if term.tip and not term.drawn:
            tip = board.locate(view, term.tip, tip)
        ends[term.rel.key] = (here, tip)
        if not term.drawn:
            _arrow(board, view, term, ends, Role.GIVEN)
        here = tip
        if term.tip:
            board.plot(view, here, term.tip)
    return here, waiting


def _gone_along(board: Board, view: Place, here: Points, vector: Points, term: Term) -> Points:
    """The end of a known vector: of one that stands there already, or is carried over as a whole."""
    if term.drawn:
        return board.follow(view, here, vector, term.key)
    return here + board.transfer(view, vector, term.key)


def _closing_side(
    board: Board,
    view: Place,
    left: Points,
    right: Points,
    unknown: tuple[Term, bool],
    ends: Ends,
    to: str,
    of: At | None,
) -> Closed:
    """One vector unknown altogether: it joins the ends of the two chains."""
    term, on_left = unknown
    if to:
        end = board.locate(view, to, right if on_left else left, of)
        left, right = (left, end) if on_left else (end, right)
    ends[term.rel.key] = (left, right) if on_left else (right, left)
    _arrow(board, view, term, ends, Role.RESULT)
    return Closed(ends, right if on_left else left)


def _corner(
    board: Board, view: Place, one: tuple[Term, Points], two: tuple[Term, Points], what: str, choose: Choice | None
) -> Points:
    """The common corner of the two unknown vectors drawn from their known ends."""
    (t1, p1), (t2, p2) = one, two
    if t1.along is not None and t2.along is not None:
        g, h = board.parallel(p1, t1.along, key=t1.key), board.parallel(p2, t2.along, key=t2.key)
        corner = _meet(board, g, h, t1, what)
        board.rule(view, g, corner, _lettered(t1), _said(t1))
        board.rule(view, h, corner, _lettered(t2), _said(t2))
        return corner
    if t1.along is None and t2.along is None:
        assert t1.mm is not None and t2.mm is not None
        pair = board.arcs(p1, t1.mm, p2, t2.mm, what)
    else:
        (line_term, at), (arc_term, centre) = (one, two) if t1.along is not None else (two, one)
        assert line_term.along is not None and arc_term.mm is not None
        line: Line = board.parallel(at, line_term.along, key=line_term.key)
        pair = board.arc_on_line(line, centre, arc_term.mm, what)
    corner = (choose or _first)(*pair)
    for term, start in (one, two):
        if term.mm is not None:
            board.swing(view, start, term.mm, corner)
    return corner


def _meet(board: Board, g: Line, h: Line, term: Term, what: str) -> Points:
    """Where two direction lines meet; forces on parallel lines are in no equilibrium."""
    try:
        return board.meet(g, h, what)
    except DeadPointError:
        if not isinstance(term.rel, Named):
            raise
        raise EquilibriumError(
            bilingual(what)
            + Words(
                "：大小未知的两力作用线平行，力多边形不能闭合；死点（变点）处即如此，请另取位置，否则改变方向或摩擦",
                ": the two forces of unknown size act along parallel lines, so the polygon cannot close; choose "
                "another position where this is a dead point (or change point), else change a direction, or the "
                "friction",
            )
        ) from None


def _lettered(term: Term) -> str:
    """The direction of a line in letters, ⊥BC, where it has letters."""
    text = term.direction.zh.replace("$", "").replace(" ", "")
    return text if text.lstrip("⊥∥").translate(ON_LINE).isascii() else ""


def _said(term: Term) -> Words | None:
    """The direction of a line in words, ∥guide, where it has no letters."""
    return term.direction if term.direction.zh[:1] in ("⊥", "∥") and not _lettered(term) else None


def _first(a: Points, b: Points) -> Points:
    return a
