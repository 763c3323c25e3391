"""The half-section of an epicyclic train stands beside its velocities: every mesh level with its own."""

from __future__ import annotations

from itertools import combinations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.paper.marks import FixedGuide, LinkNumber, Role, Segment
from vecpoly.diagram.half_section import GAP, half_section
from vecpoly.methods.devices.epicyclic.scales import RADII

PLAIN = {"1": 10.0, "2": 11.0, "2′": 11.0, "H": 21.0, "3": 32.0}
STEPPED = {"1": 12.0, "2": 16.5, "2′": 10.5, "H": 28.5, "3": 39.0}
SUNS = {"1": 12.0, "2": 16.5, "2′": 10.5, "H": 28.5, "3": 18.0}
TRAINS = [(PLAIN, True, False), (STEPPED, True, True), (SUNS, False, True)]


def rims(radii: dict[str, float], ring: bool, stepped: bool) -> set[float]:
    symbols = half_section(0.0, radii, ring=ring, stepped=stepped, fixed="")
    marks = [mark for one in symbols for mark in one.marks if isinstance(mark, Segment)]
    return {round(mark.a.imag, 6) for mark in marks if mark.role is Role.LINK and mark.a.imag == mark.b.imag}


@pytest.mark.parametrize(("radii", "ring", "stepped"), TRAINS)
def test_the_rims_of_two_wheels_meet_where_their_pitch_circles_touch(
    radii: dict[str, float], ring: bool, stepped: bool
) -> None:
    found = rims(radii, ring, stepped)
    for mesh in (radii["1"], radii["3"]):
        assert {round(mesh - GAP, 6), round(mesh + GAP, 6)} <= found


@pytest.mark.parametrize(("radii", "ring", "stepped"), TRAINS)
@pytest.mark.parametrize("fixed", ["1", "3"])
def test_the_central_gear_that_is_held_is_hatched_once(
    radii: dict[str, float], ring: bool, stepped: bool, fixed: str
) -> None:
    marks = [mark for one in half_section(0.0, radii, ring=ring, stepped=stepped, fixed=fixed) for mark in one.marks]
    assert sum(isinstance(mark, FixedGuide) for mark in marks) == 1
    assert all(max(mark.a.real, mark.b.real) <= 3.0 for mark in marks if isinstance(mark, Segment))


@pytest.mark.parametrize("name", ["train-ring", "train-stepped", "train-differential"])
def test_the_section_is_left_of_all_velocities_and_every_link_has_its_number(name: str) -> None:
    figure = next(one for one in drawn(name).construction.figures if one.view is RADII)
    numbers = [mark for mark in figure.marks if isinstance(mark, LinkNumber)]
    assert {"1", "2", "3", "H"} <= {mark.number for mark in numbers}
    assert all(abs(a.a - b.a) > 3.0 for a, b in combinations(numbers, 2))
    left = min(min(m.a.real, m.b.real) for m in figure.marks if isinstance(m, Segment) and m.role is Role.RESULT)
    assert all(mark.a.real < min(left, 0.0) for mark in numbers)
