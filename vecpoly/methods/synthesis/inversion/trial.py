"""Centre points by trial, by every hand on its own sheet: where on a line the four inverted places of a pin lie on one
circle. A sheet that is a little off has other places, and may have fewer of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from ....plane import Line, Reals, unit
from ....plane.traced import bare
from ...roots import GOLDEN
from .sheet import Stands

TRIALS = 2000  # over the whole line, denser where the figure is
REFINED = 80  # halvings
FAR = 1e6  # mm: a pin beyond serves no drawing

Several = NDArray[np.complex128]
Numbers = NDArray[np.float64]
Hands = NDArray[np.intp]
Off = Callable[[Numbers, Hands], Numbers]  # of places, each of its hand's sheet


def centre_places(line: Line, stands: Sequence[Stands]) -> list[Reals]:
    """Every centre point of the nominal sheet by its distance along the line (mm), of the others likewise; NaN where a
    sheet has none there."""
    every = [bare(spot) for at in stands for spot in (at.start, at.end)]
    spread = np.broadcast_arrays(bare(line.at), bare(line.along), *every)
    at, along, *poses = (np.asarray(np.ravel(spot), np.complex128) for spot in spread)
    hands = max(1, at.size)
    middle, size = _reach(complex(at[0]), complex(along[0]), poses)
    ends = np.arctan((np.array([-FAR, FAR]) - middle) / size)
    found = _zeros(at + middle * along, size * along, poses, hands, ends)
    first = found[0]
    columns = np.array([_alike(first, other) for other in found]).T
    kept = [column for column in middle + size * np.tan(columns) if abs(column[0]) < FAR]
    return [column if hands > 1 else np.float64(column[0]) for column in kept]


def _reach(at: complex, along: complex, poses: Sequence[Several]) -> tuple[float, float]:
    """Where along the line the body is, and how large the figure is (mm): u → size tan u from there covers the line."""
    spots = np.array([spot[0] for spot in poses]) - at
    middle = complex(spots.mean())
    return (middle * along.conjugate()).real, float(np.abs(spots - middle).max() + abs((middle / along).imag))


def _zeros(at: Several, along: Several, poses: Sequence[Several], hands: int, ends: Numbers) -> list[list[float]]:
    """For every hand the places u where the deviation changes its sign, in order; ends: those of the line."""

    turns = turned(poses)

    def off(u: Numbers, hand: Hands | slice) -> Numbers:
        m = at[hand] + np.tan(u) * along[hand]
        return deviation([spot[hand] for spot in poses], [turn[hand] for turn in turns], m)

    tried = np.linspace(-np.pi / 2, np.pi / 2, TRIALS + 2)[1:-1]
    tried = np.concatenate([ends[:1], tried[(ends[0] < tried) & (tried < ends[1])], ends[1:]])
    values = off(tried[:, None], slice(None))
    row, hand = np.nonzero(values[:-1] * values[1:] < 0)
    between = tried[row], tried[row + 1], hand
    low, high, hand = (np.concatenate(parts) for parts in zip(between, _twice(off, tried, values), strict=True))
    above = off(low, hand) > 0
    for _ in range(REFINED):
        middle = (low + high) / 2
        if np.all((middle == low) | (middle == high)):
            break
        same = (off(middle, hand) > 0) == above
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return [sorted(((low + high) / 2)[hand == h].tolist()) for h in range(hands)]


def _twice(off: Off, tried: Numbers, values: Numbers) -> tuple[Numbers, Numbers, Hands]:
    """Ends of a sign each, and whose: where the deviation turns back between its trials, and is beyond zero there."""
    before, here, after = np.abs(values[:-2]), np.abs(values[1:-1]), np.abs(values[2:])
    alike = (values[:-2] * values[1:-1] > 0) & (values[1:-1] * values[2:] > 0)
    row, hand = np.nonzero(alike & (here <= before) & (here <= after))
    left, right = tried[row], tried[row + 2]
    sign = np.sign(values[row + 1, hand])
    low, high = left, right
    for _ in range(REFINED):
        inner = np.stack([high - GOLDEN * (high - low), low + GOLDEN * (high - low)])
        one, two = sign * off(inner, hand)
        ends = np.where(one < two, np.stack([low, inner[1]]), np.stack([inner[0], high]))
        if np.array_equal(ends, (low, high)):
            break
        low, high = ends
    top = (low + high) / 2
    beyond = sign * off(top, hand) < 0
    left, right, top, hand = left[beyond], right[beyond], top[beyond], hand[beyond]
    return np.concatenate([left, top]), np.concatenate([top, right]), np.concatenate([hand, hand])


def turned(poses: Sequence[Several]) -> list[Several]:
    """How far the body is turned in the first position, and from each other one back to it: it is rigid, however its
    line was stepped off."""
    ways = [np.asarray(unit(poses[i + 1] - poses[i])) for i in range(0, 8, 2)]
    return [ways[0] * way.conj() for way in ways]


def deviation(poses: Sequence[Several], turns: Sequence[Several], m: Several) -> NDArray[np.float64]:
    """The power of M₄′ to the circle through the other three, times the area of their triangle, on scratch paper.

    poses: origin and end of the body's line in each position; turns: of the body, back to the first.
    """
    seen = [poses[0] + (m - poses[2 * i]) * turn for i, turn in enumerate(turns)]
    u, v, w = (place - seen[0] for place in seen[1:])
    centre = 1j * (u * np.abs(v) ** 2 - v * np.abs(u) ** 2)
    area = 2 * (u.conj() * v).imag
    found: NDArray[np.float64] = area * np.abs(w) ** 2 - 2 * (w.conj() * centre).real
    return found


def _alike(first: Sequence[float], other: Sequence[float]) -> list[float]:
    """To each place of the nominal sheet that of another one; NaN where it has none."""
    if len(other) == len(first):
        return list(other)
    padded = [*other, *[np.nan] * len(first)]
    tried = permutations(range(len(padded)), len(first))
    return min(([padded[i] for i in order] for order in tried), key=lambda one: _apart(first, one))


def _apart(first: Sequence[float], other: Sequence[float]) -> tuple[int, float]:
    """How many are missing, then how far the others are."""
    gaps = [abs(one - two) for one, two in zip(first, other, strict=True) if np.isfinite(two)]
    return len(first) - len(gaps), sum(gaps)
