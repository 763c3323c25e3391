"""Claims about the cycle of loads that depend on place and speed: right at every angle, extremes split at corners."""

from __future__ import annotations

import numpy as np
import pytest

from tests.lawful import COIL, CUT, SPRING, slider
from tests.laws import few
from vecpoly.cycle import cycle, extremes
from vecpoly.cycle.facts.force_words import force_sentences
from vecpoly.cycle.facts.found import facts
from vecpoly.oracle.forces.laws.corners import corners
from vecpoly.oracle.forces.laws.period import constant_size
from vecpoly.problem.load import load


def test_a_window_s_column_is_the_force_inside_and_nothing_outside() -> None:
    problem = slider(CUT, COIL, find="F")
    assert problem.loads is not None
    turn = cycle(problem, 721)
    edges = [q for q in corners(problem.mechanism, problem.loads) if 0.1 < q < np.pi - 0.1]
    inside = (turn.phi > edges[0]) & (turn.phi < edges[1])
    assert np.array_equal(turn.column("F"), np.where(inside, 3000.0, 0.0))


@pytest.mark.parametrize("entries", few([(CUT,), (CUT, SPRING), (CUT, COIL)], 2))
def test_the_extremes_of_a_jumping_column_are_its_limits_at_the_corners(entries: tuple[str, ...]) -> None:
    problem = slider(*entries)
    assert problem.loads is not None
    turn = cycle(problem)
    cuts = corners(problem.mechanism, problem.loads)
    phi = np.unique(np.concatenate([np.linspace(0, 2 * np.pi, 100_001), cuts - 1e-9, cuts + 1e-9]))
    values = np.asarray(turn.at("M_1", phi), np.float64)
    found = extremes(turn, "M_1")
    assert found.highest is not None and found.lowest is not None
    assert found.highest.value == pytest.approx(values.max(), rel=1e-6)
    assert found.lowest.value == pytest.approx(values.min(), rel=1e-6, abs=1e-6)


def test_a_four_stroke_card_gives_a_cycle_of_two_turns_and_the_links_keep_theirs() -> None:
    problem = load("engine-card")
    turn = cycle(problem, 361)
    assert len(turn.phi) == 721 and turn.high - turn.low == pytest.approx(4 * np.pi) == turn.period
    first, second = np.split(np.asarray(turn.real("F"))[:720], 2)
    assert first[90] > 1000 > abs(second[90])
    assert [stroke.upper.phi for stroke in facts(turn).strokes] == pytest.approx([0.0], abs=1e-6)
    highest = extremes(turn, "M_b").highest
    assert highest is not None and 2 * np.pi < highest.phi < 4 * np.pi


def test_the_constant_over_the_period_is_told_with_the_cycle() -> None:
    problem = load("shaper-cut")
    assert problem.loads is not None
    size = constant_size(problem.mechanism, problem.loads)
    told = " ".join(words.en for words in force_sentences(cycle(problem)))
    assert f"the constant moment $M_{{d}}$ = {size:.6g} N·m" in told and size > 0


@pytest.mark.parametrize("name", ["shaper-cut", "engine-card"])
def test_the_period_of_a_constant_moment_is_told_in_turns_of_the_drive(name: str) -> None:
    turn = cycle(load(name))
    turns = round(turn.period / (2 * np.pi))
    told = " ".join(words.en + words.zh for words in force_sentences(turn))
    assert f"Over the period ({'one turn' if turns == 1 else f'{turns} turns'})" in told
    assert f"一个运动周期（{'一周' if turns == 1 else f'{turns} 周'}）" in told
