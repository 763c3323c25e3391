"""Where two curves of a diagram meet: crossings, and places where they only touch."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...board.board import Board
from ...plane import Points
from ...words import Words
from .graph import SAME, Graph

SEEN = 1e-6  # mm: curves nearer than this are together, for the steadiest hand
EYE = 3.0  # of what the dividers scatter: nearer than this they are together for any other


@dataclass(frozen=True, slots=True, kw_only=True)
class Meeting:
    """A point of both curves; how many corners of each lie before it; whether they change sides there."""

    at: Points
    upper: int
    lower: int
    crosses: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Sample:
    """The difference of the curves at an end of a strip where both are straight, and from which corners they come."""

    x: float
    i: int
    j: int
    difference: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """The meetings from left to right, and whether the first curve is above the other before the first of them."""

    above: bool
    meetings: tuple[Meeting, ...]


def meetings(board: Board, upper: Graph, lower: Graph) -> Found:
    """Walk along both curves and note where the first of them goes to the other side, or touches it."""
    eye = max(SEEN, EYE * board.hand.nominal.dividers)
    last: Sample | None = None
    touched: Sample | None = None
    found: list[Meeting] = []
    above = True
    for now in _samples(upper, lower):
        if abs(now.difference) <= eye:
            touched = touched or (now if last is not None else None)
            continue
        if last is None:
            above = now.difference > 0
        elif (now.difference > 0) is not (last.difference > 0):
            found.append(_crossing(board, upper, lower, last, now, touched))
        elif touched is not None:
            found.append(_together(upper, lower, touched, crosses=False))
        last, touched = now, None
    return Found(above=above, meetings=tuple(found))


def _samples(upper: Graph, lower: Graph) -> Iterator[Sample]:
    """Both ends of every strip between corners of either curve."""
    places = sorted({*upper.xs, *lower.xs})
    apart = [x for n, x in enumerate(places) if n == 0 or x - places[n - 1] > SAME]
    right = min(upper.xs[-1], lower.xs[-1])
    inner = [x for x in apart if x < right - SAME]
    for a, b in zip(inner, [*inner[1:], right], strict=True):
        for x, before in ((a, False), (b, True)):
            # within a strip both come from the corners at its left end
            i, j = upper.stretch(a, before=False), lower.stretch(a, before=False)
            yield Sample(x=x, i=i, j=j, difference=upper.height(x, before=before) - lower.height(x, before=before))


def _crossing(board: Board, upper: Graph, lower: Graph, last: Sample, now: Sample, touched: Sample | None) -> Meeting:
    if touched is not None:
        return _together(upper, lower, touched, crosses=True)
    if now.x - last.x > SAME:
        at = board.meet(upper.line(now.i), lower.line(now.j), _CROSSING)
        return Meeting(at=at, upper=now.i + 1, lower=now.j + 1, crosses=True)
    return _at_a_jump(board, upper, lower, now)


_CROSSING = Words("两曲线的交点", "the crossing of the curves")


def _at_a_jump(board: Board, upper: Graph, lower: Graph, now: Sample) -> Meeting:
    """Where one curve jumps across the other; where both jump, half way where they overlap."""
    up, down = upper.jump(now.x), lower.jump(now.x)
    if up is not None and down is not None:
        one, two = (sorted(g.ys[k : k + 2]) for g, k in ((upper, up), (lower, down)))
        half = (max(one[0], two[0]) + min(one[1], two[1])) / 2
        a, b = upper.corners[up], upper.corners[up + 1]
        return Meeting(at=(a.real + b.real) / 2 + 1j * half, upper=up + 1, lower=down + 1, crosses=True)
    first = upper.line(up if up is not None else now.i)
    other = lower.line(down if down is not None else now.j)
    return Meeting(
        at=board.meet(first, other, _CROSSING),
        upper=(up if up is not None else now.i) + 1,
        lower=(down if down is not None else now.j) + 1,
        crosses=True,
    )


def _together(upper: Graph, lower: Graph, at: Sample, *, crosses: bool) -> Meeting:
    """At a corner of one curve that lies on the other."""
    corner = next(
        (
            g.corners[k]
            for g, start in ((upper, at.i), (lower, at.j))
            for k in (start, start + 1)
            if abs(g.xs[k] - at.x) <= SAME
        ),
        upper.corners[at.i],
    )
    return Meeting(at=corner, upper=at.i + 1, lower=at.j + 1, crosses=crosses)
