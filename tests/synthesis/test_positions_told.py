"""Positions of a body in the words of a textbook, and the letters of the linkage that leads it through them."""

from __future__ import annotations

import re

import pytest

import vecpoly
from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from tests.flat_positions import FLAT
from vecpoly.board.paper.marks import Point
from vecpoly.designs.inversion.positions import Positions

POSITIONS = Later(lambda: (name for name in IDS if isinstance(given(name).subject, Positions)))


@each(POSITIONS)
def test_a_position_is_no_quantity_that_equals_a_point_its_point_and_its_line_are_told(name: str) -> None:
    data = given(name).given.data
    told = [one.of("en") for one in data if one.words is not None]
    assert not any(one.symbol.startswith("S_") for one in data)
    subject = given(name).subject
    assert isinstance(subject, Positions)
    assert sum(text.startswith("position ") for text in told) == len(subject.poses)


def test_the_line_by_which_a_body_is_shown_may_have_any_length_and_the_question_says_so() -> None:
    told = [one.of("zh").replace(" ", "") for one in vecpoly.load("four-positions-b").given.data]
    assert "$PQ$的长度任取" in told[0] and told[1] == "位置1：$P$在(0,0)mm、$PQ$的方向角为0°"


def test_no_title_promises_a_good_condition_that_the_report_denies() -> None:
    problem = vecpoly.load("four-positions-b")
    (found,) = (one for one in problem.solve(by="drafting", seed=1).verification if one.broken is None)
    assert found.loose and "良好" not in problem.title.zh and "well" not in problem.title.en


@pytest.mark.parametrize(("name", "valid"), [("four-positions-b", 1), ("four-positions", 1), (FLAT, 3)])
def test_every_linkage_that_answers_has_the_letters_of_its_lengths_on_the_sheet(name: str, valid: int) -> None:
    labels = {mark.label for mark in drawn(name).construction.figures[0].marks if isinstance(mark, Point)}
    for n in range(valid):
        primes = "′" * n
        assert {f"A{primes}", f"B{primes}_1", f"C{primes}_1", f"D{primes}"} <= labels


@pytest.mark.parametrize("name", ["8-9", "8-14"])
def test_the_first_step_names_every_letter_that_it_puts_on_the_sheet_in_both_languages(name: str) -> None:
    construction = drawn(name).construction
    first = next(step for step in construction.steps if step.words.en.startswith("Choose $μ_l$ and draw "))
    marks = construction.figures[0].marks
    put = {mark.label[0] for mark in marks if isinstance(mark, Point) and mark.step == first.number and mark.label}
    said = (re.findall(r"\$(.*?)\$", text) for text in (first.words.zh, first.words.en))
    zh, en = (set(re.findall("[A-Z]", " ".join(symbols))) for symbols in said)
    assert zh == en >= put


@pytest.mark.parametrize("name", ["8-6", "8-11", "three-positions"])
def test_coordinates_of_pins_on_the_body_are_said_to_be_in_its_own_axes(name: str) -> None:
    """B = (0, 0) mm stood beside D = (80, 0) mm as if both were measured in the same axes."""
    subject, data = given(name).subject, given(name).given.data
    assert isinstance(subject, Positions) and subject.body
    (zh,) = (one.of("zh") for one in data if "动坐标系" in one.of("zh"))
    (en,) = (one.of("en") for one in data if "own axes" in one.of("en"))
    assert all(f"${letter}$" in zh and f"${letter}$" in en for letter in subject.body)


@each(POSITIONS)
def test_a_line_of_a_pin_on_the_body_is_told_by_the_line_of_the_body_or_in_its_axes(name: str) -> None:
    subject, data = given(name).subject, given(name).given.data
    assert isinstance(subject, Positions)
    assert not any(
        one.symbol.strip("xy_{}") in ("B", "C") and "′" not in one.symbol for one in data if one.symbol[1:2] == "_"
    )
    assert not any("own axes" in one.of("en") for one in data) or subject.body or any("′" in one.symbol for one in data)
