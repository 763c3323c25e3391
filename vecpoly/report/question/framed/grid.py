"""How frames share a sheet: in rows, of a few fixed heights and widths, so that a large drawing has a large frame;
cut as the figures need where only so one sheet holds them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import accumulate, combinations, permutations
from math import ceil
from typing import NamedTuple

from ....drawing.sheets.space import CAPTION, CLEAR, room_inside
from ....foundation.stock import Format
from .aligned import aligned
from .snug import snug

NARROWEST, LOWEST = 55.0, 40.0  # mm: a frame with a short title under it
_SLIM = 2.6  # times as long as wide, beyond which a frame looks drawn out
AMPLE = 1.2  # times the room that a figure needs
Size = tuple[float, float]


class Need(NamedTuple):
    """The room that a figure needs; long: a diagram with axes, which may have a frame as long as itself."""

    wide: float
    high: float
    long: bool = False


_SHARES: dict[int, tuple[tuple[float, ...], ...]] = {
    1: ((1.0,),),
    2: ((1 / 2, 1 / 2), (1 / 3, 2 / 3), (2 / 3, 1 / 3), (2 / 5, 3 / 5), (3 / 5, 2 / 5)),
    3: (
        (1 / 3, 1 / 3, 1 / 3),
        *(one for some in ((1 / 2, 1 / 4, 1 / 4), (2 / 5, 3 / 10, 3 / 10)) for one in sorted(set(permutations(some)))),
    ),
}  # of a sheet for its rows, and of a row for its frames


@dataclass(frozen=True, slots=True)
class Grid:
    """Frames in rows that fill a sheet: their sizes and the places of their tops; how much larger than need be the
    tightest of them is, as far as that matters; how much looser than it another one is; how many times as long as
    wide the slimmest."""

    landscape: bool
    sizes: tuple[Size, ...]
    tops: tuple[complex, ...]
    ease: float
    spread: float
    slim: float


def tightness(sheets: Sequence[Grid]) -> tuple[float, int, bool, bool, int, float, float, float]:
    """No figure without its white is best; then the fewer the sheets the better, the first with a figure beside that
    of the mechanism, from which directions are carried over, all of them lying one way, no frame drawn out, no tight
    one, none that is much looser than another, no slim one."""
    bare = round(sum(max(0.0, 1.0 - sheet.ease) for sheet in sheets), 3)
    ease = min((sheet.ease for sheet in sheets), default=1.0)
    spread, slim = (max((getattr(one, name) for one in sheets), default=1.0) for name in ("spread", "slim"))
    drawn_out = sum(sheet.slim > _SLIM for sheet in sheets)
    alone = len(sheets) > 1 and len(sheets[0].sizes) == 1
    turned = len({sheet.landscape for sheet in sheets}) > 1
    return bare, len(sheets), alone, turned, drawn_out, -ease, round(spread, 1), slim


@lru_cache(maxsize=1024)  # frames are tried with and without more in one of them: most sheets stay as they are
def grid(needs: tuple[Need, ...], landscape: bool, of: Format) -> Grid | None:
    """The rows in which these frames are least tight; where none have room for them the cuts that have; None where they
    don't fit. One figure has a sheet to itself however little white that leaves round it."""
    across = int(room_inside(landscape, of)[0] / (NARROWEST + CLEAR))
    rows = (rows for rows in _rows(len(needs)) if max(rows) <= across)
    high = room_inside(landscape, of)[1] - CLEAR
    could = ((one, heights) for one in rows for heights in _high_enough(needs, one, high))
    made = (_laid(needs, *each, landscape, of) for each in could)
    fitting = (one for one in made if one.ease >= 1 or len(needs) == 1)
    found = min(fitting, key=lambda one: tightness([one]), default=None)
    return found or min(_cut(needs, landscape, of), key=lambda one: tightness([one]), default=None)


def _cut(needs: Sequence[Need], landscape: bool, of: Format) -> Iterator[Grid]:
    """Sheets cut as these frames need."""
    wide, high = (side - CLEAR for side in room_inside(landscape, of))
    asked = [(max(need.wide, NARROWEST) + CLEAR, max(need.high, LOWEST) + CLEAR + CAPTION) for need in needs]
    for boxes in (aligned(one, asked) for one in snug(asked, (wide, high))):
        sizes = [(width - CLEAR, height - CLEAR - CAPTION) for _, _, width, height in boxes]
        tops = [complex(CLEAR / 2 + left + width / 2, high - top) for left, top, width, _ in boxes]
        yield _grid(needs, sizes, tops, landscape)


