"""What one step says another does not say again: it is said shortly, or with it."""

from __future__ import annotations

from itertools import pairwise

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.found import APART, FOUND

READS_A_TURN = ("Find $ω", "Point $")  # ω = v/l, or no velocity and so no ω


@each([*IDS, *FOUND, *APART])
def test_no_two_steps_of_a_problem_say_the_same(name: str) -> None:
    steps = drawn(name).construction.steps
    for language in ("zh", "en"):
        told = [getattr(step.words, language).strip() for step in steps]
        assert len(set(told)) == len(told), sorted({one for one in told if told.count(one) > 1})


@each([*IDS, *FOUND])
def test_the_turnings_of_several_links_that_are_read_in_turn_stand_in_one_step(name: str) -> None:
    for one, other in pairwise(drawn(name).construction.steps):
        read = [step.words.en.startswith(READS_A_TURN) and "ω_" in step.words.zh for step in (one, other)]
        assert not all(read) or one.view != other.view, (one.words.en, other.words.en)
