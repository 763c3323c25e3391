"""In-line engines: the worked cases, and the sums of all pistons' inertia forces over a turn."""

from __future__ import annotations

from math import isnan, pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.cam_cases import device, drawn
from tests.laws import often
from tests.rotor_cases import CASES, agree

NEAR = 5e-9  # the cases are told to nine digits


def engine(case: str, **more: Any) -> Any:
    told = CASES[case]["inputs"]
    pitch = told["z_mm"][1] - told["z_mm"][0]
    data = {
        "cranks": [f"{at} deg" for at in told["crank_angles_deg"]],
        "pitch": f"{pitch} mm",
        "m": f"{told['m_rec_kg'][0]} kg",
        "r": f"{told['r_mm']} mm",
        "l": f"{told['l_mm']} mm",
        "n": f"{told['n_rpm']} r/min",
    }
    return device("in-line-engine", **data | more)


@pytest.mark.parametrize("case", ["A24", "A25", "A26"])
def test_the_sums_of_both_orders_are_those_of_the_worked_engine(case: str) -> None:
    told, found = CASES[case]["results"], agree(engine(case))
    names = {"I": "primary", "II": "secondary"}
    for order, name in names.items():
        force, couple = told[f"{name}_force_N"], told[f"{name}_couple_Nm"]
        assert abs(found[f"F_{order}"]) == pytest.approx(force, rel=NEAR, abs=1e-6)
        assert abs(found[f"M_{order}"]) == pytest.approx(couple, rel=NEAR, abs=1e-6)
        for key, symbol in ((f"{name}_force", f"theta_{order}"), (f"{name}_couple", f"theta_M{order}")):
            turn = told["directions_deg"][key]
            assert isnan(found[symbol]) if turn is None else abs((found[symbol] - turn + 180) % 360 - 180) < 1e-6


@settings(max_examples=often(8), deadline=None)
@given(cranks=st.lists(st.integers(0, 359), min_size=1, max_size=8), ratio=st.floats(0.15, 0.5), data=st.data())
def test_the_first_two_harmonics_of_all_pistons_have_these_amplitudes(
    cranks: list[int], ratio: float, data: st.DataObject
) -> None:
    order = data.draw(st.permutations(range(1, len(cranks) + 1)))
    given_ = {"cranks": [f"{at} deg" for at in cranks], "pitch": "100 mm", "m": "1 kg", "r": "100 mm", "n": "10 rad/s"}
    found = agree(device("in-line-engine", **given_, l=f"{0.1 / ratio!r} m", order=list(order)))
    phi = np.linspace(0, 2 * pi, 720, endpoint=False)
    turned = phi[:, None] + np.radians(cranks)
    piston = 10.0 * (np.cos(turned) + 0.1 / float(f"{0.1 / ratio!r}") * np.cos(2 * turned))
    z = 0.1 * (np.arange(len(cranks)) - (len(cranks) - 1) / 2)
    for total, key in ((piston.sum(axis=1), "F"), ((piston * z).sum(axis=1), "M")):
        harmonics = 2 * np.abs(np.fft.rfft(total)) / len(phi)
        assert abs(found[f"{key}_I"]) == pytest.approx(harmonics[1], abs=1e-9 * 10 * len(cranks))
        assert abs(found[f"{key}_II"]) == pytest.approx(harmonics[2], abs=1e-9 * 10 * len(cranks))


def test_the_firing_order_changes_the_polygon_but_not_its_sum() -> None:
    plain, fired = (drawn(engine("A26", **more)).readings["W_II"] for more in ({}, {"order": "1-3-4-2"}))
    assert plain.scalar == pytest.approx(fired.scalar)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"order": [1, 2, 3]}, "each of 1 to 4 once"),
        ({"order": "first"}, "no firing order"),
        ({"l": "40 mm"}, "not longer than the crank"),
        ({"cranks": []}, "there are 0 cranks"),
    ],
)
def test_engines_that_cannot_be_are_refused(more: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        engine("A26", **more)
