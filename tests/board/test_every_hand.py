"""One drawing by many hands, each with its own slip, says what as many drawings say one by one."""

from __future__ import annotations

import numpy as np
import pytest

from tests.laws import few
from vecpoly import load, slips
from vecpoly.board.hand import hand, steady
from vecpoly.board.otherwise.amended import AS_DRAWN, Amended
from vecpoly.errors import VecpolyError
from vecpoly.methods.every_hand import by_every_hand
from vecpoly.solution import constructed, solve


@pytest.mark.parametrize("name", few(["3-9", "3-7a", "A-27"], 3))
def test_every_slip_at_once_is_every_slip_alone(name: str) -> None:
    problem = load(name)
    made = slips(problem)
    right = constructed(problem, hand("exact"), AS_DRAWN).construction
    found = by_every_hand(problem, steady(len(made)), right, Amended(each=made))
    compared = 0
    for number, slip in enumerate(made, 1):
        try:
            alone = constructed(problem, hand("exact"), Amended(slip=slip)).construction.readings
        except VecpolyError:
            continue
        for key, reading in alone.items():
            mine = np.broadcast_to(found[key], (len(made) + 1,))[number]
            theirs = reading.scalar if reading.vector is None else reading.vector
            assert mine == pytest.approx(theirs, rel=1e-7, abs=1e-9), (str(slip), key)
            compared += 1
    assert compared > 3 * len(made)


def test_what_one_hand_does_wrongly_no_other_does() -> None:
    problem = load("3-9")
    made = slips(problem)
    right = constructed(problem, hand("exact"), AS_DRAWN).construction
    found = by_every_hand(problem, steady(len(made)), right, Amended(each=made))
    for key, reading in right.readings.items():
        nominal = np.broadcast_to(found[key], (len(made) + 1,))[0]
        assert nominal == pytest.approx(reading.scalar if reading.vector is None else reading.vector)


@pytest.mark.parametrize("name", few(["peaucellier", "scissor-lift", "pantograph"], 3))
@pytest.mark.parametrize("seed", few([1, 3, 8], 3))
def test_a_pencil_draws_what_stands_on_a_line_with_its_own_error(name: str, seed: int) -> None:
    """One meeting point of Peaucellier's rhombus is B itself: drawn a hair beside B, it is no second assembly."""
    found = solve(load(name), by="pencil", seed=seed, repeats=0).answers
    off = [abs(answer.deviation) / abs(answer.exact) for answer in found.values() if answer.exact and answer.deviation]
    assert off and 0 < max(off) < 0.6
