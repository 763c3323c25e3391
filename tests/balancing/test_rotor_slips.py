"""The usual mistakes with rotors: each can be made, and gives the answer of one who makes it."""

from __future__ import annotations

from cmath import rect
from math import radians

import pytest

import vecpoly
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve


def made(name: str, mistake: Mistake, key: str) -> Solution:
    """The solution of somebody who makes this mistake; it is among those that can be made."""
    problem = load(name)
    slip = next(one for one in vecpoly.slips(problem) if (one.mistake, one.key) == (mistake, key))
    return solve(problem, by="exact", repeats=0, slip=slip)


def vector(size: float, degrees: float) -> complex:
    return rect(size, radians(degrees))


def test_a_hole_taken_for_a_positive_mass_turns_its_product_round() -> None:
    found = made("6-1", Mistake.REVERSED, "W_1").answers
    hole = found["W_1"].exact
    assert found["W_b"].drawn == pytest.approx(abs(vector(hole, 135) + vector(0.1, 210)))
    assert found["W_b"].drawn != pytest.approx(found["W_b"].exact, rel=0.01)


def test_an_overhung_share_that_is_not_reversed_lands_on_the_other_side() -> None:
    found = made("6-7", Mistake.REVERSED, "W_1I").answers
    right = -(found["W_bI"].exact_vector or 0j) - vector(found["W_1I"].exact, 270)
    assert found["W_bI"].drawn == pytest.approx(abs(right + vector(-found["W_1I"].exact, 270)))


def test_a_share_may_go_to_the_wrong_plane_and_then_the_other_does_too() -> None:
    found = made("6-4", Mistake.SWAPPED, "W_2I").answers
    w = {"1": (4.0, 0.0), "2": (1.5, 3.0), "3": (4 / 3, 8 / 3), "4": (0.0, 3.0)}
    turns = {"1": 120, "2": 240, "3": 300, "4": 30}
    for i, end in enumerate(("I", "II")):
        total = sum(vector(w[name][i], turns[name]) for name in w)
        assert found[f"W_b{end}"].drawn == pytest.approx(abs(total))
    untouched = solve(load("6-4"), by="exact", repeats=0).answers
    assert untouched["W_bI"].drawn == pytest.approx(untouched["W_bI"].exact, rel=1e-9)


def test_no_mistake_can_be_made_in_the_check_alone() -> None:
    assert not [slip for slip in vecpoly.slips(load("6-4")) if slip.key.startswith("C_")]


def test_the_other_meeting_of_two_arcs_is_no_mistake_of_the_centroid() -> None:
    assert not [slip for slip in vecpoly.slips(load("field-four-runs")) if slip.mistake is Mistake.OTHER_MEETING]


def test_a_swap_is_told_in_both_languages() -> None:
    words = Slip(Mistake.SWAPPED, "W_2I", "W_2II").words
    assert "互换" in words.zh and "swapped" in words.en
