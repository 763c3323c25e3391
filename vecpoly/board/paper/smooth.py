"""What a French curve leads through points: a cubic spline over the chords, smooth round a closed figure too."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

STEPS, LONGEST = 12, 1.0  # chords drawn between two points, at least; and how long (mm) one of more is, at most
SAME = 1e-9  # mm: points nearer than this are one

Array = npt.NDArray[np.complex128]


def smooth(points: Sequence[complex]) -> tuple[complex, ...]:
    """Points close enough to look round, through all of these in order; as they are where there are only two."""
    through = np.asarray(points, dtype=np.complex128)
    through = through[np.r_[True, np.abs(np.diff(through)) > SAME]]
    if len(through) < 3:
        return tuple(complex(p) for p in through)
    chords = np.abs(np.diff(through))
    slopes = _slopes(through, chords, closed=bool(abs(through[0] - through[-1]) <= SAME))
    steps = np.maximum(STEPS, np.ceil(chords / LONGEST)).astype(int)
    piece = np.repeat(np.arange(len(chords)), steps)
    t = (np.arange(len(piece)) - (np.cumsum(steps) - steps)[piece]) / steps[piece]
    a, b, m, n = (some[piece] for some in (through[:-1], through[1:], slopes[:-1] * chords, slopes[1:] * chords))
    drawn = a + t * m + t**2 * (3 * (b - a) - 2 * m - n) + t**3 * (2 * (a - b) + m + n)
    return (*map(complex, drawn), complex(through[-1]))


def _slopes(points: Array, chords: npt.NDArray[np.float64], *, closed: bool) -> Array:
    """The derivative by the length of chord at every point, such that the curvature has no jump."""
    count, rises = len(points), np.diff(points) / chords
    rows, right = np.zeros((count, count)), np.zeros(count, dtype=np.complex128)
    for i in range(1, count - 1):
        before, after = chords[i - 1], chords[i]
        rows[i, i - 1 : i + 2] = after, 2 * (before + after), before
        right[i] = 3 * (after * rises[i - 1] + before * rises[i])
    if closed:  # the last point is the first one
        before, after = chords[-1], chords[0]
        rows[0, [-2, 0, 1]] = after, 2 * (before + after), before
        right[0] = 3 * (after * rises[-1] + before * rises[0])
        rows[-1, [0, -1]] = 1.0, -1.0
    else:  # the curvature at an end is that of the next point
        rows[0, :2], right[0] = 1.0, 2 * rises[0]
        rows[-1, -2:], right[-1] = 1.0, 2 * rises[-1]
    return np.linalg.solve(rows, right).astype(np.complex128)
