"""Columns of numbers as they are printed: each rounded once, to one count of decimals, or to one of figures."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

from .quantity import FIGURES, number
from .rounding import braced, to_figures, to_places

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
