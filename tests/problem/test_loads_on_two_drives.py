"""Loads on a mechanism of two drives are refused with the true reason, and the way out that is told is right."""

from __future__ import annotations

import pytest

from vecpoly.errors import ProblemFileError
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

TEXT = """
id: five-bar
title: t
frame: {{A: [0 mm, 0 mm], {frame}}}
links: {{1: {{AB: 50 mm}}, 2: {{BC: 140 mm}}, 3: {{EC: 100 mm}}{link}}}
input: {drives}
branch: [C left of BE]
loads: {{Q: {{on: 3, at: C, size: 10 N, direction: 0 deg}}, {unknown}}}
"""
FIRST, SECOND = "{link: 1, phi: 60 deg, omega: 5 rad/s}", "{link: 4, phi: 80 deg, omega: 3 rad/s}"
M_1, M_4 = 'M_1: {on: 1, size: "?"}', 'M_4: {on: 4, size: "?"}'
HELD = "E: [158.682408883 mm, 49.240387651 mm]"  # D + 50 mm at 80 deg


def five_bar(unknown: str, drives: str = f"[{FIRST}, {SECOND}]") -> Problem:
    return loads(TEXT.format(frame="D: [150 mm, 0 mm]", link=", 4: {DE: 50 mm}", drives=drives, unknown=unknown))


def refusal(unknown: str) -> ProblemFileError:
    with pytest.raises(ProblemFileError) as refused:
        five_bar(unknown)
    return refused.value


@pytest.mark.parametrize("unknown", [f"{M_1}, {M_4}", M_1])
def test_two_drives_need_two_balancing_loads_and_the_refusal_says_so(unknown: str) -> None:
    error = refusal(unknown)
    assert "2 drives are given (1, 4), so the mechanism has 2 degrees of freedom and 2 loads must balance it" in str(
        error
    )
    assert "for M_1 write the points of link 4 into the frame" in str(error)
    assert "机构有 2 个自由度" in error.words.zh
    assert "求 M_1 时，把构件 4 的各点按此位置写入 frame" in error.words.zh


def test_the_drive_that_is_kept_is_that_of_the_load_which_is_sought() -> None:
    assert "for M_4 write the points of link 1 into the frame" in str(refusal(f"{M_4}, {M_1}"))


def test_what_is_found_with_the_other_drive_held_balances_the_drive() -> None:
    """Two forces at C along the rods hold Q; that in BC turns the crank."""
    held = loads(TEXT.format(frame=HELD, link="", drives=FIRST, unknown=M_1))
    solution = solve(held, by="exact", repeats=0)
    assert solution.answers["M_1"].drawn == pytest.approx(0.13059994589966661, rel=1e-9)
    assert solution.answers["M_1"].exact == pytest.approx(0.13059994589966661, rel=1e-9)
