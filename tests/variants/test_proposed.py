"""Ranges that are proposed: round steps about what is written, of what the text does not tell, that pass the gate."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from tests.laws import few
from vecpoly.cli.app import app
from vecpoly.errors import VecpolyError
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.library import library
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.problem.values.vary import data_of, parameters, vary
from vecpoly.variants import draw
from vecpoly.variants.draw import Drawn, Draws
from vecpoly.variants.judge import Standard
from vecpoly.variants.pilot import SETS, pilot
from vecpoly.variants.proposing import chosen
from vecpoly.variants.proposing.chosen import ENOUGH, free, proposal, ranged
from vecpoly.variants.proposing.numbers import Span, numbers, round_step, spread
from vecpoly.variants.told import said_already

PROPOSED = tuple(entry.id for entry in library())
VALUES = st.decimals(min_value="0.01", max_value=9999, places=2)
SPAN = re.compile(r"(-?[\d.]+) mm \.\. (-?[\d.]+) mm by ([\d.]+) mm")


@given(VALUES)
def test_a_step_is_one_two_or_five_times_a_power_of_ten_and_no_round_one_is_nearer(size: Decimal) -> None:
    step = round_step(size)
    assert f"{step:e}"[0] in "125" and step / size < 2 and size / step < Decimal(2)


@given(VALUES, st.integers(1, 8), st.sampled_from([1, -1]))
def test_a_range_goes_as_far_to_either_side_and_never_through_nought(value: Decimal, steps: int, sign: int) -> None:
    found = SPAN.fullmatch(spread(f"{sign * value} mm", steps))
    if found is None:
        return
    low, high, step = map(Decimal, found.groups())
    assert low + high == 2 * sign * value and low * high > 0
    assert (high - low) % step == 0 and 1 <= (high - low) / step / 2 <= steps


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("30 mm", "27 mm .. 33 mm by 1 mm"),
        ("10 rad/s cw", "8.5 rad/s cw .. 11.5 rad/s cw by 0.5 rad/s"),
        ("17", "14 .. 20 by 1"),
        ("0 mm", ""),
        ("?", ""),
        ("ccw", ""),
        ("7 um at 63 deg", ""),
        ("2", ""),
        ("31.7558034016695 deg", ""),
    ],
)
def test_a_range_is_written_as_a_problem_file_has_it(written: str, said: str) -> None:
    assert spread(written, 3) == said


@pytest.mark.parametrize("name", ["3-9", "8-1", "5-3"])
def test_what_is_proposed_passes_the_gate_and_is_nothing_that_the_text_tells(name: str) -> None:
    problem = load(name)
    found = proposal(problem, 20)
    one = ranged(problem, found.ranges)
    again = pilot(one)
    assert again.passed >= ENOUGH and again.room == found.pilot.room
    assert not list(said_already(one)) and {one.name for one in found.ranges} <= {*parameters(problem)}


def test_more_students_have_at_least_as_many_numbers_that_vary() -> None:
    few, many = (proposal(load("8-1"), students) for students in (2, 5000))
    assert few.ranges == many.ranges[: len(few.ranges)] and len(few.ranges) < len(many.ranges)
    assert 2 <= few.pilot.room <= many.pilot.room


def test_the_drive_comes_first_and_scales_friction_and_guesses_stay() -> None:
    for name in ("3-9", "4-3a", "shaper-flywheel"):
        names = [spans[0].name for spans in numbers(load(name).written.data)]  # type: ignore[union-attr]
        assert names[0] == "phi" and not [one for one in names if re.match(r"mu_|rho|J_|direction|phi_\d-", one)]


BOUND = {
    "winch-gears": {"r_1", "r_2", "x_B"},  # the radii of the gears make the distance of the axes
    "field-four-runs": {"m_1", "m_2", "r_1"},  # the same trial weight in every run
    "cam-moves-arm": {"AB", "r_3", "x_A"},  # the follower is that of the cam problem
    "engine-four": {"order_2", "order_3"},  # each cylinder fires once
}


@pytest.mark.parametrize("name", few(tuple(BOUND), 2))
def test_a_number_that_is_bound_to_others_is_not_varied_by_itself(name: str) -> None:
    problem = load(name)
    named = {one.name for spans in numbers(data_of(problem)) for one in spans}
    varied = {one.name for spans in free(problem) for one in spans}
    assert named >= BOUND[name] and not varied & BOUND[name] and varied < named


@pytest.mark.parametrize("name", few(PROPOSED, 12))
def test_the_problem_can_be_set_with_every_value_of_a_range(name: str) -> None:
    problem, off = load(name), list[str]()
    for span in (span for spans in free(problem) for span in spans):
        one = ranged(problem, [span])
        (values,) = one.ranges
        for number in {0, 1, values.count - 2, values.count - 1}:
            try:
                vary(one, {values.name: values.at(number)})
            except VecpolyError:
                off.append(f"{values.name} = {values.at(number)}")
    assert not off


def test_a_time_ratio_begins_at_one() -> None:
    """0.85 is no time ratio, though as many steps below 1.25 as 1.65 is above it."""
    spans = {one.name: one.text for some in free(load("best-gamma")) for one in some[:1]}
    assert spans["K"] == "1 .. 1.65 by 0.05"


@pytest.mark.parametrize("name", ["K-slider-crank-AB", "drag-link"])
def test_no_more_students_have_room_than_there_are_values(name: str) -> None:
    """Few of the draws pass there, so that nothing is known of how far they are apart; but as many values there are."""
    problem = load(name)
    span = next(iter(free(problem)))[0]
    found = pilot(one := ranged(problem, [span]))
    assert found.room <= one.ranges[0].count


ROOMS = {("phi",): 1.0, ("AB",): 9.0, ("phi", "BC"): 4.0, ("AB", "BC"): 20.0, ("AB", "AC"): 10.0}


def test_what_tells_nobody_apart_gives_way_to_what_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where all have the same answers whatever the angle is, another number is varied in its place, not beside it."""
    problem = load("8-2e")
    names = [("phi",), ("AB",), ("BC",), ("AC",)]
    some = [tuple(Span(name=name, text=f"{name}, of these") for name in one) for one in names]
    known = pilot(ranged(load("8-1"), [next(iter(free(load("8-1"))))[0]]))
    monkeypatch.setattr(chosen, "free", lambda _: iter(some))
    monkeypatch.setattr(chosen, "ranged", lambda _, spans: tuple(one.name for one in spans))
    monkeypatch.setattr(chosen, "pilot", lambda of: replace(known, passed=1.0, room=ROOMS.get(of, 1.0)))
    found = proposal(problem, 60)
    assert [one.name for one in found.ranges] == ["AB", "BC"] and found.pilot.room == 20.0


