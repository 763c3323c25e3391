"""What may be wrong with a printed column: each slip is offered where somebody can make it, and nowhere else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.check.test_table_sentences import DEG, column
from tests.drawn_library import given
from tests.each import each
from vecpoly import oracle
from vecpoly.check.slips.constants import constants
from vecpoly.check.slips.guess import Slip
from vecpoly.check.slips.lengths import lengths
from vecpoly.check.table.header import read_header
from vecpoly.check.table.sheet import read_sheet
from vecpoly.check.table.truth import Truth
from vecpoly.foundation.frozen import FrozenMap
from vecpoly.foundation.slotted import replace
from vecpoly.mechanism.dimensions.values import Part, Placed
from vecpoly.mechanism.model import ByOffsets


def driven_at(rate: float) -> Truth:
    """A six-bar at every 30° of its drive, which turns at this rate (rad/s)."""
    mech = given("A-16").mechanism
    mech = replace(mech, drives=(replace(mech.drive, rate=rate),))
    at = np.radians(DEG)
    return Truth(mech, at, oracle.solve(mech, at), (), FrozenMap({}))


@pytest.mark.parametrize("rate", [2.0, -2.0, 7.3])
@pytest.mark.parametrize("power", [-2, -1, 1, 2])
def test_the_omega_of_the_drive_left_out_or_taken_too_often_is_told_whatever_it_is(rate: float, power: int) -> None:
    truth = driven_at(rate)
    told = constants(column(abs(rate) ** power * truth.motion.omega("3"), decimals=6), truth)
    assert [one.parameter for one in told if one.slip is Slip.OMEGA] == pytest.approx([abs(rate) ** power])


@pytest.mark.parametrize("rate", [1.0, -1.0])
def test_where_it_is_one_radian_a_second_nobody_is_told_of_having_left_it_out(rate: float) -> None:
    truth = driven_at(rate)
    for slight in (1.0, 1.003, 0.998):
        told = constants(column(slight * truth.motion.omega("3"), decimals=6), truth)
        assert Slip.OMEGA not in {one.slip for one in told}


@each(("watt-line", "plate-on-crank", "hand-lever", "pantograph", "stephenson-valve-gear"))
def test_each_distance_that_sets_out_a_point_beside_a_bar_may_have_been_another(name: str) -> None:
    mech = given(name).mechanism
    offered = {one.one: one for one in lengths(mech)}
    for link in mech.links:
        for i, place in enumerate(link.placements):
            if isinstance(place, ByOffsets):
                for part, size in ((Part.ALONG, place.along), (Part.LEFT, place.left)):
                    found = offered.get(Placed(link=link.name, places=(i,), part=part))
                    assert (found.value if found else 0.0) == size


@pytest.mark.parametrize("written", ["rad/s^2", "rad/s²", "rad/s2"])
def test_a_square_in_a_unit_is_told_in_one_way_however_it_is_written(tmp_path: Path, written: str) -> None:
    path = tmp_path / "table.csv"
    path.write_text(f"phi1 [deg],alpha3 [{written}]\n" + "".join(f"{q},1.5\n" for q in range(0, 60, 10)), "utf-8")
    (found,) = read_header(read_sheet(path), given("A-16").mechanism, {}).columns
    assert found.unit is not None and (found.unit.name, found.unit.factor) == ("rad/s^2", 1.0)


@pytest.mark.parametrize("written", ["m/s", "(m/s)", "m·s⁻¹", "m(s^-1)", "km(s^-1)"])
def test_a_unit_is_read_with_and_without_brackets_in_it(tmp_path: Path, written: str) -> None:
    path = tmp_path / "table.csv"
    path.write_text(f"phi1 [deg],vE [{written}]\n" + "".join(f"{q},1.5\n" for q in range(0, 60, 10)), "utf-8")
    (found,) = read_header(read_sheet(path), given("A-16").mechanism, {}).columns
    assert found.unit is not None and found.unit.factor == (1e3 if written.startswith("k") else 1.0)
