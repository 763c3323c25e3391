"""What passes the gate is as it promises, measured anew; what cannot pass is demoted aloud, or refused with the
reason."""

from __future__ import annotations

import re
from functools import cache

import numpy as np
import pytest

import vecpoly
from tests.laws import few
from tests.variants.block import TEXT, block, given, piloted
from vecpoly import oracle
from vecpoly.errors import VecpolyError
from vecpoly.names import omega
from vecpoly.variants.conditions import Condition
from vecpoly.variants.frames import FRAMED, filled
from vecpoly.variants.pilot import pilot
from vecpoly.variants.told import demoted, told

VELOCITIES = TEXT.replace(", at_C2B, alpha_3, a_E]", "]")
STUDENTS = few([f"2023{n:04}" for n in range(3)], 2)


@cache
def solved(student: str) -> vecpoly.Solution:
    return vecpoly.solve(given(student).problem, repeats=0)


@pytest.mark.parametrize("student", STUDENTS)
def test_graded_vectors_are_long_enough_on_the_drawn_sheet(student: str) -> None:
    solution = solved(student)
    lengths = [
        answer.reading.mm
        for key, answer in solution.answers.items()
        if answer.drawn_vector is not None and key not in piloted().standard.demoted
    ]
    assert lengths and all(mm is not None and mm > 14.9 for mm in lengths)


@pytest.mark.parametrize("student", STUDENTS)
def test_every_figure_stays_in_its_frame(student: str) -> None:
    figures = solved(student).construction.figures
    assert all(filled(figure) <= 1.0 + 1e-6 for figure in figures if figure.view in FRAMED)


@pytest.mark.parametrize("student", STUDENTS)
def test_no_dead_point_lies_within_ten_degrees(student: str) -> None:
    mech = given(student).problem.mechanism
    near = mech.drive.position + np.radians(np.linspace(-10.0, 10.0, 41))
    assert np.isfinite(oracle.solve(mech, near, strict=False).value(omega("3"))).all()


@pytest.mark.parametrize("student", STUDENTS)
def test_senses_are_those_of_the_problem_itself(student: str) -> None:
    own, answers = (
        vecpoly.solve(p, by="exact", repeats=0, precise=False).answers for p in (block(), given(student).problem)
    )
    assert all(np.sign(own[key].exact) == np.sign(answers[key].exact) for key in ("omega_3", "alpha_3"))


@pytest.mark.parametrize("student", STUDENTS)
def test_whoever_makes_a_slip_is_found_out_by_a_number(student: str) -> None:
    problem, key = given(student).problem, given(student).key
    right = {one.key: one for one in key.quantities if one.asked}
    for slip in vecpoly.slips(problem):
        if slip in piloted().standard.hidden:
            continue
        try:
            wrong = vecpoly.solve(problem, by="exact", repeats=0, precise=False, slip=slip).answers
        except VecpolyError:
            continue  # the figure does not close: the drawing tells
        shifts = [_far(wrong[name]) / one.allowed for name, one in right.items()]
        assert max(shifts) > 1.0, slip


def _far(answer: vecpoly.Answer) -> float:
    if answer.drawn_vector is None or answer.exact_vector is None:
        return abs(answer.drawn - answer.exact)
    return abs(answer.drawn_vector - answer.exact_vector)


def test_the_yield_is_told_and_what_cannot_be_drawn_well_is_demoted_aloud() -> None:
    assert piloted().passed + sum(piloted().failed.values()) == pytest.approx(1.0)
    short = pilot(vecpoly.loads(f"{VELOCITIES}gate: {{vectors: 60 mm, slips: 0}}\n"))
    assert short.standard.demoted
    said = " ".join(words.en for words in (*told("block", short), *demoted(short)))
    assert "% of the draws pass" in said and all(key in said for key in short.standard.demoted)


@pytest.mark.parametrize(
    ("text", "gate", "relax"),
    [
        ("phi: 160 deg .. 200 deg by 5 deg", "", "alike"),
        ("phi: 0 deg .. 355 deg by 5 deg", "gate: {deviation: 0.1 %}", "gate.deviation"),
    ],
)
def test_a_yield_below_one_in_a_hundred_is_refused_with_what_to_relax(text: str, gate: str, relax: str) -> None:
    problem = vecpoly.loads(f"{VELOCITIES.partition('vary:')[0]}vary: {{{text}}}\n{gate}")
    with pytest.raises(VecpolyError) as refused:
        pilot(problem)
    assert refused.value.code == "low-yield"
    assert relax in refused.value.words.en and relax in refused.value.words.zh


@pytest.mark.parametrize("condition", Condition)
def test_what_fails_is_told_apart_from_what_to_change(condition: Condition) -> None:
    change = re.compile("缩小|减小|增大|扩大|去掉|修改")
    assert change.search(condition.remedy.zh) and not change.search(condition.words.zh)
    assert condition.remedy.en != condition.words.en
