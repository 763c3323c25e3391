"""Claims about extremes that are sharper than any grid:
near change points, near dead points, on a slide that is long against its links."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.cycle.test_cycle import four_bar, nephroid, slider_crank
from tests.laws import few, often
from vecpoly.cycle import Cycle, cycle, extremes
from vecpoly.cycle.facts.breaks import breaks
from vecpoly.cycle.unbroken import pieces
from vecpoly.mechanism.model import Drive, Link, Mechanism, Prismatic, Revolute
from vecpoly.problem.load import load, loads

QUICK = settings(max_examples=often(4))
STEPS = st.sampled_from([13, 72, 361])


def slotted(height: float, width: float, start: float = 0.0) -> Mechanism:
    """A slider on the x axis that turns a slotted arm about a pivot at this height; the frame has a point far away."""
    links = (Link(name="1", points={"B": 0j}), Link(name="2", points={"C": 0j}), Link(name="3", points={"B": 0j}))
    joints = (
        Revolute(point="B", a="1", b="3"),
        Revolute(point="C", a="2", b="0"),
        Prismatic(guide="0", block="1", origin=0j, direction=0.0, pin="B"),
        Prismatic(guide="2", block="3", origin=0j, direction=0.0, pin="B", through="C"),
    )
    return Mechanism(
        frame={"A": complex(width), "C": 1j * height},
        links=links,
        joints=joints,
        drives=(Drive(link="1", position=start, rate=0.5, slide=True),),
    )


def brute(turn: Cycle, key: str) -> tuple[float, float]:
    """Least and greatest magnitude on twenty thousand positions, and on ever finer ones about the best."""
    found = []
    for sign in (1.0, -1.0):
        places = np.linspace(turn.low, turn.high, 20_001)
        for _ in range(6):
            values = np.asarray(turn.at(key, places))
            size = sign * (np.abs(values) if np.iscomplexobj(values) else values)
            best, width = int(np.nanargmin(size)), places[1] - places[0]
            least = float(size[best])
            places = np.clip(np.linspace(places[best] - 2 * width, places[best] + 2 * width, 1001), turn.low, turn.high)
        found.append(sign * least)
    return found[0], found[1]


def agrees(turn: Cycle, key: str) -> None:
    found, (least, greatest) = extremes(turn, key), brute(turn, key)
    assert found.highest is not None and found.lowest is not None
    small = 1e-9 * max(abs(least), abs(greatest))
    assert found.highest.value >= greatest - small and found.lowest.value <= least + small
    for spot in (
        found.highest,
        found.lowest,
    ):  # values that are there: brute force may pick the lower of two peaks of nearly one height
        assert np.abs(turn.at(key, spot.phi)) == pytest.approx(abs(spot.value), abs=small)


@QUICK
@given(
    st.floats(0.09, 0.2),
    st.floats(0.09, 0.2),
    st.floats(-7.0, -2.0),
    st.booleans(),
    st.sampled_from(["omega_3", "alpha_3", "a_C", "gamma_23"]),
    STEPS,
)
def test_extremes_of_a_crank_rocker_beside_its_change_point_are_right(
    coupler: float, rocker: float, gap: float, far: bool, key: str, n: int
) -> None:
    crank, hair = 0.05, 0.05 * 10.0**gap
    frame = coupler + rocker - crank - hair if far else crank + abs(coupler - rocker) + hair
    if frame > crank * 1.01:
        agrees(cycle(four_bar(crank, coupler, rocker, frame), n), key)


@QUICK
@given(st.floats(-7.0, -1.0), st.sampled_from(["alpha_2", "v_C"]), STEPS)
def test_extremes_of_a_slider_crank_whose_rod_is_hardly_longer_than_its_crank_are_right(
    more: float, key: str, n: int
) -> None:
    agrees(cycle(slider_crank(0.05, 0.05 * (1 + 10.0**more), 0.0), n), key)


@QUICK
@given(st.floats(-3.0, -0.5), st.floats(0.5, 3.0), st.floats(-2.0, 2.0), STEPS)
def test_extremes_on_a_long_slide_are_the_closed_form(power: float, width: float, share: float, n: int) -> None:
    height = width * 10.0**power
    turn = cycle(slotted(height, width, share * width), n)
    top, spin = extremes(turn, "alpha_2").highest, extremes(turn, "omega_2").highest
    assert top is not None and spin is not None and turn.low < -height < turn.high
    assert top.value == pytest.approx(0.25 * 3 * sqrt(3) / 8 / height**2, rel=1e-12) and abs(top.phi) == pytest.approx(
        height / sqrt(3), rel=1e-8
    )
    assert spin.value == pytest.approx(0.5 / height, rel=1e-12) and spin.phi == pytest.approx(0.0, abs=1e-8 * height)


def test_the_grid_is_not_finer_than_the_motion_needs() -> None:
    for mech in (nephroid(), four_bar(0.05, 0.2, 0.15, 0.18)):
        assert len(cycle(mech).on_grid("phi_1")[0]) == 1442
    assert len(cycle(load("A-30")).on_grid("phi_1")[0]) < 1800


def test_forces_break_where_a_slip_changes_its_sense_at_the_same_places_in_every_column() -> None:
    from vecpoly.cycle.curve import Curve

    turn = cycle(load("4-6"))
    told = breaks(turn)
    assert (
        len(told) == 10 and (np.diff(told, axis=1) < 2e-3).all() and (np.diff(told, axis=1) < 1e-7).sum() == 9
    )  # all but the one beside the dead point
    for key in few(("R_14", "R_12", "M_r"), 3):
        curve = Curve.of(turn, key)
        parts = pieces(curve, *curve.grid())
        ends = [part.phi[-1] for part in parts if part.stops]
        assert all(np.abs(told - end).min() == 0.0 for end in ends)


# a class III group that comes to a dead point at one end of its range, where a reaches 1e29 m/s² by rounding
RUNS_AWAY = """
id: x
title: a class III group at its dead point
frame: {A: [0 mm, 0 mm], F: [331.797244471 mm, 194.596097511 mm], I: [133.156361317 mm, 208.211421483 mm]}
links:
  1: {AB: 51.886924520 mm, G: {along: AB, at: 203.092273743 mm, left: 28.518078938 mm}}
  2: {CD: 139.357328142 mm, E: {along: CD, at: 51.993894501 mm, left: -85.431542483 mm}}
  3: {FC: 153.941796549 mm}
  4: {FD: 264.935831583 mm}
  5: {GE: 130.110816882 mm}
