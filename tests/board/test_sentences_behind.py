"""A sentence added to a step stands behind what the step says, in good order in both languages."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.algebra.formula import Sym, row
from vecpoly.board.said.behind import behind
from vecpoly.words import Words

TAKEN = re.compile(r"\d[a-z].*")  # b_{3c}, where bc or b_3 c is meant
GLUED = re.compile(r"[.;:][A-Z][a-z]|  |: \([A-Z]|: (?:The|It|Candidate) ")


@pytest.mark.parametrize(
    ("said", "more", "together"),
    [
        ("Measure the gap:", "The gap is 0.1 mm.", "Measure the gap. The gap is 0.1 mm."),
        ("It is 2 mm.", "The sum is zero.", "It is 2 mm. The sum is zero."),
        ("Measure the arm:", " (Too short.)", "Measure the arm. (Too short.)"),
        ("They meet", "; so does $b$.", "They meet; so does $b$."),
        ("Draw it.", "", "Draw it."),
        ("Meet. (At only 12°.)", " (At only 12°.)", "Meet. (At only 12°.)"),
    ],
)
def test_a_colon_before_another_sentence_is_a_full_stop_and_one_blank_parts_the_two(
    said: str, more: str, together: str
) -> None:
    assert behind(Words("", said), Words("", more)).en == together


def test_no_blank_stands_between_two_chinese_sentences() -> None:
    assert behind(Words("量得：", "Measure:"), Words(" 舍去。", " It is rejected.")).zh == "量得。舍去。"
    assert behind(Words("故", "so"), Words(" $ω_3$ = 0。", " $ω_3$ = 0.")).zh == "故 $ω_3$ = 0。"


def test_a_full_stop_is_not_said_already_because_another_sentence_has_one() -> None:
    said = Words("机架为 1。机构的运动确定", "The frame is 1. The motion is determined")
    assert behind(said, Words("。", ".")) == Words(said.zh + "。", said.en + ".")


@each(IDS)
def test_every_step_ends_with_a_full_stop_or_leads_to_a_formula_by_a_colon(name: str) -> None:
    for step in drawn(name).construction.steps:
        assert step.words.zh[-1:] in tuple("。：；）"), step.words.zh
        assert step.words.en[-1:] in tuple(".:;)"), step.words.en


@each(IDS)
def test_no_sentence_of_a_step_runs_into_the_one_before(name: str) -> None:
    for step in drawn(name).construction.steps:
        assert not GLUED.search(step.words.en), step.words.en
        assert "：（" not in step.words.zh and "： " not in step.words.zh, step.words.zh


@each(IDS)
def test_no_letter_of_a_polygon_takes_the_next_letter_into_its_index(name: str) -> None:
    for step in drawn(name).construction.steps:
        for formula in step.words.zh.split("$")[1::2]:
            for one in row(formula).items:
                assert not (isinstance(one, Sym) and one.base.islower() and TAKEN.fullmatch(one.sub)), formula
