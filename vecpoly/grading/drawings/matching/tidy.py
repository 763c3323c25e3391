"""Lines as drawn become lines as meant: helping lines apart, pieces of one line together, what is drawn twice once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

from ....foundation.slotted import replace
from ..segment import SHORTEST, TOUCH, Drawing, Segment
from .barbs import headed_by_barbs
from .naming import figure_of, helping

STRAIGHT = 0.002  # rad between pieces of one line
THIN = 0.6  # of the widest ink: helping lines, where nothing else tells


@dataclass(frozen=True, slots=True, kw_only=True)
class Strokes:
    """The lines of a drawing, the helping lines apart; part: of each line the connected part that it belongs to."""

    lines: tuple[Segment, ...]
    helping: tuple[Segment, ...]
    twice: tuple[Segment, ...]
    parts: tuple[int, ...]


def strokes(drawing: Drawing) -> Strokes:
    """The lines of a drawing, tidied."""
    whole, barbs = headed_by_barbs(drawing.segments)
    long = [one for one in whole if abs(one.along) > SHORTEST]
    aside = {n for n, one in enumerate(long) if not one.headed and helping(one.layer)}
    if any(one.headed for one in long):
        aside |= _thin(long)
    lines, twice = _once(_merged([one for n, one in enumerate(long) if n not in aside]))
    return Strokes(
        lines=tuple(lines),
        helping=(*(long[n] for n in sorted(aside)), *barbs),
        twice=tuple(twice),
        parts=tuple(_parts(lines)),
    )


def _thin(lines: Sequence[Segment]) -> set[int]:
    """Lines much thinner than every vector, where vectors have heads and widths."""
    heads = [one.width for one in lines if one.headed and one.width > 0]
    least = THIN * min(heads) if heads else 0.0
    return {n for n, one in enumerate(lines) if not one.headed and 0 < one.width < least}


def _merged(lines: list[Segment]) -> list[Segment]:
    """Pieces that go on straight, where nothing else ends, as one line."""
    found = list(lines)
    while (pair := _pieces(found)) is not None:
        i, j, joined = pair
        found = [one for n, one in enumerate(found) if n not in (i, j)] + [joined]
    return found


def _pieces(lines: Sequence[Segment]) -> tuple[int, int, Segment] | None:
    ends = np.array([z for one in lines for z in (one.start, one.end)])
    for i, j in _touching(ends):
        one, other = lines[i], lines[j]
        joined = _joined(one, other) if one.name == other.name or not (one.name and other.name) else None
        if joined is None:
            continue
        at = min((one.start, one.end), key=lambda z: min(abs(z - other.start), abs(z - other.end)))
        if int(np.sum(np.abs(ends - at) < TOUCH)) == 2:
            return i, j, joined
    return None


def _touching(ends: NDArray[np.complex128]) -> list[tuple[int, int]]:
    """Pairs of lines of which an end of one lies at an end of the other."""
    if not len(ends):
        return []
    from scipy.spatial import cKDTree

    tree = cKDTree(np.column_stack([ends.real, ends.imag]))
    return sorted({(int(i) // 2, int(j) // 2) for i, j in tree.query_pairs(TOUCH) if i // 2 != j // 2})


def _joined(one: Segment, other: Segment) -> Segment | None:
    """The line of both, if they are pieces of one; a head stays where it is, and may not stand within."""
    if abs(one.end - other.start) >= TOUCH:
        if abs(other.end - one.start) < TOUCH:
            one, other = other, one
        elif abs(one.end - other.end) < TOUCH and not other.headed:
            other = other.turned()
        elif abs(one.start - other.start) < TOUCH and not one.headed:
            one = one.turned()
        else:
            return None
    bend = abs(np.angle(other.along / one.along))
    if one.headed or bend > STRAIGHT + TOUCH / 10 / min(abs(one.along), abs(other.along)):
        return None
    return replace(other, start=one.start, name=other.name or one.name, sigma=max(one.sigma, other.sigma))


def _once(lines: Sequence[Segment]) -> tuple[list[Segment], list[Segment]]:
    """Each line once, with its head and its name; and those that lie on another."""
    kept: list[Segment] = []
    twice: list[Segment] = []
    for one in lines:
        for n, old in enumerate(kept):
            if _alike(old, one) and not (old.name and one.name and old.name != one.name):
                kept[n] = replace(one if one.headed and not old.headed else old, name=old.name or one.name)
                twice.append(one)
                break
        else:
            kept.append(one)
    return kept, twice


def _alike(one: Segment, other: Segment) -> bool:
    forth = max(abs(one.start - other.start), abs(one.end - other.end))
    back = max(abs(one.start - other.end), abs(one.end - other.start))
    opposite = one.headed and other.headed and back < forth
    return min(forth, back) < SHORTEST and not opposite


def _parts(lines: Sequence[Segment]) -> list[int]:
    """The connected part of each line; lines whose layers name different figures never hang together."""
    if not lines:
        return []
    start, along = np.array([one.start for one in lines]), np.array([one.along for one in lines])
    kinds = [figure_of(one.layer) for one in lines]
    apart = np.array([[bool(a and b and a != b) for b in kinds] for a in kinds])
    near = np.minimum(_off(start, start, along), _off(start + along, start, along)) < TOUCH
    return [int(part) for part in connected_components((near | near.T) & ~apart, directed=False)[1]]


def _off(at: NDArray[np.complex128], start: NDArray[np.complex128], along: NDArray[np.complex128]) -> Any:
    """How far each place lies from each line."""
    way = at[:, None] - start[None, :]
    share = np.clip((way / along).real, 0.0, 1.0)
    return np.abs(way - share * along)
