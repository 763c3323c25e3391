"""A class III group that is led from place to place comes where a look at all its assemblies would bring it."""

from __future__ import annotations

import numpy as np
import pytest

from tests.laws import few
from vecpoly.methods.desk import Desk
from vecpoly.methods.kinematics.class_iii import position
from vecpoly.methods.kinematics.class_iii.assemblies import Assembly, assemblies
from vecpoly.methods.kinematics.class_iii.led import led
from vecpoly.methods.kinematics.class_iii.star import Star
from vecpoly.methods.positions.following import follower, letters
from vecpoly.problem.load import load

FAR = 0.4  # rad of the drive


@pytest.mark.parametrize("name", few(["class-iii", "class-iii-slides"], 2))
def test_it_is_the_nearest_of_all_assemblies_and_drawn_in_the_same_way(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    met = [0]

    def compared(desk: Desk, star: Star) -> Assembly | None:
        found = led(desk, star)
        if found is not None:
            met[0] += 1
            nearest, _ = position._chosen(desk, star, assemblies(desk, star))
            assert (found.legs, found.first) == (nearest.legs, nearest.first)
            assert abs(np.exp(1j * found.theta) - np.exp(1j * nearest.theta)) < 1e-9
        return found

    monkeypatch.setattr(position, "led", compared)
    mech = load(name).mechanism
    follower.cache_clear()
    follower(mech).at(mech.drive.position + FAR)
    assert met[0] > 5


@pytest.mark.parametrize("name", ["class-iii", "class-iii-slides"])
def test_it_is_where_it_comes_to_by_looking_at_all_of_them(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    mech = load(name).mechanism
    follower.cache_clear()
    there = follower(mech).drawn(mech.drive.position + FAR)[0]
    monkeypatch.setattr(position, "led", lambda *_: None)
    follower.cache_clear()
    again = letters(follower(mech).drawn(mech.drive.position + FAR)[0])
    assert letters(there) == pytest.approx(again, abs=1e-9 * mech.scale)
