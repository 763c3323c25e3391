"""Claims about numbers with a comma, and coordinates in braces: what was meant is told, in place of what YAML made of
it."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.errors import FaultError, ProblemFileError
from vecpoly.problem.load import loads
from vecpoly.units.reading import Dim, pure, read

FOUR_BAR = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 170 mm}, 3: {DC: 130 mm}}
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
branch: [C left of BD]
find: [omega_3]
"""
BLOCK = FOUR_BAR.replace("links: {1: {AB: 50 mm}", "links:\n  1:\n    AB: 50 mm\n  2: {BC: 170 mm}\n#")


@pytest.mark.parametrize(("text", "old", "new", "remedy", "line"), [
    (FOUR_BAR, "50 mm", "50,5 mm", "write 50.5 mm", 5),
    (FOUR_BAR, "50 mm", "50，5 mm", "write 50.5 mm", 5),
    (FOUR_BAR, "50 mm", "'50,5 mm'", "write 50.5 mm", 5),
    (FOUR_BAR, "50 mm", "1,050 mm", "write 1.050 mm, or 1050 mm if it parts thousands", 5),
    (BLOCK, "50 mm", "50,5 mm", "write 50.5 mm", 7),
    (FOUR_BAR, "5 rad/s ccw", "5,5 rad/s ccw", "write 5.5", 6),
    (FOUR_BAR, "[200 mm, 0 mm]", "[200,5 mm, 0 mm]", "'200,5 mm, 0 mm' has decimal commas; write [200.5 mm, 0 mm]", 4),
    (FOUR_BAR, "[200 mm, 0 mm]", "[200,5 mm, -0,5 mm]", "write [200.5 mm, -0.5 mm]", 4),
    (FOUR_BAR, "[0 mm, 0 mm]", "{0 mm, 0 mm}", "coordinates stand in square brackets; write [0 mm, 0 mm]", 4),
    (FOUR_BAR, "[200 mm, 0 mm]", "{200,5 mm, 0 mm}", "write [200.5 mm, 0 mm]", 4),
])  # fmt: skip
def test_a_comma_for_a_point_is_told_with_the_number_as_it_should_be(
    text: str, old: str, new: str, remedy: str, line: int
) -> None:
    with pytest.raises(ProblemFileError, match=re.escape(remedy)) as refused:
        loads(text.replace(old, new, 1))
    (fault,) = refused.value.faults
    assert fault.place is not None and fault.place.line == line


@given(st.integers(0, 9999), st.integers(0, 99), st.sampled_from(["", "-", "−", "+"]))
def test_any_number_with_a_comma_is_refused_with_the_same_number_with_a_point(whole: int, part: int, sign: str) -> None:
    with pytest.raises(FaultError, match=re.escape(f"write {sign}{whole}.{part} mm")):
        read(f"{sign}{whole},{part} mm", Dim.LENGTH)
    with pytest.raises(FaultError, match=re.escape(f"write {sign}{whole}.{part}")):
        pure(f"{sign}{whole},{part}", "0.1")


def test_values_and_words_beside_each_other_without_a_space_are_no_decimal_commas() -> None:
    tight = FOUR_BAR.replace("[200 mm, 0 mm]", "[200 mm,0 mm]").replace("phi: 70 deg, omega", "phi: 70 deg,omega")
    assert loads(tight).mechanism == loads(FOUR_BAR).mechanism
    with pytest.raises(ProblemFileError, match="twice"):
        loads(FOUR_BAR.replace("50 mm}", "50 mm, AB: 50 mm}"))


@pytest.mark.parametrize("key", ["[5 mm]", "{5: 6}", "? 5"])
def test_a_number_before_a_key_that_is_no_word_is_no_decimal_comma(key: str) -> None:
    with pytest.raises(ProblemFileError, match="line 5"):
        loads(FOUR_BAR.replace("AB: 50 mm", f"AB: 50,{key}"))
