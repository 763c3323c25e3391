"""What is written by hand in a frame beside the drawing: over it the equations that are drawn there, told by their
numbers and nothing else, under it what is read off; each on a line of its own."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ....board.acts import Area, Gauge, Measure
from ....board.construction import Construction, Figure
from ....board.paper.marks import Mark, Note, Role, Segment
from ....board.place import Pane, Place, called
from ....drawing.style import NOTE
from ....typeset.words import layout_words
from ....words import Words
from ..equations import numbers, runs

KEY, READ = "equation", "readings"  # of what is written over and under a drawing
FIELDS = (KEY, READ)
MOST = 2  # equations that have a line each; more are told together
WRITTEN = 80.0  # mm: a frame in which an equation is written
_LINE, _EDGE, _GAP, _DROP = 7.5, 4.0, 2.0, 1.6  # mm: its height; to the frame; to the words, and below their middle
_READINGS = Words("量得：", "Readings:")


class Fields(NamedTuple):
    """The numbers of the equations that are drawn in a frame, how many lines they have at most, and whether anything is
    read off it; broad: whether the frame is as wide as an equation that is written."""

    equations: tuple[int, ...]
    read: bool
    most: int = MOST
    broad: bool = False

    @property
    def lines(self) -> int:
        """How many there are for the equations."""
        return min(len(self.equations), self.most)

    @property
    def above(self) -> float:
        """How high they are (mm)."""
        return _LINE * self.lines

    @property
    def wide(self) -> float:
        """How wide a frame should be for them (mm)."""
        return WRITTEN if self.equations and self.broad else 0.0

    @property
    def below(self) -> float:
        """Likewise under it."""
        return _LINE * self.read


def fields(construction: Construction, figure: Figure) -> Fields:
    """What is written in the frame of this figure."""
    reads = (act.figure for act in construction.acts if isinstance(act, Area | Gauge | Measure))
    read = figure.view.across is None and called(_place(figure)) in reads  # what is read along axes has its axes
    return Fields(numbers(construction, figure), read)


def _place(figure: Figure) -> Place:
    return figure.view if not figure.name else Pane(figure.view, figure.name)


def written(some: Fields, low: complex, high: complex) -> Iterator[Mark]:
    """The lines in a frame from its lower left to its upper right corner."""
    if some.equations:
        parts = ["–".join(f"({n})" for n in dict.fromkeys((run[0], run[-1]))) for run in runs(some.equations)]
        words = Words(f"方程 {'、'.join(parts)}：", f"Equation{'s' * (len(some.equations) > 1)} {', '.join(parts)}:")
        top = complex(low.real, high.imag)
        yield from _named(words, top - 1j * _LINE / 2, high.real, KEY)
        for n in range(1, some.lines):
            yield _rule(top.real + _EDGE, high.real, top.imag - (n + 1 / 2) * _LINE - _DROP, KEY)
    if some.read:
        yield from _named(_READINGS, low + 1j * _LINE / 2, high.real, READ)


def _named(words: Words, at: complex, end: float, key: str) -> Iterator[Mark]:
    """Words with a line behind them that goes on to the other side of the frame."""
    yield Note(at=at + _EDGE, words=words, side=1 + 0j, step=1, key=key)
    wide = max(layout_words(text, NOTE).width for text in (words.zh, words.en))
    yield _rule(at.real + _EDGE + wide + _GAP, end, at.imag - _DROP, key)


def _rule(start: float, end: float, y: float, key: str) -> Segment:
    return Segment(a=complex(start, y), b=complex(end - _EDGE, y), role=Role.CONSTRUCTION, step=1, key=key)
