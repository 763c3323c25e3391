"""One slip that is made throughout is one cause: it is told once, costs once, and what follows from it is right."""

from __future__ import annotations

from functools import cache

import pytest

from vecpoly import Mistake, Problem, Slip, loads, solve
from vecpoly.grading.compare.outcome import Basis
from vecpoly.grading.student import Checked, check_answers
from vecpoly.mistakes import slips

CAM = """
id: offset-cam
title: a cam with an offset follower
device: cam
data:
  follower: {roller: 10 mm, offset: 12 mm}
  r0: 44 mm
  turns: ccw
  motion: [rise 28 mm in 120 deg sine, dwell 60 deg, return in 120 deg cosine, dwell 60 deg]
find: [s0, alpha_rise, alpha_return, alpha_60]
"""
ROCKER = """
id: half
title: half the difference, half the sum
synthesis: crank-rocker
data: {K: 1.25, CD: 80 mm, swing: 40 deg, AD: 100 mm}
find: [AB, BC]
"""
SLIDER = "id: half\ntitle: half\nsynthesis: slider-crank\ndata: {K: 1.6, H: 74 mm, e: 15 mm}\nfind: [AB, BC]"


@cache
def made(text: str) -> Problem:
    return loads(text)


def by(problem: Problem, slip: Slip) -> Checked:
    """The answers of one who makes this slip, checked."""
    solution = solve(problem, by="exact", repeats=0, precise=False, slip=slip)
    return check_answers(problem, {key: f"{one.drawn:.4g}" for key, one in solution.answers.items()})


def test_the_offset_on_the_wrong_side_is_one_cause_of_all_three_pressure_angles() -> None:
    slip = Slip(Mistake.REVERSED, "e")
    assert slip in slips(made(CAM))
    checked = by(made(CAM), slip)
    wrong = [one for one in checked.answers if not one.is_right]
    followed = [one for one in checked.answers if one.basis is Basis.SLIP]
    assert len(wrong) == 1 and len(followed) == 2 and len(checked.marked.slips) == 1
    assert "$e$ is laid off the wrong way" in wrong[0].messages[0].words.en


@pytest.mark.parametrize("text", [ROCKER, SLIDER])
def test_a_half_that_is_forgotten_is_named(text: str) -> None:
    problem = made(text)
    exact = {key: one.exact for key, one in solve(problem, by="exact", repeats=0, precise=False).answers.items()}
    checked = check_answers(problem, {"AB": f"{2 * exact['AB']:.4g}", "BC": f"{exact['BC']:.4g}"})
    crank, coupler = sorted(checked.answers, key=lambda one: one.key)
    assert coupler.is_right and not crank.is_right
    assert "a half forgotten" in crank.messages[0].words.en and "漏除以 2" in crank.messages[0].words.zh
