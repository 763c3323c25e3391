"""The oracle's rates under a cylinder, or a motor in a hinge, are the differences of what they are rates of."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.generators.family import families, member
from tests.laws import few
from vecpoly import oracle
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.load import loads

DT = 1e-5  # s


def hastened(mech: Mechanism, accel: float) -> Mechanism:
    """The same mechanism with this acceleration of its drive."""
    return replace(mech, drives=(replace(mech.drive, accel=accel), *mech.drives[1:]))


@pytest.mark.parametrize("number", few([0, 1], 2))
@pytest.mark.parametrize("name", ["cylinder-lever", "motor-in-hinge", "cylinder-offset"])
def test_rates_under_a_driven_pair_are_the_differences_of_what_they_are_rates_of(name: str, number: int) -> None:
    """ω = Δφ/Δt and α = Δω/Δt at a constant rate of the drive; its acceleration a adds ω a / rate to α."""
    one = next(each for each in families() if each.name == name)
    mech = hastened(loads(member(one, 0, number)).mechanism, 0.0)
    rate = mech.drive.rate
    here = oracle.solve(mech, mech.drive.position + rate * np.array([-DT, 0.0, DT]))
    more = oracle.solve(hastened(mech, 0.7), np.array([mech.drive.position]))
    for link in mech.links:
        angle, omega, alpha = (np.asarray(told(link.name)) for told in (here.angle, here.omega, here.alpha))
        assert (angle[2] - angle[0]) / (2 * DT) == pytest.approx(omega[1], rel=1e-5, abs=1e-6)
        assert (omega[2] - omega[0]) / (2 * DT) == pytest.approx(alpha[1], rel=1e-5, abs=1e-6)
        assert float(np.asarray(more.alpha(link.name))[0]) == pytest.approx(
            alpha[1] + 0.7 * omega[1] / rate, rel=1e-9, abs=1e-12
        )
