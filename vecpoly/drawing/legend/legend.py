"""The entries of a sheet's legend, set in columns: as a band over the title strip, or as a block of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from math import ceil

from ...board.construction import Figure
from ...foundation.slotted import dataclass
from ...typeset import Box, layout_words
from ...words import Lang, Words
from ..scene import Item, TextBox, moved
from ..style import NOTE
from .alike import alike, joined
from .entry import HALF, WIDE, Entry
from .images import tinted
from .kinds import FOUND, KNOWN, kinds_met, side_by_side
from .letters import letters_met, resting_met
from .vectors import key_of_vectors

TITLE, MORE = Words("图例", "Legend"), Words("图例（续）", "Legend (continued)")
PAD, GAP, BESIDE = 2.4, 1.6, 5.0  # mm: to the edge of a legend; sample to words; between columns
PITCH = 5.2  # mm: row to row
CLOSE_PAD, CLOSE_PITCH = 1.5, 4.4  # mm: the same of a band for which there is hardly room
KEPT = 256  # words that are set: the same ones stand on many sheets
WIDEST = 12.0  # mm between columns that are spread over a band


@dataclass(frozen=True, slots=True)
class Cell:
    """An entry with its words set."""

    sample: tuple[Item, ...]
    box: Box

    @property
    def width(self) -> float:
        """Of sample and words, mm."""
        return WIDE + GAP + self.box.width


@dataclass(frozen=True, slots=True)
class Grid:
    """A legend set in columns: its items from the lower left corner, and how large it is, mm."""

    items: tuple[Item, ...]
    width: float
    height: float


def entries(figures: Sequence[Figure], lang: Lang) -> tuple[Entry, ...]:
    """What a legend of these figures explains; nothing where all is plain."""
    kinds = tinted([*kinds_met(figures, lang)], figures, lang)
    both = {KNOWN.words, FOUND.words} <= {one.words for one in kinds}
    kept = [one for one in kinds if both or one.words not in (KNOWN.words, FOUND.words)]
    letters = (*resting_met(figures, lang), *letters_met(figures, lang))
    found = (*key_of_vectors(figures, lang), *side_by_side(figures, lang), *letters, *kept)
    return () if all(one.plain for one in found) else found


def cells(some: Sequence[Entry], lang: Lang) -> list[Cell]:
    """Set in the type of notes; entries whose samples look the same share one."""
    return [Cell(shared[0].sample, _set(joined(shared).of(lang))) for shared in alike(some)]


@lru_cache(maxsize=KEPT)
def _set(words: str, bold: bool = False) -> Box:
    return layout_words(words, NOTE, bold)


def band(some: Sequence[Cell], lang: Lang, width: float, *, close: bool = False) -> Grid:
    """As wide as this, in as few rows as hold it, the title before the first; close: its rows as close as may be."""
    title = _set(TITLE.of(lang), True)
    room = width - 2 * PAD - title.width - BESIDE
    rows = next(n for n in range(1, len(some) + 1) if n == len(some) or _wide(_columns(some, n)) <= room)
    columns = _columns(some, rows)
    spare = (room - sum(_widths(columns))) / len(columns)
    return _grid(columns, title, min(max(BESIDE, spare), WIDEST), beside=True, width=width, close=close)


def blocks(some: Sequence[Cell], lang: Lang, most: float, *, more: bool = False) -> Iterator[Grid]:
    """In one to four columns under the title, those first that are about twice as wide as high. more: what is left of a
    legend that another block begins."""
    title = _set((MORE if more else TITLE).of(lang), True)
    made = (_grid(_columns(some, ceil(len(some) / n)), title, BESIDE) for n in range(1, min(4, len(some)) + 1))
    yield from sorted((one for one in made if one.width <= most), key=lambda one: abs(one.width / one.height - 2.0))


def _columns(some: Sequence[Cell], rows: int) -> list[Sequence[Cell]]:
    return [some[n : n + rows] for n in range(0, len(some), rows)]


def _widths(columns: Sequence[Sequence[Cell]]) -> list[float]:
    return [max(one.width for one in column) for column in columns]


def _wide(columns: Sequence[Sequence[Cell]]) -> float:
    return sum(_widths(columns)) + BESIDE * (len(columns) - 1)


def _grid(
    columns: Sequence[Sequence[Cell]],
    title: Box,
    between: float,
    *,
    beside: bool = False,
    width: float = 0.0,
    close: bool = False,
) -> Grid:
    """The columns right of the title, or under it."""
    rows, widths = max(map(len, columns)), _widths(columns)
    pad, pitch = (CLOSE_PAD, CLOSE_PITCH) if close else (PAD, PITCH)
    left = PAD + (title.width + BESIDE if beside else 0.0)
    height = 2 * pad + (rows - 1) * pitch + 2 * HALF + (0.0 if beside else pitch)
    top = height - pad - HALF - (0.0 if beside else pitch)
    items: list[Item] = [_at(title, PAD, height - pad - HALF)]
    for n, column in enumerate(columns):
        x = left + sum(widths[:n]) + n * between
        for k, cell in enumerate(column):
            y = top - k * pitch
            items += [moved(item, complex(x, y)) for item in cell.sample]
            items.append(_at(cell.box, x + WIDE + GAP, y))
    own = left + sum(widths) + (len(columns) - 1) * between + PAD
    return Grid(tuple(items), max(own, width), height)


def _at(box: Box, x: float, middle: float) -> TextBox:
    """On the middle of its capitals."""
    return TextBox(box=box, x=x, y=middle - (0.33 if box.descent < 0.3 * NOTE else 0.28) * NOTE)
