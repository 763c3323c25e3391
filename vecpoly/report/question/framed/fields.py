"""What stands in a frame beside the drawing: over it the equations that are drawn there, told by their numbers and
nothing else, under it what is read off, to be written by hand, and the bar of the scale."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ....board.construction import Construction, Figure
from ....board.paper.marks import Dot, Mark, Note, Role, Segment
from ....drawing.style import NOTE
from ....figures.balancing import COUPLES, PRODUCTS
from ....typeset.words import layout_words
from ....words import Words
from ..equations import numbers, runs
from .bar import BAR, Bar, bar_of, barred
from .known import begins_at
from .readings import BEFORE, DROP, LINE, READ, Readings, readings

KEY = "equation"  # of what is written over a drawing
FIELDS = (KEY, READ, BAR)
SUMS = (COUPLES, PRODUCTS)  # polygons that are the sum of something, with a table of the equation or without
MOST = 2  # equations that have a line each; of more the numbers are told, for they are written on the pages before
WRITTEN, READS = 80.0, 60.0  # mm: a frame in which an equation is written; of a line for readings beside a bar
_EDGE, _GAP, _APART = 4.0, 2.0, 7.0  # mm: to the frame; from the words to a rule; between words on one line
_EQUATION, _COLON = Words("方程", "Equation"), Words("：", ":")


class Fields(NamedTuple):
    """The numbers of the equations that are drawn in a frame, how many lines they have at most, and what is read off,
    if anything is; broad: whether the frame is as wide as an equation that is written; bar: that of its scale, with a
    line of its `own` where it has none beside the readings; unnumbered: an equation is drawn there that has no number.
    """

    equations: tuple[int, ...]
    read: Readings | None
    most: int = MOST
    broad: bool = False
    bar: Bar | None = None
    own: bool = True
    unnumbered: bool = False

    @property
    def lines(self) -> int:
        """How many there are for the equations; of more than have a line each one tells the numbers."""
        if not self.most:  # their numbers stand before the readings, if there are any
            return int(bool(self.equations) and (self.read is None or self.read.named))
        if self.unnumbered:
            return 1
        return min(len(self.equations), self.most) if len(self.equations) <= MOST else 1

    @property
    def above(self) -> float:
        """How high they are (mm)."""
        return LINE * self.lines

    @property
    def wide(self) -> float:
        """How wide a frame should be for them (mm)."""
        return max(
            WRITTEN if (self.equations or self.unnumbered) and self.broad else 0.0,
            self.read.wide if self.read is not None else 0.0,
        )

    @property
    def below(self) -> float:
        """Likewise under it."""
        return LINE * ((0 if self.read is None else self.read.lines) + (self.bar is not None and self.own))


def fields(construction: Construction, figure: Figure) -> Fields:
    """What is written in the frame of this figure."""
    read = readings(construction, figure) if figure.view.across is None else None  # an axis has what is read along it
    found = numbers(construction, figure)
    return Fields(found, read, bar=bar_of(figure), unnumbered=not found and _summed(figure))


def _summed(figure: Figure) -> bool:
    """Whether vectors are added there, from a pole, to a sum that is an equation."""
    start = begins_at(figure)
    return start is not None and start.dot is Dot.POLE and figure.view in SUMS


def written(some: Fields, low: complex, high: complex) -> Iterator[Mark]:
    """The lines in a frame from its lower left to its upper right corner."""
    top = complex(low.real, high.imag) - 1j * LINE / 2
    told = _equations(some.equations) if some.equations else _EQUATION
    if some.lines and (len(some.equations) > MOST or not some.most):
        yield _note(told, top, KEY)
    elif some.lines:
        yield from _named(told + _COLON, top, high.real)
        for n in range(1, some.lines):
            yield _rule(top.real + _EDGE, high.real, top.imag - n * LINE - DROP, KEY)
    yield from _under(some, low, high.real)


def _under(some: Fields, low: complex, end: float) -> Iterator[Mark]:
    """What stands at the foot: readings, and the bar beside them, or below where they leave no room."""
    foot = low + 1j * LINE / 2
    if some.equations and not some.lines:
        yield _note(_equations(some.equations), foot, KEY)
        foot += _wide(_equations(some.equations)) + _APART
    beside = end - _EDGE - (some.bar.wide if some.bar is not None else 0.0)
    read = some.read
    aside = read is None or beside - foot.real >= (read.wide + _EDGE if read.named else BEFORE + READS)
    aside = aside and not (read is not None and read.named and some.own)
    if some.bar is not None and (aside or some.own):
        yield from barred(some.bar, complex(end - _EDGE, low.imag + LINE / 2))
        foot, end = (foot, beside) if aside else (foot + 1j * LINE, end)
    if read is not None:
        yield from read.written(foot + _EDGE + 1j * (read.lines - 1) * LINE, end - _EDGE)


def _equations(found: tuple[int, ...]) -> Words:
    """Their numbers: 方程 (1)–(3)."""
    parts = ["–".join(f"({n})" for n in dict.fromkeys((run[0], run[-1]))) for run in runs(found)]
    return Words(f"方程 {'、'.join(parts)}", f"Equation{'s' * (len(found) > 1)} {', '.join(parts)}")


def _note(words: Words, at: complex, key: str) -> Note:
    return Note(at=at + _EDGE, words=words, side=1 + 0j, step=1, key=key)


def _wide(words: Words) -> float:
    """How wide words are in the language in which they are wider (mm)."""
    return max(layout_words(text, NOTE).width for text in (words.zh, words.en))


def _named(words: Words, at: complex, end: float) -> Iterator[Mark]:
    """Words with a line behind them that goes on to the other side of the frame."""
    yield _note(words, at, KEY)
    yield _rule(at.real + _EDGE + _wide(words) + _GAP, end, at.imag - DROP, KEY)


def _rule(start: float, end: float, y: float, key: str) -> Segment:
    return Segment(a=complex(start, y), b=complex(end - _EDGE, y), role=Role.CONSTRUCTION, step=1, key=key)
