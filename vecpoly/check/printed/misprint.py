"""A wrong length of a linkage that was to be found, explained by one digit misread by the printer."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...foundation.slotted import replace
from ...words import Words
from .verdict import Checked, Verdict, is_angle

_DIGITS = re.compile(r"\d")
FEWEST = 4  # digits of a number of which one is told to be wrong: of fewer almost any could be
NEAR = {"graphical": 0.01, "calculated": 0.0005}  # of the exact value


def with_misprints(checked: list[Checked]) -> list[Checked]:
    """The same verdicts, with the digit that puts a wrong value right where just one does."""
    return [replace(one, slip=one.slip or _told(one)) if one.verdict is Verdict.WRONG else one for one in checked]


def _told(one: Checked) -> Words | None:
    text = one.printed.text
    if (
        len(_DIGITS.findall(text)) < FEWEST
        or one.printed.paper_mm is not None
        or is_angle(one.printed)
        or not one.exact
    ):
        return None
    near = NEAR[one.printed.kind]
    cures = [(number, off) for number, off in _changed(one) if abs(off) <= near]
    if len(cures) != 1:
        return None
    ((meant, off),) = cures
    by = f"{100 * off:+.1f} %".replace("-", "−")
    return Words(f"疑有一位数字误排：{meant} 则差 {by}", f"one digit misprinted? {meant} is off by {by}")


def _changed(one: Checked) -> Iterator[tuple[str, float]]:
    """The number with each of its digits changed, and by which share of the exact value it is off then."""
    text, written = one.printed.text, _written(one.printed.text)
    for digit in _DIGITS.finditer(text):
        for other in set("0123456789") - {digit[0]}:
            meant = text[: digit.start()] + other + text[digit.end() :]
            value = abs(one.printed.value) * _written(meant) / written
            yield meant, (value - abs(one.exact)) / abs(one.exact)


def _written(text: str) -> float:
    found = re.search(r"\d+(?:\.\d+)?", text)
    return float(found[0]) if found and float(found[0]) else 1.0
