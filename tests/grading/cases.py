"""Problems, keys and sheets that claims about grading start from."""

from __future__ import annotations

from functools import cache

from vecpoly import Problem, load, loads
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import AnswerKey
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.marking.marker import mark
from vecpoly.grading.rules import USUAL_RULES, Rules
from vecpoly.grading.sheet import sheet_of
from vecpoly.grading.slips.mutants import Mutant, mutants

FOUR_BAR = """
id: four-bar-golden
title: {zh: 铰链四杆机构, en: Four-bar linkage}
frame: {A: [0 mm, 0 mm], D: [300 mm, 0 mm]}
links:
  1: {AB: 100 mm}
  2: {BC: 250 mm}
  3: {CD: 200 mm}
branch: [C above AD]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
scales: {mu_l: 0.002 m/mm, mu_v: 0.02 (m/s)/mm, mu_a: 0.2 (m/s^2)/mm}
find: [v_C, v_CB, omega_2, omega_3, an_CB, a_C, alpha_2, alpha_3]
"""


TWO_SOLUTIONS = """
id: two-solutions
title: {zh: 两个解, en: Two solutions}
synthesis: crank-rocker
data: {K: 1.32, CD: 92 mm, swing: 41 deg, AB: 25 mm}
find: [BC, AD]
"""
_WRITTEN = {"golden": FOUR_BAR, "two-solutions": TWO_SOLUTIONS}


@cache
def problem_of(name: str) -> Problem:
    """A problem of the library, or one that is written here: the four-bar linkage of the golden example."""
    return loads(_WRITTEN[name]) if name in _WRITTEN else load(name)


@cache
def key_of(name: str) -> AnswerKey:
    """Its key."""
    return answer_key(problem_of(name))


@cache
def mutants_of(name: str) -> tuple[Mutant, ...]:
    """What every slip makes of it."""
    return mutants(problem_of(name), key_of(name))


def marked(name: str, cells: dict[str, str], rules: Rules = USUAL_RULES) -> Marked:
    """A sheet with its marks."""
    return mark(problem_of(name), key_of(name), lambda: mutants_of(name), sheet_of(key_of(name), cells), rules)


def told(sheet: Marked, key: str) -> list[str]:
    """The names of the sentences about one answer."""
    return [one.id.value for one in sheet[key].messages]
