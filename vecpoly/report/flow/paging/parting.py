"""Where a page break may part what stands together: behind a display, within a sentence, a table or a box. No line
stands alone at a foot or a head; a display keeps the line that introduces it, a box of answers the line before it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..base import Block
from ..blocks import Divider, Heading
from ..para import Para

UNDER = 2  # lines under a heading at the foot of a page, at least
ALONE = 24.0  # pt: what is lower is one line, which does not open a page by itself

Halves = tuple[list[Block], list[Block]]


def parted(blocks: Sequence[Block], width: float, room: float, stretch: float) -> Halves | None:
    """Those that stand here, in so many points of room, and those overleaf, as many here as may be; None where no part
    of them may stand here. stretch: by how much white is opened on this page."""
    for count, used in reversed([*enumerate(_depths(blocks, width, stretch))]):
        if used > room:
            continue
        halves = _halved(blocks, count, width, room - used - stretch * _white(blocks, count))
        if halves is not None:
            return halves
        if count and _may_end(blocks, count, width):
            return [*blocks[:count]], [*blocks[count:]]
    return None


def _depths(blocks: Sequence[Block], width: float, stretch: float) -> Iterator[float]:
    """How high none of them, the first, the first two ... are."""
    depth = 0.0
    for n, one in enumerate(blocks):
        yield depth
        depth += stretch * _white(blocks, n) + one.wrap(width, 0.0)[1]


def _white(blocks: Sequence[Block], n: int) -> float:
    """The white between one of them and that before it."""
    return max(blocks[n].spaceBefore, blocks[n - 1].spaceAfter) if n else 0.0


def _halved(blocks: Sequence[Block], count: int, width: float, room: float) -> Halves | None:
    """Parted within the one that stands behind so many."""
    one = blocks[count]
    if one.wrap(width, room)[1] <= room:
        return None
    parts = [part for part in one.split(width, room) if isinstance(part, Block)] if room > 0 else []
    if len(parts) < 2 or (count and isinstance(one, Para) and _few_lines_under(blocks[count - 1], parts[0], width)):
        return None
    return [*blocks[:count], parts[0]], [*parts[1:], *blocks[count + 1 :]]


def _few_lines_under(head: Block, part: Block, width: float) -> bool:
    return isinstance(head, Heading) and isinstance(part, Para) and len(part.lines(width)) < UNDER


def _may_end(blocks: Sequence[Block], count: int, width: float) -> bool:
    """Whether a page may end behind so many of them."""
    last, *rest = blocks[count - 1 :]
    if isinstance(last, (Para, Divider)) or rest[0].clings:
        return False
    return len(rest) > 1 or rest[0].wrap(width, 0.0)[1] >= ALONE