def test_the_same_values_are_drawn_once(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = load("8-1")
    drawn = list[tuple[object, ...]]()
    monkeypatch.setattr(draw, "draws_each", _kept(drawn, draw.draws_each))
    one = ranged(problem, [next(iter(free(problem)))[-1]])
    pilot(one)
    assert len(set(drawn)) == len(drawn) <= one.ranges[0].count < SETS


def _kept(drawn: list[tuple[object, ...]], draws: Draws) -> Draws:
    def noted(problem: Problem, values: Mapping[str, str], standard: Standard, good: bool) -> Drawn:
        drawn.append(tuple(values.items()))
        return draws(problem, values, standard, good)

    return noted


def test_a_problem_without_numbers_is_refused() -> None:
    with pytest.raises(VecpolyError, match="no number can be varied"):
        proposal(load("2-4"), 60)


def test_the_assignment_that_is_written_is_one_and_its_problems_have_the_ranges(tmp_path: Path) -> None:
    own = tmp_path / "own.yaml"
    own.write_text("id: own\ntitle: own\nextends: 8-1\n", encoding="utf-8")
    out = tmp_path / "hw.yaml"
    done = CliRunner().invoke(app, ["variants", "3-9", str(own), "2-4", "--propose", "-o", str(out), "--lang", "en"])
    assert done.exit_code == 2 and "2-4: no number can be varied" in " ".join(done.output.split())
    problems = load_assignment(out).problems
    assert [one.id for one in problems] == ["3-9", "own"] and all(one.ranges for one in problems)
    assert problems[0].scales != load("3-9").scales  # chosen for each variant
    told = CliRunner().invoke(app, ["variants", str(out), "-n", "1", "--lang", "en"])
    assert told.exit_code == 0 and told.output.count("of the draws pass") == 2 and "phi = " in told.output


def test_entries_are_printed_where_no_file_is_named_and_no_file_is_read_over(tmp_path: Path) -> None:
    own = tmp_path / "own.yaml"
    own.write_text(text := "id: own\ntitle: own\nextends: 8-1\n", encoding="utf-8")
    done = CliRunner().invoke(app, ["variants", str(own), "--propose"])
    assert done.exit_code == 0 and f'- problem: "{own}"' in done.stdout and "by 10 mm" in done.stdout
    for words in (["--propose", "-o", str(own)], ["-o", str(tmp_path / "x.yaml")]):
        assert CliRunner().invoke(app, ["variants", str(own), *words]).exit_code == 2
    assert own.read_text(encoding="utf-8") == text and not (tmp_path / "x.yaml").exists()
    assert not loads(text).ranges
