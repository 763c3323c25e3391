"""A spring whose ends are at one place has no direction, so no force can be told: it is refused."""

from __future__ import annotations

import numpy as np
import pytest

from vecpoly import loads, solve
from vecpoly.errors import EquilibriumError, VecpolyError

MEETING = """
id: met
title: {zh: 弹簧, en: A spring whose ends meet}
frame: {A: [0 mm, 0 mm], D: [80 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {BC: 100 mm}, 3: {block: C}}
joints: [3 slides on line through A at 0 deg]
input: {link: 1, phi: 90 deg, omega: 10 rad/s cw}
branch: [C right of AB]
loads: {F_s: {SPRING}, M_1: {on: 1, size: "?"}}
find: [F_s, M_1]
"""


@pytest.mark.parametrize("law", ["spring: C3-D, k: 2 N/mm, l_0: 50 mm", "damper: C3-D, c: 50 N*s/m"])
def test_a_spring_whose_ends_meet_in_this_position_is_refused_and_a_little_later_it_is_not(law: str) -> None:
    problem = MEETING.replace("SPRING", law)
    with pytest.raises(EquilibriumError, match="at one place here") as refusal:
        solve(loads(problem), precise=False)
    assert refusal.value.code == "no-direction"
    later = solve(loads(problem.replace("phi: 90 deg", "phi: 91 deg")), by="exact")
    assert later.answers["M_1"].drawn == pytest.approx(later.answers["M_1"].exact, rel=1e-9)


def test_over_a_cycle_the_places_beside_it_are_found() -> None:
    moments = np.array(
        loads(MEETING.replace("SPRING", "spring: C3-D, k: 2 N/mm, l_0: 50 mm")).cycle(n=73).column("M_1")
    )
    assert np.isfinite(moments).sum() >= 70


@pytest.mark.parametrize("ends", ["B1-B2", "C3-C2"])
def test_a_spring_on_one_pin_is_refused_on_reading(ends: str) -> None:
    with pytest.raises(VecpolyError, match=f"{ends[:2]} and {ends[3:]} are both at {ends[0]},"):
        loads(MEETING.replace("SPRING", f"spring: {ends}, k: 2 N/mm, l_0: 50 mm"))
