"""The bar of a frame: a length on paper that stands for a round value of what is drawn there."""

from __future__ import annotations

from collections.abc import Iterator
from math import floor, inf, log10
from typing import NamedTuple

from ....algebra.quantity import number
from ....board.construction import Figure
from ....board.paper.marks import Mark, Note, Role, Segment
from ....drawing.style import NOTE
from ....figures.energy import INDICATOR
from ....typeset.words import layout_words
from ....words import Words
from ...picture import to_scale

BAR = "bar"  # of its marks
_LONGEST, _SHORTEST, _ROUND = 40.0, 10.0, (1.0, 2.0, 5.0)  # mm, it is at most, it may be; of its value
_TICK, _GAP = 1.0, 1.5  # mm: half of one at its ends and its middle; to its value
_METRE, _MILLIMETRE, _MILLI = "m", "mm", 1e3


class Bar(NamedTuple):
    """How long it is on paper (mm), and the value that it stands for, with its unit."""

    long: float
    told: Words

    @property
    def wide(self) -> float:
        """With its value behind it (mm)."""
        return self.long + _GAP + max(layout_words(text, NOTE).width for text in (self.told.zh, self.told.en))


def bar_of(figure: Figure, room: float = inf) -> Bar | None:
    """The bar of a figure that is drawn to one scale, with its value no wider than this; one with axes has its numbers
    there. A length is said to be that of the mechanism: on the paper there is another bar, of the print; one that holds
    along one axis only, as the bar lies, to be along it."""
    if not to_scale(figure) or figure.view.across is not None or figure.view is INDICATOR:
        return None
    bar = _bar(figure, _LONGEST)
    return bar if bar.wide <= room else _bar(figure, max(room - bar.wide + bar.long, _SHORTEST))


def _bar(figure: Figure, longest: float) -> Bar:
    """The longest of a round value."""
    scale = figure.scale.right.told
    per_mm, unit = (scale.value * _MILLI, _MILLIMETRE) if scale.unit == _METRE else (scale.value, scale.unit)
    value = _round_down(longest * per_mm)
    text = f"{number(value, 3)} {unit}"
    told = Words(f"实际 {text}", f"{text} (real)") if unit == _MILLIMETRE else Words.same(text)
    if figure.scale.across is not None:
        axis = scale.symbol.partition("_")[2]
        told = Words(f"沿 ${axis}$ 轴{told.zh}", f"along ${axis}$: {told.en}")
    return Bar(value / per_mm, told)


def _round_down(most: float) -> float:
    """The greatest round value that is no more than this."""
    power = floor(log10(most * (1 + 1e-9)))
    step = max(one for one in _ROUND if one * 10.0**power <= most * (1 + 1e-9))
    return float(f"{step:g}e{power}")


def barred(bar: Bar, end: complex) -> Iterator[Mark]:
    """The bar with its value, which ends here."""
    start = end - bar.wide
    ends = start, start + bar.long / 2, start + bar.long
    yield Segment(a=ends[0], b=ends[-1], role=Role.CONSTRUCTION, step=1, key=BAR)
    for at in ends:
        yield Segment(a=at - 1j * _TICK, b=at + 1j * _TICK, role=Role.CONSTRUCTION, step=1, key=BAR)
    yield Note(at=ends[-1] + _GAP, words=bar.told, side=1 + 0j, step=1, key=BAR)
