"""An admissible range as it is told: from one end to the other, each rounded so that it can be taken."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import ceil, floor, inf, isclose, log10

from ...words import Words

FIGURES, MOST = 4, 12  # of an end; of the ends of a narrow range, at most


def between(ranges: Iterable[tuple[float, float]], unit: str) -> Words:
    """39.1 to 60 mm, or 71 mm or more; what overlaps is one range."""
    said = [_between(*_rounded(low, high), unit) for low, high in _apart(ranges)]
    return Words("或".join(one.zh for one in said), " or ".join(one.en for one in said))


def _apart(ranges: Iterable[tuple[float, float]]) -> list[tuple[float, float]]:
    made: list[tuple[float, float]] = []
    for low, high in sorted(ranges):
        if made and low <= made[-1][1]:
            made[-1] = made[-1][0], max(made[-1][1], high)
        else:
            made.append((low, high))
    return made


def _between(low: str, high: str, unit: str) -> Words:
    of = f" {unit}" if unit else ""
    if high == "inf":
        return Words(f"不小于 {low}{of} ", f"at least {low}{of}")
    if low == "-inf":
        return Words(f"不大于 {high}{of} ", f"at most {high}{of}")
    return Words(f" {low} 至 {high}{of} ", f"{low} to {high}{of}")


def _rounded(low: float, high: float) -> tuple[str, str]:
    """Both ends, with as many figures as leave something between them."""
    for figures in range(FIGURES, MOST):
        ends = _inwards(low, ceil, figures), _inwards(high, floor, figures)
        if ends[0] <= ends[1]:
            break
    return _written(ends[0], figures), _written(ends[1], figures)


def _written(end: float, figures: int) -> str:
    """Without a power of ten."""
    if end == 0 or abs(end) == inf:
        return f"{end:g}"
    text = f"{end:.{max(0, figures - 1 - floor(log10(abs(end))))}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def _inwards(end: float, towards: Callable[[float], int], figures: int) -> float:
    """An end to so many figures, on the side on which there is a linkage."""
    if end == 0 or abs(end) == inf:
        return end
    step = 10.0 ** (floor(log10(abs(end))) + 1 - figures)
    steps = end / step
    whole = round(steps) if isclose(steps, round(steps), rel_tol=1e-13) else towards(steps)
    return float(f"{whole * step:.{figures}g}")
