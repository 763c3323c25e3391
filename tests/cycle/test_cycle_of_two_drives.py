"""Of two drives one is taken through a cycle: that is said, and a course report refused with its reason."""

from __future__ import annotations

import pytest

from vecpoly.cycle import cycle, facts
from vecpoly.cycle.facts.sentences import sentences
from vecpoly.errors import NotAskedError
from vecpoly.findings.study.study import study
from vecpoly.problem.load import loads
from vecpoly.solution import solve

FIVE_BAR = """
id: five-bar
title: t
frame: {A: [0 mm, 0 mm], D: [150 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 140 mm}, 3: {EC: 100 mm}, 4: {DE: 50 mm}}
input: [{link: 1, phi: 60 deg, omega: 5 rad/s}, {link: 4, phi: 80 deg, omega: 3 rad/s}]
branch: [C left of BE]
find: [omega_3, v_C, a_C]
"""


def test_a_course_report_of_two_drives_is_refused_with_the_drives() -> None:
    with pytest.raises(NotAskedError, match=r"has 2 \(links 1, 4\); write its solution report") as refused:
        study(solve(loads(FIVE_BAR), repeats=0, precise=False))
    assert "有 2 个（构件 1、4）" in refused.value.words.zh


def test_a_cycle_says_that_the_other_drive_stands_where_it_is_given() -> None:
    turn = cycle(loads(FIVE_BAR), n=37)
    said = " ".join(words.en for words in sentences(turn, facts(turn)))
    assert "link 4 stands where it is given in every row" in said
