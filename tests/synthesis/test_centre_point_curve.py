"""The centre-point curve that is drawn by circles over opposite poles is that of the determinant."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from tests.each import each
from tests.synthesis.inversion import pose, posed, solved
from vecpoly.errors import AssemblyError
from vecpoly.methods.synthesis.inversion.curve import meetings
from vecpoly.oracle.synthesis.inversion.burmester import determinant
from vecpoly.oracle.synthesis.inversion.motions import Pose, pole
from vecpoly.oracle.synthesis.registry import linkages
from vecpoly.plane import nominal

PLACES = ((0j, 0), (13 + 19j, 24), (42 + 28j, 35), (83 + 15j, 54))
FOUR = tuple(Pose.turned(at, np.radians(deg)) for at, deg in PLACES)


@pytest.mark.parametrize("sides", [((0, 1), (0, 2), (1, 3), (2, 3)), ((0, 1), (1, 3), (0, 2), (2, 3))])
def test_circles_over_opposite_sides_with_one_inscribed_angle_meet_in_centre_points(
    sides: tuple[tuple[int, int], ...],
) -> None:
    poles = [at for i, j in sides if (at := pole(FOUR[i], FOUR[j])) is not None]
    gammas = np.linspace(0.05, 3.1, 60)
    tried = (complex(nominal(meetings(poles, float(gamma))[n])) for gamma, n in product(gammas, (0, 1)))
    points = [at for at in tried if np.isfinite(at)]
    assert len(points) >= 15
    for at in points:
        assert abs(determinant(FOUR, at)) < 1e-7 * abs(determinant(FOUR, at + 0.1 * (1 + abs(at))))


@each(
    [
        [pose(0, 0, 0), pose(27, 27, 11), pose(57, 60, 34), pose(64, 53, 56)],  # P34 lies on the line of the body
        [pose(0, 0, 0), pose(30, 10, 20), pose(60, 5, 20), pose(85, -20, 50)],  # no turn from 2 to 3
        [pose(0, 0, 0), pose(13, 19, 24), pose(42, 28, 35), pose(60, 30, 35)],  # nor from 3 to 4: P34 is at infinity
    ]
)
def test_poles_that_are_hard_to_find_refuse_no_task(poses: list[str]) -> None:
    for line in ("on y = -50 mm", "on x = 19 mm"):
        problem = posed("positions", poses=poses, A=line, D=line)
        try:
            count = len(linkages(problem.design))
        except AssemblyError:
            continue
        solution = solved(problem)
        assert len(solution.construction.candidates) == count and not solution.suspect


def test_a_centre_point_hundreds_of_figures_away_is_found_too() -> None:
    poses = ["(0, 0) mm at 0 deg", "(32, -28) mm at 11 deg", "(41, -48) mm at 30 deg", "(49, -22) mm at 53 deg"]
    found = solved(posed("positions", poses=poses, A="on x = -29 mm", D="on x = -29 mm"))
    assert not found.suspect and len(found.construction.candidates) == 3