def least_sheets(needs: Sequence[Need], of: Format) -> int:
    """So many sheets at least hold these frames, if nothing were lost between them."""
    wide, high = (side - CLEAR for side in room_inside(False, of))
    area = sum((need.wide + CLEAR) * (need.high + CLEAR + CAPTION) for need in needs)
    return max(1, ceil(area / (wide * high)))


def _high_enough(needs: Sequence[Need], rows: Sequence[int], height: float) -> Iterator[tuple[float, ...]]:
    """The shares of a sheet of this height for its rows with which no frame is higher than its row; of a sheet with
    one frame all."""
    ends = [*accumulate(rows)]
    highest = [max(need.high for need in needs[end - count : end]) for count, end in zip(rows, ends, strict=True)]
    for some in _shares(len(rows)):
        fits = (high <= part * height - CLEAR - CAPTION for high, part in zip(highest, some, strict=True))
        if len(needs) == 1 or all(fits):
            yield some


def _rows(count: int) -> Iterator[tuple[int, ...]]:
    """Every way to put so many frames in rows."""
    if not count:
        yield ()
    for first in range(1, count + 1):
        yield from ((first, *rest) for rest in _rows(count - first))


def _shares(count: int) -> tuple[tuple[float, ...], ...]:
    return _SHARES.get(count, ((1 / count,) * count,))


def _laid(needs: Sequence[Need], rows: Sequence[int], heights: Sequence[float], landscape: bool, of: Format) -> Grid:
    """These rows of these heights, the frames of each as wide as suits them."""
    width, height = (side - CLEAR for side in room_inside(landscape, of))
    sizes, tops, top, waiting = list[Size](), list[complex](), height, list(needs)
    for count, part in zip(rows, heights, strict=True):
        here, waiting = waiting[:count], waiting[count:]
        high = part * height - CLEAR - CAPTION
        widths = _widths_of(tuple(here), width, high)
        left = CLEAR / 2
        for wide in widths:
            sizes.append((wide - CLEAR, high))
            tops.append(complex(left + wide / 2, top))
            left += wide
        top -= part * height
    return _grid(needs, sizes, tops, landscape)


def _grid(needs: Sequence[Need], sizes: Sequence[Size], tops: Sequence[complex], landscape: bool) -> Grid:
    """Frames of these sizes in these places, weighed against what the figures need."""
    eases = _eases(needs, sizes)
    slim = max(map(_slimness, needs, sizes))
    return Grid(landscape, tuple(sizes), tuple(tops), min(*eases, AMPLE), max(eases) / min(eases), slim)


def _slimness(need: Need, size: Size) -> float:
    """How many times as long as wide a frame is; one about a diagram against that."""
    slim = max(size[0] / size[1], size[1] / size[0])
    return slim / max(1.0, need.wide / need.high) if need.long else slim


@lru_cache(maxsize=4096)  # a row may stand in many sheets
def _widths_of(needs: tuple[Need, ...], width: float, high: float) -> tuple[float, ...]:
    """The widths that suit the frames of a row best."""
    return min(_widths(needs, width), key=lambda some: _row_is(needs, some, high))


def _widths(needs: Sequence[Need], width: float) -> Iterator[tuple[float, ...]]:
    """The widths that the frames of a row may have: equal ones, or the wider one for the wider drawing."""
    for some in _shares(len(needs)):
        widths, pairs = tuple(share * width for share in some), combinations(zip(some, needs, strict=True), 2)
        follow = all((a - b) * (one[0] - other[0]) > 0 for (a, one), (b, other) in pairs if a != b)
        if follow and (min(widths) >= NARROWEST + CLEAR or len(set(some)) == 1):
            yield widths


def _row_is(needs: Sequence[Need], widths: Sequence[float], high: float) -> tuple[float, float]:
    """How tight a row is with these widths, then how unlike its frames are in that."""
    eases = _eases(needs, [(wide - CLEAR, high) for wide in widths])
    return -min(*eases, AMPLE), round(max(eases) / min(eases), 1)


def _eases(needs: Sequence[Need], sizes: Sequence[Size]) -> list[float]:
    return [min(size[i] / need[i] for i in (0, 1)) for size, need in zip(sizes, needs, strict=True)]


def shares() -> frozenset[float]:
    """Every part of a sheet that a frame may have in height or width."""
    return frozenset(part for some in _SHARES.values() for one in some for part in one)
