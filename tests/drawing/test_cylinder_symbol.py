"""The symbol of a hydraulic cylinder, wherever its two pins stand."""

from __future__ import annotations

import cmath
from collections.abc import Mapping

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.board.paper.marks import LinkNumber, Mark, Role, Segment
from vecpoly.diagram.cylinders import FRONT, GAP, HALF, LUG, PISTON, cylinder_joint, cylinder_part, is_cylinder, pressed
from vecpoly.diagram.posed import Posed
from vecpoly.mechanism.model import Prismatic
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Shape

PROBLEM = loads("""\
id: t
title: test
frame: {A: [0 mm, 0 mm], D: [450 mm, -350 mm]}
links: {1: {AC: 1150 mm}, 2: {cylinder: D}, 3: {piston: C, K: {along: C, at: 20 mm, left: 40 mm}}}
joints: [3 slides in 2]
input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s, a: 0 m/s^2}
branch: [C left of AD]
find: [omega_1]
""")
MECH = PROBLEM.mechanism
(JOINT,) = (joint for joint in MECH.joints if isinstance(joint, Prismatic))
spots = st.builds(complex, st.floats(-90, 90), st.floats(-90, 90))
reaches = st.builds(cmath.rect, st.floats(5, 120), st.floats(-3.1, 3.1))


def posed(d: complex, to_c: complex, shapes: Mapping[str, Shape] | None = None, *found: str) -> Posed:
    """The barrel's pin at D, the piston's at C, a point K of the piston to the left of its line."""
    way = to_c / abs(to_c)
    located = {"2": (d, way), "3": (d + to_c, way)}
    return Posed(
        mech=MECH,
        shapes={"2": Shape.CYLINDER, "3": Shape.PISTON} if shapes is None else shapes,
        per_metre=100.0,
        at={"A": 0j, "D": d, "C": d + to_c, "K": d + to_c + way * (2 + 4j)},
        located={link: place for link, place in located.items() if link in (found or located)},
        names={"2": "2", "3": "3"},
    )


def own(marks: list[Mark], d: complex, to_c: complex) -> list[tuple[complex, complex]]:
    """The ends of the segments as seen from D, the line to C pointing to the right."""
    way = to_c / abs(to_c)
    lines = [mark for mark in marks if isinstance(mark, Segment)]
    assert all(line.role is Role.LINK for line in lines)
    return [((line.a - d) / way, (line.b - d) / way) for line in lines]


def has(lines: list[tuple[complex, complex]], a: complex, b: complex) -> bool:
    """Whether a line with these ends is among them, in either sense."""
    return any((abs(p - a) < 1e-6 and abs(q - b) < 1e-6) or (abs(p - b) < 1e-6 and abs(q - a) < 1e-6) for p, q in lines)


@given(spots, reaches)
def test_the_barrel_is_a_box_open_in_front_with_lips(d: complex, to_c: complex) -> None:
    lines = own(list(cylinder_part(posed(d, to_c), "2", JOINT)), d, to_c)
    back, front = min(LUG, 0.2 * abs(to_c)), FRONT * abs(to_c)
    assert has(lines, 0, back) and has(lines, back - HALF * 1j, back + HALF * 1j)
    for side in (HALF * 1j, -HALF * 1j):
        assert has(lines, back + side, front + side) and has(lines, front + side, front + 0.35 * side)
    assert len(lines) == 6


@given(spots, reaches)
def test_the_piston_fits_into_the_barrel_and_its_rod_ends_at_its_pin(d: complex, to_c: complex) -> None:
    lines = own(list(cylinder_part(posed(d, to_c), "3", JOINT)), d, to_c)
    head, reach = PISTON * abs(to_c), abs(to_c)
    assert has(lines, head - (HALF - GAP) * 1j, head + (HALF - GAP) * 1j) and has(lines, head, reach)
    assert has(lines, reach + 2, reach + 2 + 4j) and len(lines) == 3  # K stands beside the line


@given(spots, reaches)
def test_the_oil_presses_on_the_bottom_and_on_the_piston(d: complex, to_c: complex) -> None:
    way = to_c / abs(to_c)
    bottom, piston = ((spot - d) / way for spot in pressed(posed(d, to_c), JOINT))
    assert bottom == pytest.approx(min(LUG, 0.2 * abs(to_c)), abs=1e-9)
    assert piston == pytest.approx(PISTON * abs(to_c), abs=1e-9)


@given(spots, reaches)
def test_the_number_of_the_barrel_stands_beside_it_and_that_of_the_piston_beside_its_rod(
    d: complex, to_c: complex
) -> None:
    way = to_c / abs(to_c)
    for link, ends in (("2", (LUG, FRONT * abs(to_c))), ("3", (abs(to_c), FRONT * abs(to_c)))):
        (number,) = (m for m in cylinder_part(posed(d, to_c), link, JOINT) if isinstance(m, LinkNumber))
        assert ((number.a - d) / way, (number.b - d) / way) == pytest.approx(ends, abs=1e-6) and number.number == link


def test_nothing_is_drawn_until_barrel_and_piston_are_found() -> None:
    for found in ("2", "3"):
        assert list(cylinder_part(posed(0j, 50 + 0j, None, found), "2", JOINT)) == []


def test_a_pair_is_a_cylinder_where_its_guide_is_one() -> None:
    assert is_cylinder(posed(0j, 50 + 0j), JOINT)
    assert not is_cylinder(posed(0j, 50 + 0j, {"2": Shape.SLOT, "3": Shape.CYLINDER}), JOINT)
    here = posed(0j, 50 + 0j)
    assert cylinder_joint(here, "2") == cylinder_joint(here, "3") == JOINT and cylinder_joint(here, "1") is None
    assert cylinder_joint(posed(0j, 50 + 0j, {}), "2") is None


def test_pins_at_one_place_have_a_symbol_of_no_length_and_no_failure() -> None:
    here = Posed(
        mech=MECH, shapes={"2": Shape.CYLINDER}, per_metre=100.0, at={"D": 1j, "C": 1j, "K": 1j},
        located={"2": (1j, 1 + 0j), "3": (1j, 1 + 0j)},
    )  # fmt: skip
    assert all(abs(spot - 1j) < 1e-5 for spot in pressed(here, JOINT))
