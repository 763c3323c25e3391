"""Claims about what is read although the manual writes it otherwise, and what is said of what is not."""

from __future__ import annotations

import re

import pytest

from vecpoly.errors import ProblemFileError, UnknownNameError
from vecpoly.grading.reading.symbol import keyed
from vecpoly.problem.load import loads

FOUR_BAR = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 170 mm}, 3: {DC: 130 mm}}
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
branch: [C left of BD]
find: [omega_3]
"""


@pytest.mark.parametrize("pair", ["(0 mm, 0 mm)", "（0 mm，0 mm）", "( 0 mm ,0 mm )", '"(0 mm, 0 mm)"'])
def test_coordinates_may_stand_in_parentheses(pair: str) -> None:
    assert loads(FOUR_BAR.replace("[0 mm, 0 mm]", pair)).mechanism == loads(FOUR_BAR).mechanism
    block = FOUR_BAR.replace(
        "frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}", f"frame:\n  A: {pair}  # origin\n  D: (200 mm, 0 mm)"
    )
    assert loads(block).mechanism == loads(FOUR_BAR).mechanism


@pytest.mark.parametrize(
    ("written", "key"), [("aⁿ_CB", "an_CB"), ("aᵗ_CB", "at_CB"), ("aⁿ_C", "an_C"), ("ω_3", "omega_3")]
)
def test_parts_of_an_acceleration_may_be_written_as_superscripts(written: str, key: str) -> None:
    assert [ask.rel.key for ask in loads(FOUR_BAR.replace("[omega_3]", f"[{written}]")).asks] == [key]


@pytest.mark.parametrize(
    ("old", "new", "remedy"),
    [
        ("branch: [C left of BD]", "branch: {C: left of BD}", "write [C left of BD]"),
        ("find: [omega_3]", "find: {omega_3: 1}", "e.g. [v_C, a_C]"),
        ("[0 mm, 0 mm]", "(0 mm, 0 mm", "outside of brackets"),
        ("find: [omega_3]", "find: [a_CB^n]", "did you mean 'an_CB'"),
    ],
)
def test_what_is_written_in_another_form_is_told_with_what_to_write(old: str, new: str, remedy: str) -> None:
    with pytest.raises(ProblemFileError, match=re.escape(remedy)):
        loads(FOUR_BAR.replace(old, new))


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("[0 mm, 0 mm]", "0 mm, 0 mm", "frame.0 mm: '0 mm'"),
        ("branch: [C left of BD]", "guesses: {C: 100 mm, 50 mm}", "guesses.50 mm: '50 mm'"),
    ],
)
def test_coordinates_without_brackets_are_told_at_both_ends_of_the_comma(old: str, new: str, place: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        loads(FOUR_BAR.replace(old, new, 1))
    first, second = (fault.words.en for fault in refused.value.faults)
    assert "two values are expected here, in brackets" in first and "outside of brackets" not in first
    assert f"{place} stands outside of brackets; write coordinates as A: [100 mm, 0 mm]" in second


@pytest.mark.parametrize("name", ["B", "Δ"])
def test_a_point_that_has_one_number_is_told_to_have_two_and_nothing_of_brackets(name: str) -> None:
    with pytest.raises(ProblemFileError, match="two values are expected here") as refused:
        loads(FOUR_BAR.replace("{A: [0 mm, 0 mm]", f"{{A: [0 mm, 0 mm], {name}: 5 mm", 1))
    assert "outside" not in str(refused.value)


@pytest.mark.parametrize(("shape", "right"), [("rod", "2 passes through 3"), ("slot", "3 slides in 2")])
def test_a_block_that_passes_through_its_rod_is_told_the_other_way_round(shape: str, right: str) -> None:
    text = FOUR_BAR.replace(
        "links: {1: {AB: 50 mm}, 2: {BC: 170 mm}, 3: {DC: 130 mm}}",
        f"links: {{1: {{AB: 50 mm}}, 2: {{{shape}: B}}, 3: {{block: D}}}}\njoints: [3 passes through 2]",
    )
    with pytest.raises(ProblemFileError, match=right):
        loads(text.replace("branch: [C left of BD]\n", ""))


@pytest.mark.parametrize("written", ['"？"', "“？”", "'？'", '" ? "'])
def test_a_question_mark_of_a_chinese_keyboard_is_the_unknown_load(written: str) -> None:
    told = f"loads: {{M_3: {{on: 3, size: 9 N*m}}, M_1: {{on: 1, size: {written}}}}}\n"
    found = loads(FOUR_BAR.replace("[omega_3]", "[M_1]") + told).loads
    assert found is not None and found.unknown.name == "M_1"


def test_a_bar_that_is_asked_may_be_called_by_its_ends_either_way_round() -> None:
    text = "id: t\ntitle: t\nsynthesis: crank-rocker\ndata: {K: 1.4, CD: 56 mm, swing: 44 deg, AB: 16 mm}\n"
    asked = loads(text + "find: [DC, CB_2]\n")
    assert [ask.rel.key for ask in asked.asks] == ["CD", "BC_2"]
    assert keyed("DC", ["CD", "BC_2"]) == "CD" and keyed("l_{CB}2", ["CD", "BC_2"]) == "BC_2"
    with pytest.raises(UnknownNameError):
        keyed("v_BC", ["v_CB"])  # the opposite vector
