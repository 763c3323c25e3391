"""What stands in a frame beside the drawing: over it the equations that are drawn there, told by their numbers and
nothing else, under it what is read off, to be written by hand, and the bar of the scale."""

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
from .bar import BAR, Bar, bar_of, barred

KEY, READ = "equation", "readings"  # of what is written over and under a drawing
FIELDS = (KEY, READ, BAR)
MOST = 2  # equations that have a line each; of more the numbers are told, for they are written on the pages before
WRITTEN, READS = 80.0, 60.0  # mm: a frame in which an equation is written; of a line for readings beside a bar
_LINE, _EDGE, _GAP, _DROP = 7.0, 4.0, 2.0, 1.6  # mm: its height; to the frame; to the words, and below their middle
_READINGS, _COLON = Words("量得：", "Readings:"), Words("：", ":")


class Fields(NamedTuple):
    """The numbers of the equations that are drawn in a frame, how many lines they have at most, and whether anything is
    read off it; broad: whether the frame is as wide as an equation that is written; bar: that of its scale, with a
    line of its `own` where it has none beside the readings."""

    equations: tuple[int, ...]
    read: bool
    most: int = MOST
    broad: bool = False
    bar: Bar | None = None
    own: bool = True

    @property
    def lines(self) -> int:
        """How many there are for the equations; of more than have a line each one tells the numbers."""
        if not self.most:  # their numbers stand before the readings, if there are any
            return int(bool(self.equations) and not self.read)
        return min(len(self.equations), self.most) if len(self.equations) <= MOST else 1

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
        return _LINE * (self.read + (self.bar is not None and self.own))


def fields(construction: Construction, figure: Figure) -> Fields:
    """What is written in the frame of this figure."""
    reads = (act.figure for act in construction.acts if isinstance(act, Area | Gauge | Measure))
    read = figure.view.across is None and called(_place(figure)) in reads  # what is read along axes has its axes
    return Fields(numbers(construction, figure), read, bar=bar_of(figure))


def _place(figure: Figure) -> Place:
    return figure.view if not figure.name else Pane(figure.view, figure.name)


def written(some: Fields, low: complex, high: complex) -> Iterator[Mark]:
    """The lines in a frame from its lower left to its upper right corner."""
    told, top, foot = _equations(some.equations), complex(low.real, high.imag), low + 1j * _LINE / 2
    if some.lines and (len(some.equations) > MOST or not some.most):
        yield _note(told, top - 1j * _LINE / 2, KEY)
    elif some.lines:
        yield from _named(told + _COLON, top - 1j * _LINE / 2, high.real, KEY)
        for n in range(1, some.lines):
            yield _rule(top.real + _EDGE, high.real, top.imag - (n + 1 / 2) * _LINE - _DROP, KEY)
    elif some.equations:
        yield _note(told, foot, KEY)
        foot += _wide(told) + _EDGE
    end = high.real
    beside = end - _EDGE - (some.bar.wide if some.bar is not None else 0.0)
    aside = beside - foot.real - _wide(_READINGS) >= READS or not some.read
    if some.bar is not None and (aside or some.own):
        yield from barred(some.bar, complex(end - _EDGE, low.imag + _LINE / 2))
        foot, end = (foot, beside) if aside else (foot + 1j * _LINE, end)
    if some.read:
        yield from _named(_READINGS, foot, end, READ)


def _equations(found: tuple[int, ...]) -> Words:
    """Their numbers: 方程 (1)–(3)."""
    parts = ["–".join(f"({n})" for n in dict.fromkeys((run[0], run[-1]))) for run in runs(found)]
    return Words(f"方程 {'、'.join(parts)}", f"Equation{'s' * (len(found) > 1)} {', '.join(parts)}")


def _note(words: Words, at: complex, key: str) -> Note:
    return Note(at=at + _EDGE, words=words, side=1 + 0j, step=1, key=key)


def _wide(words: Words) -> float:
    """How wide words are in the language in which they are wider (mm)."""
    return max(layout_words(text, NOTE).width for text in (words.zh, words.en))


def _named(words: Words, at: complex, end: float, key: str) -> Iterator[Mark]:
    """Words with a line behind them that goes on to the other side of the frame."""
    yield _note(words, at, key)
    yield _rule(at.real + _EDGE + _wide(words) + _GAP, end, at.imag - _DROP, key)


def _rule(start: float, end: float, y: float, key: str) -> Segment:
    return Segment(a=complex(start, y), b=complex(end - _EDGE, y), role=Role.CONSTRUCTION, step=1, key=key)
