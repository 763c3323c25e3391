"""What changes nothing is told: a question that is put twice, a gate of no variants."""

from __future__ import annotations

import pytest

import vecpoly

FILE = """
id: t
title: t
frame: {A: [0 mm, 0 mm], E: [120 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {BC: 70 mm}, 3: {CD: 65 mm}, 4: {ED: 40 mm}}
input: [{link: 1, phi: 60 deg, n: 30 r/min ccw}, {link: 4, phi: 80 deg, omega: 3 rad/s cw}]
branch: [C above BD]
"""
VARY = "vary: {AB: 28 mm .. 32 mm by 1 mm}\n"


def told(more: str) -> str:
    return " ".join(words.en for words in vecpoly.loads(FILE + more).warnings)


@pytest.mark.parametrize("more", ["find: [v_C, omega_2, v_C]\n", "find: [v_C, v_C]\n" + VARY])
def test_a_question_that_is_put_twice_is_told(more: str) -> None:
    assert "v_C is asked twice" in told(more)


@pytest.mark.parametrize(
    "find", ["v_C, omega_2, v_C", "P_13, centres, v_C", "centres, P_14, P_13", "v_C, ω_2, omega_2"]
)
def test_and_is_answered_once(find: str) -> None:
    asked = [ask.rel.key for ask in vecpoly.loads(FILE + f"find: [{find}]\n").asks]
    assert len(asked) == len(set(asked))


def test_questions_that_differ_are_none_that_is_put_twice() -> None:
    assert told("find: [v_C, a_C, {point: X2, on: 2, velocity: 0}, {point: Y2, on: 2, velocity: 0}]\n") == ""


def test_a_gate_without_variants_is_told_and_one_with_them_is_not() -> None:
    assert "the gate decides nothing" in told("find: [v_C]\ngate: {vectors: 10 mm}\n")
    assert told("find: [v_C]\ngate: {vectors: 10 mm}\n" + VARY) == ""


@pytest.mark.parametrize("name", ["n_4", "ω_4", "omega_4"])
def test_the_speed_of_each_of_several_drives_may_be_varied_by_any_of_its_names(name: str) -> None:
    problem = vecpoly.loads(FILE + f"find: [v_C]\nvary: {{{name}: 1 rad/s cw .. 4 rad/s cw by 1 rad/s}}\n")
    assert [one.name for one in problem.ranges] == ["omega_4"]
