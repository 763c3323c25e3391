"""What a dimension that is changed alone does: a distance of gears is fixed by their radii, and an assembly is kept."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.course.test_course_numbers import Recorder
from tests.studies import studied
from vecpoly import loads
from vecpoly.report.course.checks import tolerances
from vecpoly.report.course.checks.influences import influences

PROBLEMS = Path(__file__).parents[2] / "problems"


@pytest.mark.parametrize(("name", "fixed"), [("travel-doubler", {"y_{C}", "y_{E}"}), ("rack-lift", {"x_{P}"})])
def test_what_gears_and_racks_need_to_mesh_is_fixed_and_no_limit_of_assembly(name: str, fixed: set[str]) -> None:
    """A gear is off its rack wherever the crank stands: not "about 180°", nor from +0.02 mm on."""
    found = influences(studied(name))
    assert {one.dimension.name.en.strip("$") for one in found if one.fitted} == fixed
    assert not any(one.least or one.most for one in found if one.fitted)


def test_what_cannot_be_changed_alone_is_said_and_has_no_row_of_dashes() -> None:
    press = Recorder()
    told = " ".join(tolerances.section(studied("travel-doubler"), press)["judged"])
    assert "cannot be changed alone" in told and "no longer be assembled" not in told
    named = {line[0].strip("$") for line in press.lines}
    assert named and not named & {"y_{C}", "y_{E}"} and not any("—" in line for line in press.lines)
    assert tolerances.section(studied("rack-lift"), Recorder()) == {"sensitivity": "", "judged": []}


@pytest.mark.parametrize("name", ["peaucellier", "7-1"])
def test_a_linkage_that_is_changed_a_little_keeps_its_assembly(name: str) -> None:
    """A rhombus with one side longer has two assemblies of which both are as the statements say."""
    assert all(one.lost is None and one.gaps for one in influences(studied(name)))


@pytest.mark.parametrize("height", ["0.1", "-0.1", "3"])
def test_peaucellier_s_linkage_is_solved_with_its_fixed_point_off_the_line_too(height: str) -> None:
    """Where two links of a rhombus lie on each other at the end of the range, the fold beside it is nothing."""
    (file,) = PROBLEMS.rglob("peaucellier.yaml")
    text = file.read_text(encoding="utf-8").replace("O: [0 mm, 0 mm]", f"O: [0 mm, {height} mm]")
    answers = loads(text).solve(by="exact").answers
    assert all(abs(one.deviation) <= 1e-9 for one in answers.values())
