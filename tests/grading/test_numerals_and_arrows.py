"""Roman numerals of classes, as textbooks and our own sheets tell them; arrows beside directions in degrees."""

from __future__ import annotations

import pytest

from vecpoly import load
from vecpoly.grading.reading.rank import rank
from vecpoly.grading.reading.written import State, written
from vecpoly.grading.student import check_answers


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Ⅱ", 2), ("Ⅱ级", 2), ("II", 2), ("ii 级", 2), ("II级机构", 2), ("ＩＩＩ", 3), ("class III", 3), ("二级", 2),
        ("2", 2), (2.0, 2), ("2级", 2), ("Ⅳ 级杆组", 4), ("不能拆分", 0),
    ],
)  # fmt: skip
def test_a_class_is_read_as_it_is_told(text: str | float, value: int) -> None:
    """Ⅱ 级 is what the sheets of solutions say, and everybody who wrote it waited for a person."""
    found = rank(text)
    assert (found.state, found.value, found.raw) == (State.READ, value, str(text))


@pytest.mark.parametrize("text", ["两级", "iiii", "vx", "II或III", "abc"])
def test_what_is_no_class_is_not_read_as_one(text: str) -> None:
    assert rank(text).state is State.UNREADABLE


def test_numerals_are_read_where_a_class_is_asked_alone() -> None:
    assert check_answers(load("2-9"), ["class_1=Ⅱ级"]).right and not check_answers(load("2-9"), ["class_1=III"]).right
    assert written("II").state is State.UNREADABLE


@pytest.mark.parametrize(
    ("text", "state", "degrees"),
    [
        ("97.5 mm/s ↗ ∠ 72°", State.READ, 72.0),
        ("0.204∠103° ∠ 103°", State.READ, 103.0),
        ("0.191 m/s→ ∠ 335°", State.AMBIGUOUS, None),
        ("0.191 m/s ← ↑", State.AMBIGUOUS, None),
    ],
)
def test_an_arrow_beside_a_direction_that_it_agrees_with_is_no_matter(
    text: str, state: State, degrees: float | None
) -> None:
    found = written(text)
    assert found.state is state and (found.direction.degrees if found.direction else None) == degrees
