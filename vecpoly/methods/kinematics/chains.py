"""One side of a velocity or acceleration equation:
the way from the pole to the sought point over one link or one guide."""

from __future__ import annotations

from ...board.board import NO_LENGTH
from ...board.construction import View
from ...board.said.short import too_short
from ...mechanism.model import FRAME, Prismatic
from ...names import At, Kind, Rel, alpha, omega
from ...plane import nominal
from ...vector.close import Closed, close
from ...vector.equation import Equation, Term
from ...words import Words
from ..desk import VECTOR, Desk, Turn
from .image import imaged
from .laid_off import laid_off
from .lengths import write_lengths
from .terms import across, coriolis, known, normal, ref_at, sliding, tangential

_STILL = Turn(0.0, never=True)


def turning_chain(desk: Desk, view: View, at: At, about: str, link: str) -> tuple[Term, ...]:
    """Over a turning link: v_P + v_CP, or a_P + a^n_CP + a^t_CP; P falls away where it is fixed."""
    ref = ref_at(desk, view, At(about), link)
    front = () if ref is None else (known(desk, view, ref),)
    if view is View.VELOCITY:
        return (*front, across(desk, Rel(Kind.V, desk.canonical(at), ref), about, at.point))
    return (*front, normal(desk, at, At(about), link), tangential(desk, at, At(about), link))


def sliding_chain(desk: Desk, view: View, at: At, base: At, joint: Prismatic, parent: str) -> tuple[Term, ...]:
    """Over a guide: v_base + v^r, or a_base + a^k + a^r, base being the coincident point of the other link.

    On a guide that is part of the frame the point's own vector lies along the guide.
    """
    to, ref = desk.canonical(at), desk.canonical(base)
    if parent == FRAME:
        return (sliding(desk, Rel(VECTOR[view], to), joint),)
    front = known(desk, view, base)
    if view is View.VELOCITY:
        return (front, sliding(desk, Rel(Kind.V, to, ref), joint))
    if desk.turns[omega(parent)].never:
        return (front, sliding(desk, Rel(Kind.A, to, ref), joint))
    return (front, coriolis(desk, to, ref, parent), sliding(desk, Rel(Kind.AR, to, ref), joint))


def coincident_tip(desk: Desk, view: View, point: str, parent: str) -> At:
    """The point of the parent link that lies under `point`; its vector is found first where it is missing."""
    at = At(point, parent)
    if parent != FRAME and not desk.has_tip(view, at):
        imaged(desk, view, parent, desk.canonical(at))
    return at


def solve(desk: Desk, view: View, eq: Equation, to: At) -> Closed:
    """Write the equation into the step, draw it, letter the meeting point, keep the ends of all its vectors."""
    board = desk.board
    board.equate(eq.table())
    board.remark(laid_off(desk, view, eq, to))
    closed = close(board, view, 0j, eq, to=desk.tip_label(view, to), of=desk.canonical(to))
    write_lengths(desk, view, eq)
    desk.reach_tip(view, to, closed.meeting)
    board.plot(view, closed.meeting, desk.tip_label(view, to))
    board.arrow_once(view, 0j, closed.meeting, key=desk.key(Rel(VECTOR[view], desk.canonical(to))))
    if view is View.VELOCITY:
        _say_nearly_none(desk, eq, closed)
    return closed


def _say_nearly_none(desk: Desk, eq: Equation, closed: Closed) -> None:
    """That a relative velocity all but vanishes: two letters lie so close that their distance is not to be read."""
    for term in (*eq.left, *eq.right):
        if not isinstance(term.rel, Rel) or term.rel.ref is None or term.unknowns != 1 or term.summed:
            continue
        start, end = closed.ends[term.rel.key]
        apart = float(abs(nominal(end - start)))
        one, other = letters(desk, View.VELOCITY, term.rel.ref, term.rel.to).split()
        if apart < NO_LENGTH and term.rel.to.point == term.rel.ref.point:  # of two points of a link its ω tells it
            desk.board.remark(
                Words(
                    f"${other}$ 与 ${one}$ 重合，故 ${term.symbol}$ = 0。",
                    f" Point ${other}$ coincides with ${one}$, so ${term.symbol}$ = 0.",
                )
            )
        elif too_short(apart):
            desk.board.remark(
                Words(
                    f"${one}$、${other}$ 两点靠得很近，${term.symbol}$ 很小，图上量不准。",
                    f" The points ${one}$ and ${other}$ lie close together: ${term.symbol}$ is too small to be read "
                    "well.",
                )
            )


def letters(desk: Desk, view: View, start: At | None, end: At) -> str:
    """Letters of a paper length: ``p c_2`` or ``b c_2``."""
    return " ".join(desk.start_label(view, at) for at in (start, end))


def never_turns(desk: Desk, link: str) -> None:
    """A link that only translates has neither ω nor α, ever."""
    desk.turns[omega(link)] = desk.turns[alpha(link)] = _STILL
