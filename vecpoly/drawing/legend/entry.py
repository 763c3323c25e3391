"""An entry of a legend: a sample, drawn as on the sheet, and what it stands for."""

from __future__ import annotations

from ...board.construction import Figure
from ...board.paper.marks import Mark
from ...foundation.slotted import dataclass
from ...words import Lang, Words
from ..scene import Item
from ..symbols.around import Surroundings
from ..symbols.marks import draw

WIDE, HALF = 9.0, 1.5  # mm: a sample lies from x = 0 to WIDE, HALF above and below y = 0
MIDDLE = complex(WIDE / 2)


@dataclass(frozen=True, slots=True)
class Entry:
    """A sample, and what it stands for; plain: that whoever reads drawings knows it anyhow; brief: what it stands for
    beside another entry of the same sample."""

    sample: tuple[Item, ...]
    words: Words
    plain: bool = False
    brief: Words | None = None


def drawn_as_on(figure: Figure, marks: tuple[Mark, ...], lang: Lang, *, black: bool = False) -> tuple[Item, ...]:
    """These marks as the figure has them; black: without the tones of its vectors."""
    tones = {} if black else figure.tones
    around = Surroundings(view=figure.view, lang=lang, tones=tones)
    return tuple(item for mark in marks for item in draw(mark, around))
