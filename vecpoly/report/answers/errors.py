"""Expected errors and distances under each other: those in one unit with one count of decimals."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, isfinite, log10

from ...algebra.rounding import braced, to_places
from ...printed.units import printed_unit
from ...solution import Answer
from ..values import rough

NOTHING = "—"
STAR = "*"  # behind the expected error of what could hardly be found by drawing
_SPREAD = 2  # decimals by which errors may differ that have as many
SMALL, ROUND = 1e-5, 100.0  # smaller errors are told by powers of ten, larger ones in tens


def beside(answers: Sequence[Answer], deviations: Sequence[str]) -> list[str]:
    """The expected errors as the deviations beside them are told: in per cent of the exact value, of angles in degrees;
    where there is no deviation in the printed unit, beside the number; nothing of what was computed."""
    found = [NOTHING] * len(answers)
    kinds = dict[tuple[str, str], list[int]]()
    for n, off in enumerate(deviations):
        if not answers[n].computed:
            unit = printed_unit(answers[n].reading.unit)[1] if off == NOTHING else ""
            kinds.setdefault((sign_of(off), unit), []).append(n)
    for (sign, unit), rows in kinds.items():
        sizes = [_size(answers[n], sign) for n in rows]
        for n, text in zip(rows, alike(sizes), strict=True):
            found[n] = f"{text}{sign or ' %'}" if sign != NOTHING else f"{text} {unit}".strip()
    return found


def in_one_unit(head: str, cells: Sequence[str], bare: str) -> tuple[str, list[str]]:
    """The head and the cells of a column of deviations or errors: the unit that all of them have stands in the head; of
    several each stands beside its number, of a pure number none. bare: the unit of a number that is told without."""
    stars = [STAR if cell.endswith(STAR) else "" for cell in cells]
    spaced = [cell.removesuffix(STAR).replace("°", " °") for cell in cells]
    full = [cell if " " in cell or cell == NOTHING else f"{cell} {bare}".strip() for cell in spaced]
    units = {cell.partition(" ")[2] for cell in full if cell != NOTHING}
    if len(units) == 1:
        told = head if units == {""} else f"{head} /{braced(*units)}"
        return told, [cell.partition(" ")[0] + star for cell, star in zip(full, stars, strict=True)]
    return head, [cell.replace(" °", "°") + star for cell, star in zip(full, stars, strict=True)]


def sign_of(off: str) -> str:
    """What stands behind a deviation: ° of an angle, nothing of per cents; NOTHING where there is none."""
    return off if off == NOTHING else "°" if off.endswith("°") else ""


def _size(answer: Answer, sign: str) -> float:
    size = printed_unit(answer.reading.unit)[0] * answer.expected_error
    return size if sign else 100.0 * answer.expected_error / abs(answer.exact)


def alike(sizes: Sequence[float]) -> list[str]:
    """All with as many decimals: two figures of the least, where the largest has three at most, 0.27, 6.46; else fewer,
    but one figure of each: 0.3, 10.3. Those that are of quite different sizes have two figures or three each."""
    own = [_places(size) for size in sizes if _is_plain(size)]
    least, most = (min(own), max(own)) if own else (0, 0)
    if most - least > _SPREAD:
        return [_told(size, min(most, _places(size) + 1) if _is_plain(size) else None) for size in sizes]
    return [_told(size, max(least + 1, most - 1) if _is_plain(size) and most > least else None) for size in sizes]


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