input: {link: 1, phi: 36 deg, omega: 3 rad/s, alpha: 5 rad/s^2}
guesses: {C: [180.808 mm, 224.604 mm], D: [73.490 mm, 135.704 mm], E: [86.269 mm, 257.226 mm]}
"""


def test_a_column_that_runs_away_keeps_the_extremes_within() -> None:
    turn = cycle(loads(RUNS_AWAY), 37)
    found, inside = extremes(turn, "a_D"), turn.low + np.linspace(0.01, 0.9, 20001) * (turn.high - turn.low)
    assert found.highest is not None and found.highest.value == np.inf
    assert found.lowest is not None and not found.lowest.end
    assert found.lowest.value == pytest.approx(np.abs(turn.at("a_D", inside)).min(), rel=1e-6)
    assert (len(found.maxima), len(found.minima)) == (2, 3)


BETWEEN_DEAD_POINTS = """
id: x
title: at both ends of the crank's range coupler and rocker are in line
frame: {A: [0 mm, 0 mm], D: [%s mm, 0 mm]}
links: {1: {AB: %s mm}, 2: {BC: %s mm}, 3: {DC: %s mm}}
branch: [C left of BD]
input: {link: 1, phi: 20 deg, omega: 4 rad/s}
find: [v_C]
"""


@pytest.mark.parametrize("sizes", [(51, 49, 80, 68), (51, 48, 80, 67), (52, 49, 81, 69), (60, 50, 90, 70)])
def test_no_row_passes_the_least_where_it_is_nothing_at_both_ends(sizes: tuple[int, ...]) -> None:
    """γ = 0 at a dead point is known to the root of rounding: the first of the two ends may not be the lower one."""
    turn = cycle(loads(BETWEEN_DEAD_POINTS % sizes), 37)
    least = extremes(turn, "gamma_23").lowest
    assert least is not None and least.end and 0 <= least.value < 1e-7
    assert least.value <= np.nanmin(turn.real("gamma_23")) + 1e-15
