"""Columns of numbers as they are printed: each rounded once, to one count of decimals, or to one of figures."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import floor, log10

from .quantity import FIGURES, number
from .rounding import braced, to_figures, to_places

_DECIMAL, _PADDED = re.compile(r"[+−]?\d+(?:\.(\d+))?"), 2  # decimals that any number of a column may be given
_EXACT, _MORE = 1e-9, 1  # share of the largest by which a number may be beside its decimals; figures more, if all fit
TOTAL = "Σ"  # the head of a row that sums up those above it


def headed(what: str, unit: str) -> str:
    """The head of a column of numbers in one unit: $M_i$ /(N·m), $φ$ /°."""
    return f"{what} /{braced(unit)}"


def places_of(step: float) -> int:
    """The decimals with which a number is told to such a step."""
    return max(0, -floor(log10(step) + 1e-9)) if step else 0


def decimals(values: Sequence[float], figures: int = FIGURES) -> int:
    """So many decimals that the largest number has these figures; fewer, or one more, where all are told exactly."""
    largest = max(map(abs, values), default=0.0)
    if not largest:
        return 0
    most = max(0, figures - 1 - floor(log10(largest)))
    places = range(most + _MORE + 1)
    return next((n for n in places if all(abs(v - to_places(v, n)) <= _EXACT * largest for v in values)), most)


def column(values: Sequence[float], places: int | None = None) -> tuple[str, ...]:
    """The numbers with one count of decimals: 240.0, 69.0; 14.25, 28.50."""
    count = decimals(values) if places is None else places
    return tuple(_fixed(value, count) for value in values)


def summed(values: Sequence[float], places: int | None = None) -> tuple[str, ...]:
    """The same, and behind them the sum of the numbers as they are printed."""
    count = decimals(values) if places is None else places
    printed = [to_places(value, count) for value in values]
    return column([*printed, sum(printed)], count)


def significant(value: float, figures: int = FIGURES) -> str:
    """The number with all of its figures: 0.2500."""
    text = number(value, figures)
    if not value or "×" in text:
        return text
    return _fixed(value, max(0, figures - 1 - floor(log10(abs(to_figures(value, figures))))))


def _fixed(value: float, places: int) -> str:
    text = f"{to_places(value, places):.{places}f}"
    return text.lstrip("-") if not text.strip("-0.") else text.replace("-", "−")


def padded(rows: Sequence[Sequence[str]]) -> tuple[tuple[str, ...], ...]:
    """The rows with the zeros that were read: each column of numbers has one count of decimals, two at most, or what
    two thirds of its numbers have."""
    return tuple(zip(*map(_padded, zip(*rows, strict=True)), strict=True))


def _padded(column: tuple[str, ...]) -> tuple[str, ...]:
    found = [_DECIMAL.fullmatch(text) for text in column]
    most = max((len(one[1] or "") for one in found if one is not None), default=0)
    told = [len(one[1] or "") == most for one in found if one is not None]
    if not most or (most > _PADDED and 3 * sum(told) < 2 * len(told)):
        return column
    return tuple(
        text if one is None else f"{text}{'' if one[1] else '.'}{'0' * (most - len(one[1] or ''))}"
        for text, one in zip(column, found, strict=True)
    )


def with_zeros(cells: Sequence[str], groups: Sequence[str] = ()) -> tuple[str, ...]:
    """The cells of a column, of which a zero has the decimals of the other numbers of its group, where these have one
    count of them: 0.0 beside 90.0."""
    kinds = groups or ("",) * len(cells)
    counts: dict[str, set[int]] = {}
    for cell, kind in zip(cells, kinds, strict=True):
        if cell != "0" and (found := _DECIMAL.fullmatch(cell)) is not None:
            counts.setdefault(kind, set()).add(len(found[1] or ""))
    places = {kind: some.copy().pop() for kind, some in counts.items() if len(some) == 1}
    return tuple(
        f"{0.0:.{places[kind]}f}" if cell == "0" and kind in places else cell
        for cell, kind in zip(cells, kinds, strict=True)
    )
