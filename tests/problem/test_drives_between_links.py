"""A drive between two links needs a sliding pair between them; a solution that is taken must exist."""

from __future__ import annotations

import pytest

from vecpoly import loads, solve
from vecpoly.errors import ProblemFileError, VecpolyError

FOUR_BAR = """
id: x
title: x
frame: {A: [0 mm, 0 mm], D: [300 mm, 0 mm]}
links: {1: {AB: 100 mm}, 2: {BC: 250 mm}, 3: {CD: 200 mm}}
branch: [C above AD]
input: {link: 2, on: 3, s: 100 mm, v: 10 mm/s}
find: [v_C]
"""


def test_a_travel_is_refused_between_links_that_do_not_slide_on_each_other() -> None:
    with pytest.raises(ProblemFileError, match="links 2 and 3 do not slide on each other") as refused:
        loads(FOUR_BAR)
    assert "2 slides in 3" in str(refused.value) and "input.on" in str(refused.value)


@pytest.mark.parametrize("by", ["exact", "drafting"])
def test_a_solution_that_is_taken_and_is_not_there_is_refused_with_the_number_that_are(by: str) -> None:
    text = "id: x\ntitle: x\nsynthesis: crank-rocker\ndata: {K: 1.32, CD: 92 mm, swing: 41 deg, AB: 25 mm, take: 3}\n"
    with pytest.raises(VecpolyError, match=r"take: 3.*write 1 to 2"):
        solve(loads(f"{text}find: [BC, AD]\n"), by=by)
