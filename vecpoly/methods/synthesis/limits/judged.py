"""A crank-rocker from A and the two limit positions of its rocker: half the difference, half the sum."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ....algebra.quantity import Quantity
from ....designs.quantities import AB, AD, BC, CD, SWING, THETA
from ....designs.verdict import Verdict
from ....plane import Points, ahead, cross, distance, nominal, unit
from ....words import Words
from ..angles import found
from ..draft import SHEET, TWO, Draft
from ..linkage import crank_circle, drawn, pin, rejected
from ..transmission import least_angle

EVEN = 1e-6  # mm: A on the bisector
BESIDE = 1e-9  # of the rocker, or of C₁C₂: A in a limit position of C, where AD is as long as CD
IN_LINE = 1e-9  # of the rocker: a limit position of C on AD


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """The fixed pins, and C where the crank and the coupler overlap (folded) and where one prolongs the other.

    letters: of A, C folded and C extended on the sheet. first: whether C folded is C₁.
    """

    a: Points
    d: Points
    folded: Points
    extended: Points
    letters: tuple[str, str, str]
    first: bool


def judged(a: Points, d: Points, c1: Points, c2: Points, *, seen: bool = True) -> Verdict:
    """The verdict on limit positions as they stand on the sheet. seen: whether A sees them under θ."""
    ideal = nominal(a), nominal(d), nominal(c1), nominal(c2)
    if at_limit(a, c1, c2):
        return Verdict.AT_LIMIT
    if not seen:
        return Verdict.FAR_ARC
    if _even(ideal[0], *ideal[2:]):
        return Verdict.NO_CRANK
    return Verdict.OPPOSITE if _across(*ideal) else Verdict.VALID


def useful(a: Any, d: complex, c1: complex, c2: complex) -> Any:
    """Which of many places of A, all on one sheet, give a linkage."""
    return ~(_at_limit(a, c1, c2) | _even(a, c1, c2) | _across(a, d, c1, c2))


def at_limit(a: Points, c1: Points, c2: Points) -> bool:
    """Whether A coincides with C in one of its limits."""
    return bool(_at_limit(nominal(a), nominal(c1), nominal(c2)))


def _at_limit(a: Any, c1: complex, c2: complex) -> Any:
    one, other = distance(a, c1), distance(a, c2)
    return np.minimum(one, other) < BESIDE * np.maximum(one, other)


def _even(a: Any, c1: complex, c2: complex) -> Any:
    """Whether A lies on the bisector of C₁C₂."""
    return np.abs(distance(a, c1) - distance(a, c2)) < EVEN


def _across(a: Any, d: complex, c1: complex, c2: complex) -> Any:
    """Whether C₁ and C₂ lie on either side of AD, or one of them on it, where the linkage is at a dead point."""
    one, other = (cross(d - a, c - a) for c in (c1, c2))
    nearest = np.minimum(np.abs(one), np.abs(other))
    return (one * other <= 0) | (nearest < IN_LINE * distance(a, d) * distance(d, c1))


def limits_of(a: Points, d: Points, c1: Points, c2: Points, letters: tuple[str, str, str]) -> Limits:
    """Which of C₁ and C₂ is the folded limit. letters: of A, C₁, C₂."""
    first = float(nominal(distance(a, c1) - distance(a, c2))) <= 0
    folded, extended = (c1, c2) if first else (c2, c1)
    of_a, *ends = letters
    near, far = ends if first else reversed(ends)
    return Limits(a=a, d=d, folded=folded, extended=extended, letters=(of_a, near, far), first=first)


def crank_and_coupler(draft: Draft, limits: Limits) -> tuple[Quantity, Quantity]:
    """l_AB = μ_l (AC_far − AC_near) / 2, l_BC = μ_l (AC_far + AC_near) / 2."""
    board, (of_a, of_near, of_far) = draft.board, limits.letters
    far = board.measure(limits.a, limits.extended, f"{of_a} {of_far}")
    near = board.measure(limits.a, limits.folded, f"{of_a} {of_near}")
    crank = draft.length(draft.of_this(AB), (far - near) / TWO, f"{of_a} B")
    return crank, draft.length(draft.of_this(BC), (far + near) / TWO, "B C")


def _four_bar(draft: Draft, limits: Limits) -> None:
    """AB and BC; then CD, AD, the swing and γ_min."""
    board, (of_a, _, of_far) = draft.board, limits.letters
    if board.here is not SHEET:  # the last solution went on to a figure of its own
        board.step(
            Words(
                f"另一交点给出另一个解（解 {draft.number}），同样量取：",
                f"The other intersection gives another solution (solution {draft.number}); read it likewise:",
            ),
            SHEET,
        )
    crank, coupler = crank_and_coupler(draft, limits)
    if CD.key not in board.readings:
        draft.length(draft.of_this(CD), board.measure(limits.d, limits.extended, f"D {of_far}"), f"D {of_far}")
    if AD.key not in board.readings:
        draft.length(draft.of_this(AD), board.measure(limits.a, limits.d, f"{of_a} D"), f"{of_a} D")
    if SWING.key not in board.readings:
        draft.stated(draft.of_this(SWING), draft.angle(limits.d, limits.folded, limits.extended))
    _swing_marked(draft, limits)
    least_angle(draft, crank, coupler)


def _swing_marked(draft: Draft, limits: Limits) -> None:
    """The swing at D with the arc of C; one that all candidates share is marked once."""
    if SWING.key in draft.board.readings and draft.any_valid:
        return
    found(draft, SWING, limits.d, (limits.folded, limits.extended))


def settled(
    draft: Draft,
    limits: Limits,
    verdict: Verdict,
    read: Callable[[Draft, Limits], None] = _four_bar,
    *,
    framed: bool = True,
) -> None:
    """The linkage in both limits, thick in the extended one; of a valid one AB, BC and what follows from them.

    framed: whether C is on a rocker, which is drawn as far as its pivot D.
    """
    a, near, far = limits.a, limits.folded, limits.extended
    pivots = {"D": limits.d} if framed else {}
    crank = (distance(a, far) - distance(a, near)) / 2
    of_near = ahead(a, unit((far if at_limit(a, near, far) else near) - a), -crank)
    of_far = ahead(a, unit(far - a), crank)
    chains = (a, of_far, far, *pivots.values()), (a, of_near, near, *pivots.values())
    given_far = verdict is not Verdict.VALID and limits.letters[2] == "C_1"  # which all candidates have
    drawn(draft, *(reversed(chains) if given_far else chains), verdict=verdict)
    rejected(draft, verdict)
    if verdict is Verdict.VALID:
        numbers = "12" if limits.first else "21"
        of_near, of_far = (
            pin(draft, draft.letter(f"B{i}"), b) for i, b in zip(numbers, (of_near, of_far), strict=True)
        )
        crank_circle(draft, a, crank)
        found(draft, THETA, a, (near, far))
        read(draft, limits)
    order = crank, (distance(a, far) + distance(a, near)) / 2, distance(a, limits.d), a.real
    draft.candidate(verdict, order, A=a, **pivots, B1=of_near, C1=near, B2=of_far, C2=far)
