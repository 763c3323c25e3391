"""Expected errors and distances under each other: those in one unit with one count of decimals."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import floor, isfinite, log10

from ...algebra.rounding import to_places
from ...printed.units import printed_unit
from ...solution import Answer
from ..values import rough

NOTHING = "—"
SMALL, ROUND = 1e-5, 100.0  # smaller errors are told by powers of ten, larger ones in tens


def expected_errors(answers: Iterable[Answer]) -> dict[str, str]:
    """The expected errors by key, in printed units; nothing of what was computed."""
    by_unit: dict[str, list[Answer]] = {}
    for one in answers:
        by_unit.setdefault(one.reading.unit, []).append(one)
    found: dict[str, str] = {}
    for unit, some in by_unit.items():
        read = [one for one in some if not one.computed]
        sizes = alike([printed_unit(unit)[0] * one.expected_error for one in read])
        found |= dict.fromkeys((one.key for one in some), NOTHING)
        found |= {one.key: text for one, text in zip(read, sizes, strict=True)}
    return found


def alike(sizes: Sequence[float]) -> list[str]:
    """Two figures of the least, and of the others its count of decimals, where that is one more than theirs at most."""
    most = max((_places(size) for size in sizes if _is_plain(size)), default=0)
    return [_told(size, most if _is_plain(size) and most <= _places(size) + 1 else None) for size in sizes]


def _told(size: float, places: int | None) -> str:
    """With so many decimals; else to two figures, a zero among them too: 0.070."""
    if not _is_plain(size):
        return rough(size)
    kept = _places(size) if places is None else places
    return f"{to_places(size, kept):.{kept}f}"


def _places(size: float) -> int:
    """The decimals of a number of two figures, none of a large one."""
    return max(0, 1 - floor(log10(size)))


def _is_plain(size: float) -> bool:
    return isfinite(size) and SMALL <= size < ROUND
