"""A linkage that is found: thick in one position, dashed in the others, another solution in dashes and dots, in thin
dashes where it is rejected."""

from __future__ import annotations

from itertools import pairwise
from math import tau

from ...board.paper.marks import Dot, Role, Segment
from ...board.place import Place
from ...board.strokes import spot
from ...designs.verdict import Verdict
from ...diagram.single import block, rail
from ...diagram.single import pivot as ground
from ...plane import Points, Reals, nominal
from ...words import Words
from .draft import SHEET, Draft

Chain = tuple[Points, ...]
ON = 0.3  # mm: so near to another bar, as an unsteady hand draws it, a bar lies on it
HALF_BLOCK, BEYOND = 2.5, 9.0  # mm: from the middle of a block to its guide; how far the guide goes on


def drawn(draft: Draft, thick: Chain, *thin: Chain, verdict: Verdict = Verdict.VALID) -> None:
    """The links of a candidate as chains of pins in its positions; a rejected one in thin dashes, in the first."""
    for chain in thin if verdict is Verdict.VALID else ():
        _bars(draft, chain, Role.OTHER)
    full = Role.LINK if draft.number == draft.take else Role.SECOND
    _bars(draft, thick, full if verdict is Verdict.VALID else Role.HIDDEN)


def _bars(draft: Draft, chain: Chain, role: Role) -> None:
    for a, b in pairwise(chain):
        bar(draft, a, b, role)


def bar(draft: Draft, a: Points, b: Points, role: Role) -> None:
    """A bar; of a dashed one what is not dashed there yet: dashes over dashes look like a full line."""
    if role is Role.LINK:
        draft.board.join(SHEET, a, b, role)
        return
    there = (mark for mark in draft.board.marks(SHEET) if isinstance(mark, Segment) and mark.role is role)
    free, whole = [(0.0, 1.0)], abs(complex(nominal(b - a)))
    for low, high in (_covered(mark, complex(nominal(a)), complex(nominal(b))) for mark in there):
        if low >= high:
            continue
        free = [part for one, other in free for part in ((one, min(other, low)), (max(one, high), other))]
        free = [part for part in free if (part[1] - part[0]) * whole > ON]
    for low, high in free:
        draft.board.join(SHEET, a if low == 0.0 else a + (b - a) * low, b if high == 1.0 else a + (b - a) * high, role)


def _covered(mark: Segment, a: complex, b: complex) -> tuple[float, float]:
    """From where to where (shares of its length) a bar lies on a line; nowhere where it runs beside it."""
    if abs(b - a) < ON:
        return 1.0, 0.0
    ends = [(end - a) / (b - a) for end in (mark.a, mark.b)]
    beside = any(abs(end.imag) * abs(b - a) > ON for end in ends)
    low, high = sorted(end.real for end in ends)
    return (1.0, 0.0) if beside or high <= low else (low, high)


def pin(draft: Draft, letter: str, at: Points, dot: Dot = Dot.JOINT) -> Points:
    """A pin of the linkage gets its letter."""
    at = draft.board.locate(SHEET, letter, at)
    draft.board.plot(SHEET, at, letter, dot)
    return at


def pivot(draft: Draft, letter: str, at: Points) -> Points:
    """A pin on the frame gets its letter and its ground."""
    at = pin(draft, letter, at)
    draft.board.depict(SHEET, ground(at))
    return at


def crank_circle(draft: Draft, at: Points, radius: Reals, place: Place = SHEET, *, sweep: float = tau) -> None:
    """The circle on which the pin of a crank goes round, or a part of it from the right (rad)."""
    draft.board.circle(place, at, radius, Role.CENTRE, sweep=sweep)


def slider(draft: Draft, places: tuple[Points, ...], along: complex, place: Place = SHEET) -> None:
    """The block of a slider in its first position, and the guide on which it comes through all of them."""
    travels = [(along.conjugate() * (spot(at) - spot(places[0]))).real for at in places]
    low = spot(places[0]) - 1j * along * HALF_BLOCK
    guide = rail(low + along * (min(travels) - BEYOND), low + along * (max(travels) + BEYOND))
    draft.board.depict(place, block("slider", places[0], along), guide)


def point(draft: Draft, letter: str, at: Points) -> Points:
    """A point of the construction gets its letter."""
    return pin(draft, letter, at, Dot.POINT)


def rejected(draft: Draft, verdict: Verdict) -> None:
    """Why the candidate found now is no solution."""
    if verdict is not Verdict.VALID:
        n, why = draft.number, verdict.value
        draft.board.remark(
            Words(
                f" 候选解 {n} 舍去：{why.zh}，以细虚线保留。",
                f" Candidate {n} is rejected: {why.en}; it is drawn in thin dashes.",
            )
        )
