"""r and θ of a cam's profile: θ counter-clockwise from the radius to its first point, as a workshop reads them."""

from __future__ import annotations

import numpy as np
import pytest

from tests.cam_cases import CASES, agree, cam_of, device
from vecpoly.board.otherwise.slip import Mistake
from vecpoly.grading.student import check_answers
from vecpoly.mistakes import slips
from vecpoly.problem.load import load
from vecpoly.solution import solve

MOTION = ["rise 20 mm in 120 deg cosine", "dwell 30 deg", "return in 120 deg parabolic", "dwell 90 deg"]


def test_a_knife_edge_on_a_radial_guide_touches_where_the_guide_has_come() -> None:
    """θ = 360° − φ for a cam that turns counter-clockwise, whatever the motion."""
    found = agree(device("cam", follower={"knife": "yes"}, r0="40 mm", turns="ccw", motion=MOTION))
    assert all(
        value == pytest.approx(360.0 - float(key.removeprefix("theta_")), abs=1e-9)
        for key, value in found.items()
        if key.startswith("theta_")
    )


@pytest.mark.parametrize("case", ["knife-1", "roller-1", "flat-1", "osc-1"])
def test_points_of_the_profile_are_where_they_were_worked_out_elsewhere(case: str) -> None:
    """Turned on from the first point by θ, at the distance r."""
    found, table = agree(cam_of(case)), CASES[case]["results"]["table"]
    first, *others = (complex(*row["profile"]) for row in table)
    ahead = first / abs(first)
    for row, point in zip(table[1:-1], others, strict=False):
        here = found[f"r_{row['phi']:g}"] * ahead * np.exp(1j * np.radians(found[f"theta_{row['phi']:g}"]))
        assert abs(here - point) < 2e-6, row["phi"]


def test_who_inverts_with_the_motion_has_another_angle_and_is_told_why() -> None:
    problem = load("cam-roller-offset")
    [slip] = [one for one in slips(problem) if one.mistake is Mistake.FORWARDS]
    right, wrong = (solve(problem, by="exact", slip=one).answers["theta_60"].drawn for one in (None, slip))
    assert wrong == pytest.approx(right - 240.0, abs=1e-9)  # −60° and what the follower leans there: +60° and the same
    checked = check_answers(problem, {"theta_60": f"{wrong:.1f}"})
    assert not checked.right and "instead of turned back" in str(checked)
