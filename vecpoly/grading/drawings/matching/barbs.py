"""Arrow heads that were drawn as lines: two short barbs that fold back from the tip of a line, closed or not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ....foundation.slotted import replace
from ..segment import TOUCH, Segment

LONGEST = 8.0  # mm of a barb; of the line on which it sits SHARE at most
SHARE = 0.6
OPENING = (0.1, 0.9)  # rad between barb and line
EVEN = 0.12  # rad between the two angles; of the length between the two barbs


@dataclass(frozen=True, slots=True, kw_only=True)
class _Barb:
    """A short line seen from a tip: how it is turned from the line's way back, and its length; free: its other end."""

    number: int
    turned: float
    length: float
    free: complex


def headed_by_barbs(lines: Sequence[Segment]) -> tuple[tuple[Segment, ...], tuple[Segment, ...]]:
    """The lines, those with barbs at one end headed there; and the barbs, which are no lines of their own."""
    short = [n for n, one in enumerate(lines) if not one.name and not one.headed and abs(one.along) <= LONGEST]
    found, barbs = list(lines), set[int]()
    for n, one in enumerate(lines):
        if one.headed or n in barbs:
            continue
        ends = [(way, pair) for way in (one, one.turned()) if (pair := _pair(lines, short, n, way)) is not None]
        if len(ends) == 1:
            way, (first, second) = ends[0]
            found[n] = replace(way, headed=True)
            barbs |= {first.number, second.number, *_bases(lines, short, first, second)}
    return (
        tuple(one for n, one in enumerate(found) if n not in barbs),
        tuple(one for n, one in enumerate(lines) if n in barbs),
    )


def _pair(lines: Sequence[Segment], short: Sequence[int], n: int, way: Segment) -> tuple[_Barb, _Barb] | None:
    """The two barbs at the end of a line; None where there are not two that mirror each other."""
    barbs = list(_at(lines, short, n, way))
    for i, one in enumerate(barbs):
        for other in barbs[i + 1 :]:
            alike = abs(one.length - other.length) <= EVEN * max(one.length, other.length)
            if alike and abs(one.turned + other.turned) < EVEN and one.turned * other.turned < 0:
                return one, other
    return None


def _at(lines: Sequence[Segment], short: Sequence[int], n: int, way: Segment) -> Iterator[_Barb]:
    """The short lines that begin at the end of a line and fold back beside it."""
    for m in short:
        one = lines[m]
        if m == n or abs(one.along) > SHARE * abs(way.along):
            continue
        for start, end in ((one.start, one.end), (one.end, one.start)):
            turned = float(np.angle((end - start) / -way.along))
            if abs(start - way.end) < TOUCH and OPENING[0] < abs(turned) < OPENING[1]:
                yield _Barb(number=m, turned=turned, length=abs(end - start), free=end)


def _bases(lines: Sequence[Segment], short: Sequence[int], one: _Barb, other: _Barb) -> Iterator[int]:
    """The line that closes the head, from barb to barb."""
    for m in short:
        line = lines[m]
        forth = max(abs(line.start - one.free), abs(line.end - other.free))
        back = max(abs(line.end - one.free), abs(line.start - other.free))
        if min(forth, back) < TOUCH:
            yield m
