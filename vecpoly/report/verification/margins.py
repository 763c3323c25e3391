"""The margin of Grashof's condition, of the lengths as they are printed: who adds them up gets it."""

from __future__ import annotations

from collections.abc import Mapping

from ...check.designs.found import Verified
from ...check.designs.four_bars import type_of
from ...designs.base import Design
from ...printed.digits import drawn_number
from ...solution import Solution


def margin_told(solution: Solution, design: Design, moved: Verified, values: Mapping[str, float]) -> float:
    """In mm; values: the lengths as they were read. That of those where rounding would make another type of it."""
    told = {key: _printed(solution, key, moved.number, value) for key, value in values.items()}
    margin = type_of(design, told)[1]
    return margin if margin * moved.margin > 0 else moved.margin


def _printed(solution: Solution, key: str, number: int, value: float) -> float:
    """A length that is asked as its line and its table have it; another as it is."""
    answer = solution.answers.get(key if number == 1 else f"{key}_{number}")
    if answer is None or answer.reading.unit != "mm" or answer.undefined:
        return value
    return float(drawn_number(answer).replace("−", "-"))
