"""A key follows from the acts of a construction; its tolerances from what a student's hand scatters by."""

from __future__ import annotations

import json
from functools import cache
from math import remainder

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.laws import few, often
from vecpoly import load, loads, solve
from vecpoly.board.acts import Measure
from vecpoly.board.hand import hand, scatter
from vecpoly.errors import UnknownNameError, VecpolyError
from vecpoly.grading.allowance import CAD, STUDENT
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import AnswerKey, Kind, beside, spot_letters
from vecpoly.problem.asked.checks import is_check

SEVERAL = few(("3-9", "3-12", "A-27", "3-2", "4-3a", "4-5", "C-inertia", "5-2", "tipper", "slider-crank-dynamic"), 2)


@cache
def key_of(problem: str) -> AnswerKey:
    return answer_key(load(problem))


@pytest.mark.parametrize("problem", SEVERAL)
def test_a_key_has_all_that_is_asked_with_the_exact_value(problem: str) -> None:
    """But for what only checks another quantity."""
    answers = solve(load(problem), by="exact", repeats=0, precise=False).answers
    asked = {one.key: one.exact for one in key_of(problem).quantities if one.asked}
    assert asked == {key: answer.exact for key, answer in answers.items() if not is_check(key, answers)}


@given(st.floats(-720, 720), st.floats(-720, 720))
def test_the_direction_of_a_line_is_written_within_a_right_angle_of_any_other(degrees: float, other: float) -> None:
    found = beside(degrees, other)
    assert abs(found - other) <= 90 and abs(remainder(found - degrees, 180)) < 1e-9


@pytest.mark.parametrize("problem", SEVERAL)
def test_a_key_survives_json(problem: str) -> None:
    key = key_of(problem)
    assert AnswerKey.from_json(json.loads(json.dumps(key.as_json()))) == key


@pytest.mark.parametrize("problem", SEVERAL)
def test_every_quantity_is_named_once_and_rests_on_those_before_it(problem: str) -> None:
    names = [one.key for one in key_of(problem).quantities]
    assert len(set(names)) == len(names)
    for n, one in enumerate(key_of(problem).quantities):
        assert set(one.needs) <= set(names[:n])
        assert one.line in ("", *one.needs)


def _act_of(key: str) -> str:
    """By what the acts know a quantity: a place by its letters."""
    return spot_letters(key) if key.startswith(("p_", "P_")) else key


@pytest.mark.parametrize("problem", ["3-9", "3-12", "A-27"])
def test_what_a_quantity_needs_is_what_its_act_depends_on(problem: str) -> None:
    construction = solve(load(problem), by="exact", repeats=0, precise=False).construction
    for one in key_of(problem).quantities:
        assert set(map(_act_of, one.needs)) <= set(construction.depends(one.key))


@pytest.mark.parametrize("problem", SEVERAL)
def test_a_tolerance_lies_between_its_floor_and_its_cap(problem: str) -> None:
    for one in key_of(problem).quantities:
        assert one.allowed > 0 or one.kind is Kind.YES_NO
        if one.allowed_mm is not None and one.kind in (Kind.READING, Kind.VECTOR):
            assert one.allowed_mm >= STUDENT.floor * (1 - 1e-9)
            assert one.demoted or one.allowed_mm <= STUDENT.cap * (1 + 1e-9)


@pytest.mark.parametrize("problem", ["3-9", "A-27", "4-3a"])
def test_only_what_scatters_by_more_than_its_share_is_demoted(problem: str) -> None:
    for one in key_of(problem).quantities:
        if one.exact:
            assert one.demoted == (STUDENT.k * one.sigma > STUDENT.share * abs(one.exact))


def test_a_pencil_hand_stays_within_the_tolerance_nineteen_times_in_twenty() -> None:
    problem, key = load("3-9"), key_of("3-9")
    seen = [
        [abs(answer.drawn - answer.exact) <= key[answer.key].allowed for answer in solution.answers.values()]
        for solution in (solve(problem, by="pencil", seed=seed, repeats=0, precise=False) for seed in range(often(20)))
    ]
    share = np.mean(seen)
    assert share >= 0.95


