"""The equations that hold a link as it stands at the problem's own position: their rates are their differences."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.oracle.iterated.standing import Slid, Turned
from vecpoly.oracle.state import Body

STEP = 1e-6
poses = st.lists(st.floats(-0.8, 0.8), min_size=6, max_size=6)
EQUATIONS = (
    Turned("2", 0.4),
    Turned("2", 0.4, ((("1", 0.3 + 0.1j),), (("2", 2.0 - 0.5j),))),
    Turned("2", 0.4, ((("2", 0.1j),), (("1", -2.0 + 0.4j),))),
    Slid("2", 0.2, "1", "2", 0.1j, complex(np.exp(0.3j)), 0.2 + 0.1j, 1.5),
)


def bodies(pose: np.ndarray) -> dict[str, Body]:
    """Links 1 and 2 with their origins at (x, y), turned by φ."""
    still, none = np.zeros(1, complex), np.zeros(1)
    return {
        name: Body(
            local=0j,
            at=np.array([complex(x, y)]),
            unit=np.exp(1j * np.array([phi])),
            turn=np.array([phi]),
            velocity=still,
            omega=none,
            acceleration=still,
            alpha=none,
        )
        for name, (x, y, phi) in zip("12", pose.reshape(2, 3), strict=True)
    }


@pytest.mark.parametrize("equation", EQUATIONS)
@given(pose=poses)
def test_the_rate_of_a_start_by_each_coordinate_is_its_difference(equation: Turned | Slid, pose: list[float]) -> None:
    here = np.array(pose)
    rates = equation.jac(bodies(here), ("1", "2"))[0].ravel()
    for n, rate in enumerate(rates):
        there = STEP * np.eye(6)[n]
        ahead, behind = (float(equation.gap(bodies(here + way * there))[0]) for way in (1, -1))
        assert (ahead - behind) / (2 * STEP) == pytest.approx(rate, abs=1e-6)
