"""What stands in a frame beside the drawing: over it the equations that are drawn there, told by their numbers and
nothing else, under it what is read off, to be written by hand, and the bar of the scale."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
from .readings import DROP, LINE, READ, Readings, readings
from .room import is_free

KEY = "equation"  # of what is written over a drawing
FIELDS = (KEY, READ, BAR)
SUMS = (COUPLES, PRODUCTS)  # polygons that are the sum of something, with a table of the equation or without
WRITTEN = 80.0  # mm: a frame in which an equation is written
_EDGE, _GAP = 4.0, 2.0  # mm: to the frame; from the words to a rule
_EQUATION = Words("方程：", "Equation:")


class Fields(NamedTuple):
    """The numbers of the equations that are drawn in a frame, which are written on the pages before, and what is read
    off, if anything is; broad: whether the frame is as wide as an equation that is written; bar: that of its scale,
    with a line of its `own` where it has none beside the readings; unnumbered: an equation is drawn there that has no
    number, and a line to be written on; placed: coordinates are read off."""

    equations: tuple[int, ...]
    read: Readings | None
    broad: bool = False
    bar: Bar | None = None
    own: bool = True
    unnumbered: bool = False
    placed: bool = False

    @property
    def above(self) -> float:
        """How high the line for the equations is (mm)."""
        return LINE * bool(self.equations or self.unnumbered)

    @property
    def wide(self) -> float:
        """How wide a frame should be for what is written (mm)."""
        return max(WRITTEN if self.unnumbered and self.broad else 0.0, self.read.wide if self.read is not None else 0.0)

    def within(self, figure: Figure, width: float) -> Fields:
        """With a bar that a frame of this width has room for."""
        return self if self.bar is None else self._replace(bar=bar_of(figure, width - 2 * _EDGE))

    @property
    def below(self) -> float:
        """How high the lines under it are."""
        return LINE * ((0 if self.read is None else self.read.lines) + (self.bar is not None and self.own))


def fields(construction: Construction, figure: Figure) -> Fields:
    """What is written in the frame of this figure."""
    read = readings(construction, figure) if figure.view.across is None else None  # an axis has what is read along it
    found = numbers(construction, figure)
    placed = read is not None and any(one.placed for one in read.blanks)
    return Fields(found, read, bar=bar_of(figure), unnumbered=not found and _summed(figure), placed=placed)


def _summed(figure: Figure) -> bool:
    """Whether vectors are added there, from a pole, to a sum that is an equation."""
    start = begins_at(figure)
    return start is not None and start.dot is Dot.POLE and figure.view in SUMS


def written(some: Fields, low: complex, high: complex, shown: Sequence[Mark] = ()) -> Iterator[Mark]:
    """The lines in a frame from its lower left to its upper right corner; a bar that has no line of its own stands
    where none of what is shown does."""
    top = complex(low.real, high.imag) - 1j * LINE / 2
    if some.equations:
        yield _note(_equations(some.equations), top)
    elif some.unnumbered:
        yield from _named(_EQUATION, top, high.real)
    yield from _under(some, low, high.real, shown)


def _under(some: Fields, low: complex, end: float, shown: Sequence[Mark]) -> Iterator[Mark]:
    """What stands at the foot: readings, and the bar beside them, or below where they leave no room."""
    foot, read = low + 1j * LINE / 2, some.read
    beside = end - _EDGE - (some.bar.wide if some.bar is not None else 0.0)
    aside = read is None or (beside - foot.real >= read.wide + _EDGE and not some.own)
    if some.bar is not None and (aside or some.own):
        right = complex(end - _EDGE, low.imag + LINE / 2)
        yield from barred(some.bar, right if some.own else _clear(some.bar, right, foot + _EDGE, shown))
        foot, end = (foot, beside) if aside else (foot + 1j * LINE, end)
    if read is not None:
        yield from read.written(foot + _EDGE + 1j * (read.lines - 1) * LINE, end - _EDGE)


def _clear(bar: Bar, right: complex, left: complex, shown: Sequence[Mark]) -> complex:
    """Where the bar ends: at the right, or where something stands there, and nothing at the left, at the left."""
    ends = (right, left + bar.wide)
    half = 1j * LINE / 2
    return next((end for end in ends if is_free(end - bar.wide - half, end + half, shown)), right)


def _equations(found: tuple[int, ...]) -> Words:
    """Their numbers: 方程 (1)–(3)."""
    parts = ["–".join(f"({n})" for n in dict.fromkeys((run[0], run[-1]))) for run in runs(found)]
    return Words(f"方程 {'、'.join(parts)}", f"Equation{'s' * (len(found) > 1)} {', '.join(parts)}")


def _note(words: Words, at: complex) -> Note:
    return Note(at=at + _EDGE, words=words, side=1 + 0j, step=1, key=KEY)


def _named(words: Words, at: complex, end: float) -> Iterator[Mark]:
    """Words with a line behind them that goes on to the other side of the frame."""
    yield _note(words, at)
    start = _EDGE + max(layout_words(text, NOTE).width for text in (words.zh, words.en)) + _GAP
    line = at + start - 1j * DROP
    yield Segment(a=line, b=complex(end - _EDGE, line.imag), role=Role.CONSTRUCTION, step=1, key=KEY)
