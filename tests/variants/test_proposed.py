"""Ranges that are proposed: round steps about what is written, of what the text does not tell, that pass the gate."""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from vecpoly.cli.app import app
from vecpoly.errors import VecpolyError
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.load import load, loads
from vecpoly.problem.values.vary import parameters
from vecpoly.variants.pilot import pilot
from vecpoly.variants.proposing.chosen import ENOUGH, proposal, ranged
from vecpoly.variants.proposing.numbers import numbers, round_step, spread
from vecpoly.variants.told import said_already

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
