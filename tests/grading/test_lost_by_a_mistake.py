"""What an exact hand finds nothing for, once a mistake is made, is no witness against it: chance has it as it likes."""

from __future__ import annotations

import numpy as np
import pytest

from tests.grader_proof.judge import Trial, named
from tests.grader_proof.students import drawn_class
from tests.grading.cases import key_of, mutants_of, problem_of
from vecpoly.board.otherwise.amended import Amended
from vecpoly.grading.slips.mutants import Mutant

CENTRE = "P23P34 other centre (P12)"  # by which P_24 falls on P_12, so that ω_2 = v_B/0


def mutant() -> Mutant:
    return next(one for one in mutants_of("3-2") if str(one.slip) == CENTRE)


def test_what_rests_on_a_length_that_vanished_is_lost_and_nothing_else() -> None:
    assert mutant().lost == {"omega_2", "v_C", "v_E2"}
    for name in ("3-2", "curv-1", "golden"):
        for one in mutants_of(name):
            above = {each.key for each in key_of(name).quantities if key_of(name).below(each) & one.lost}
            assert not above & one.values.keys() and not one.lost & one.values.keys()


@pytest.mark.parametrize("seed", range(4))
def test_a_mistake_is_named_whatever_is_written_of_what_it_loses_and_named_once(seed: int) -> None:
    """It was named of every other sheet: where v_C came out in another direction, more was wrong than it explains."""
    trial, made = Trial(problem_of("3-2"), key_of("3-2"), mutants_of("3-2")), mutant()
    cells = drawn_class(trial.problem, trial.key, "pencil", 1, seed, Amended(slip=made.slip)).sheet(
        0, np.random.default_rng(seed)
    )
    sheet = trial.mark(cells | {"omega_2": "4.1 cw", "v_C": "0.4 ∠ 292°", "v_E2": "0.05"})
    assert named(trial, sheet) == [made.slip] and sheet.slips.keys() == {"P_24"}