def test_a_tolerance_is_no_wider_than_a_sloppy_hand_would_notice() -> None:
    problem, key = load("3-9"), key_of("3-9")
    skill = STUDENT.hand(0)
    assert skill.nominal.dividers == 0  # the key itself is drawn exactly
    assert hand("pencil").nominal.dividers < STUDENT.plot
    assert key["bc2"].allowed < 0.05 * key["bc2"].exact
    assert answer_key(problem, CAD)["bc2"].allowed < 0.2 * key["bc2"].allowed


def test_a_reading_keeps_the_unit_of_paper_and_knows_its_scale() -> None:
    key = key_of("3-9")
    read, value = key["bc2"], key["v_C2B"]
    assert (read.kind, read.unit, read.mu, value.line) == (Kind.READING, "mm", "mu_v", "bc2")
    assert value.mm == pytest.approx(read.exact, rel=1e-9)
    assert value.exact == pytest.approx(read.exact * key.scales["mu_v"], rel=1e-9)
    assert value.allowed == pytest.approx(read.allowed * key.scales["mu_v"], rel=1e-6)


def test_the_usual_rubric_gives_eight_points_for_velocities_and_twelve_for_accelerations() -> None:
    key = key_of("3-9")
    totals = {
        block: sum(one.points.total for one in key.quantities if one.block == block)
        for block in ("velocity", "acceleration")
    }
    assert totals["velocity"] + key.stated["mu_v"] == pytest.approx(8)
    assert totals["acceleration"] + key.stated["mu_a"] == pytest.approx(12)


def test_what_is_no_key_is_refused_with_where_it_fails() -> None:
    data = key_of("3-9").as_json()
    data["quantities"][3]["kind"] = "guess"
    with pytest.raises(VecpolyError, match=r"quantities\.3\.kind"):
        AnswerKey.from_json(data)
    with pytest.raises(UnknownNameError, match="v_Q"):
        key_of("3-9")["v_Q"]


def test_a_length_without_letters_is_asked_of_nobody() -> None:
    motion = "[rise 12 deg in 85 deg 3-4-5, dwell 24 deg, return in 138 deg 3-4-5, dwell 113 deg]"
    follower = "{flat: yes, arm: {OA: 91 mm, face: 7 mm, side: left}}"
    data = f"{{follower: {follower}, r0: 27 mm, motion: {motion}}}"
    cam = loads(f"id: t\ntitle: t\ndevice: cam\ndata: {data}\nfind: [rho_min, undercut]\n")
    read = [act for act in solve(cam, by="exact", repeats=0, precise=False).construction.acts if act.verb]
    assert any(isinstance(act, Measure) and not act.key for act in read)
    assert all(one.key for one in answer_key(cam).quantities)


def test_the_scatter_of_hands_that_run_away_is_a_number_and_any_other_is_numpy_s_to_the_bit() -> None:
    near = np.array([2.1, 1.9, 2.05, 0.0, -3e-9])
    assert scatter(near) == np.std(near) and scatter(near[3:4]) == 0.0
    with np.errstate(over="raise"):
        assert scatter(near * 1e200) == pytest.approx(np.std(near) * 1e200)


def test_what_is_nothing_but_rounding_may_be_as_large_as_hands_make_it() -> None:
    """Unbalanced forces of an engine that is balanced: 10^-11 N by computation, tens of N by any drawing."""
    key = key_of("engine-three")
    for name in ("F_I", "F_II"):
        assert key[name].exact == 0 and key[name].allowed == pytest.approx(2 * key[name].sigma) and key[name].sigma > 10
        assert not key[name].demoted


def test_a_length_whose_letters_another_figure_has_the_other_way_round_is_told_by_its_figure() -> None:
    """bc of the velocities, and cb of the card of forces: somebody's own cb is no velocity."""
    read = {one.key for one in key_of("press-flywheel").quantities if one.kind is Kind.READING}
    assert {"velocity:bc", "indicator indicator:cb", "pc"} <= read
