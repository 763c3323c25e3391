"""Branch statements that cannot both be so, or cannot be read where they are needed, are refused by name."""

from __future__ import annotations

import pytest

from vecpoly import oracle
from vecpoly.errors import BranchError, ProblemFileError
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.load import loads

TEXT = """
id: four-bar
title: t
frame: {A: [0 mm, 0 mm], D: [150 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 140 mm}, 3: {DC: 100 mm}}
input: {link: 1, phi: 60 deg, omega: 5 rad/s}
branch: [%s]
find: [omega_3]
"""
OPPOSED = [
    ("C left of BD", "C right of BD"),
    ("C left of BD", "C left of DB"),
    ("C left of BD", "B right of DC"),
    ("C left of BD", "D left of BC"),
    ("C left of BD", "D right of CB"),
    ("D left of CB", "B right of DC"),
    ("C above AD", "C below DA"),
    ("C left of D", "C right of D"),
    ("C left of D", "D left of C"),
    ("C above B", "B above C"),
    ("C 在 BD 左侧", "C 在 BD 右侧"),
]


@pytest.mark.parametrize(("first", "second"), OPPOSED)
def test_two_sides_that_exclude_each_other_are_refused_with_both_statements(first: str, second: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        loads(TEXT % f"{first}, {second}")
    fault = refused.value.faults[0]
    assert f"'{second}' and '{first}' contradict each other" in fault.words.en
    assert f"'{second}' 与 '{first}' 互相矛盾" in fault.words.zh
    assert (fault.code, fault.place and fault.place.line) == ("contradiction", 7)


@pytest.mark.parametrize(
    "told", ["C left of BD, C left of BD", "C left of BD, B left of DC", "C left of BD, C right of DB, C above AD"]
)
def test_the_same_side_said_twice_is_no_contradiction(told: str) -> None:
    assert len(loads(TEXT % told).mechanism.branches) >= 1


def test_a_statement_that_names_a_letter_placed_later_is_told_beside_one_that_can_be_read() -> None:
    """It was refused as if nothing had been said of C."""
    two = "1: {AB: 50 mm}, 2: {BC: 140 mm}, 3: {DC: 100 mm}, 4: {BE: 120 mm}, 5: {GE: 90 mm}"
    text = TEXT.replace("1: {AB: 50 mm}, 2: {BC: 140 mm}, 3: {DC: 100 mm}", two).replace(
        "D: [150", "G: [-60 mm, 120 mm], D: [150"
    )
    mech = loads(text % "C right of E, E left of GB").subject
    assert isinstance(mech, Mechanism)
    with pytest.raises(BranchError, match="'C right of E' cannot be read here, for E is placed later; say which: 'C"):
        oracle.solve(mech)
