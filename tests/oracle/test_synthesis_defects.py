"""Circuit, branch and order of a linkage, against a walk along all positions that it can take without being apart."""

from __future__ import annotations

import cmath
from itertools import pairwise
from math import pi, tau

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.oracle.synthesis.inversion.defects import Defect, Driven, crank_slider, fourbar, slider_crank

STEP = 0.02  # rad, of the walk
Way = list[tuple[float, float]]  # the angles of both links on the frame, on and on


def _closed(a: float, b: float, c: float, d: float, phi: float) -> list[tuple[float, float]]:
    """The angles of AB and DC at this angle of AB, C left of BD and right of it."""
    pin = a * cmath.exp(1j * phi)
    span = d - pin
    along = (abs(span) ** 2 + b * b - c * c) / (2 * abs(span))
    if b * b < along * along:
        return []
    across = [complex(along, side * np.sqrt(b * b - along * along)) for side in (1, -1)]
    return [(phi, cmath.phase(pin + span / abs(span) * at - d)) for at in across]


def _walk(a: float, b: float, c: float, d: float, start: tuple[float, float]) -> Way:
    """All positions of one circuit, one after another: along the curve |BC| = b of both angles, from the start."""
    way, here, heading = [start], np.array(start), None
    for _ in range(4000):
        slope = _slope(a, c, d, here)
        tangent = np.array([-slope[1], slope[0]]) / np.hypot(*slope)
        heading = tangent if heading is None or tangent @ heading > 0 else -tangent
        here = here + STEP * heading
        for _ in range(4):
            slope = _slope(a, c, d, here)
            here = here - slope * _gap(a, b, c, d, here) / (slope @ slope)
        way.append((float(here[0]), float(here[1])))
        if len(way) > 5 and _apart(way[-1], start) < STEP:
            break
    return way


def _gap(a: float, b: float, c: float, d: float, at: np.ndarray) -> float:
    return float(abs(a * np.exp(1j * at[0]) - d - c * np.exp(1j * at[1])) ** 2) - b * b


def _slope(a: float, c: float, d: float, at: np.ndarray) -> np.ndarray:
    bar = a * np.exp(1j * at[0]) - d - c * np.exp(1j * at[1])
    turns = (1j * a * np.exp(1j * at[0]), -1j * c * np.exp(1j * at[1]))
    return np.array([2 * (np.conj(bar) * turn).real for turn in turns])


def _apart(one: tuple[float, float], two: tuple[float, float]) -> float:
    return max(abs(cmath.exp(1j * x) - cmath.exp(1j * y)) for x, y in zip(one, two, strict=True))


def _judged(way: Way, seen: list[tuple[float, float]]) -> Defect | None:
    """The verdict of a walk: are all positions on it, between dead points of AB, and met in their order?"""
    at = [min(range(len(way)), key=lambda i: _apart(way[i], one)) for one in seen]
    if any(_apart(way[i], one) > 2 * STEP for i, one in zip(at, seen, strict=True)):
        return Defect.CIRCUIT
    stretch = _stretches([phi for phi, _ in way])
    if len({stretch[i] for i in at}) > 1:
        return Defect.BRANCH
    full = max(stretch) == 0
    on = [i - at[0] if not full else (i - at[0]) % len(way) for i in at]
    on = on if full else [_unrolled(i, stretch, len(way)) for i in at]
    falls = [j for j, (x, y) in enumerate(pairwise(on)) if y < x]
    rises = [j for j, (x, y) in enumerate(pairwise(on)) if y > x]
    turned = len(seen) == 3 and full
    return None if turned or not falls or not rises else Defect.ORDER


def _unrolled(i: int, stretch: list[int], count: int) -> int:
    """The place in a stretch that may go over the start of the walk."""
    first = stretch.index(0)
    wraps = stretch[0] == stretch[-1] and max(stretch) > 0
    end = next((j for j in range(count) if stretch[j] != stretch[first]), count)
    return i + count if wraps and i < end else i


def _stretches(angles: list[float]) -> list[int]:
    """The number of the stretch between two dead points, where the driver turns back."""
    steps = np.sign(np.diff(np.unwrap(angles)))
    number, found = 0, [0]
    for one, two in pairwise(steps):
        number += int(one != two)
        found.append(number)
    found.append(number)
    if number:
        found = [0 if n == number else n for n in found] if steps[0] == steps[-1] else found
    return found


@given(st.integers(0, 2**32 - 1))
def test_the_verdict_on_a_four_bar_is_that_of_a_walk_through_its_positions(seed: int) -> None:
    a, b, c, d, seen = _made(np.random.default_rng(seed))
    pins = [(a * cmath.exp(1j * phi), d + c * cmath.exp(1j * psi)) for phi, psi in seen]
    told = fourbar(0j, complex(d), [pin for pin, _ in pins], [pin for _, pin in pins]).defect
    assert told is _judged(_walk(a, b, c, d, seen[0]), seen)


def _made(draw: np.random.Generator) -> tuple[float, float, float, float, list[tuple[float, float]]]:
    """A four-bar and three of its positions, all far from change points and dead points and from each other."""
    while True:
        a, b, c, d = (float(x) for x in draw.uniform(1, 5, 4))
        sides = sorted((a, b, c, d))
        found = [_closed(a, b, c, d, float(phi)) for phi in draw.uniform(-pi, pi, 3)]
        if abs(sides[0] + sides[3] - sides[1] - sides[2]) < 0.3 or not all(found):
            continue
        seen = [both[int(draw.integers(2))] for both in found]
        apart = min(_apart(one, two) for i, one in enumerate(seen) for two in seen[:i])
        if apart > 0.2 and min(_sine(a, c, d, one) for one in seen) > 0.2:
            return a, b, c, d, seen


def _sine(a: float, c: float, d: float, at: tuple[float, float]) -> float:
    """How far the coupler and the output link are from a dead point of the driver."""
    pin, other = a * cmath.exp(1j * at[0]), d + c * cmath.exp(1j * at[1])
    return abs(((pin - other).conjugate() * (d - other)).imag / abs(pin - other) / c)


def test_the_other_link_as_the_driver_may_go_where_the_first_meets_a_dead_point() -> None:
    b = [-36.161064595 + 18.580975618j, -27.592339952 + 21.266535851j, 1.720980235 + 22.479509597j]
    c = [45.488519722 - 31.629820116j, 67.420837422 + 8.606569317j, 97.404133427 + 28.181511228j]
    a, d = -9.961602235 - 50j, 127.06432641 - 50j
    assert (fourbar(a, d, b, c).defect, fourbar(d, a, c, b).defect) == (Defect.BRANCH, None)


def test_a_slider_crank_that_turns_fully_keeps_its_circuit_whatever_drives_it() -> None:
    crank = [20 * cmath.exp(1j * phi) for phi in (0.3, 1.2, 2.4)]
    ahead, behind = ([at.real + side * np.sqrt(60**2 - at.imag**2) + 0j for at in crank] for side in (1, -1))
    assert slider_crank(0j, 1 + 0j, crank, ahead).defect is None
    assert crank_slider(0j, 1 + 0j, crank, ahead).defect is None
    mixed = [ahead[0], behind[1], ahead[2]]
    assert slider_crank(0j, 1 + 0j, crank, mixed).defect is Defect.CIRCUIT
    assert crank_slider(0j, 1 + 0j, crank, mixed).defect is Defect.CIRCUIT


def test_a_rocker_slider_meets_a_dead_point_where_its_rod_is_across_the_guide() -> None:
    rocker = [60 * cmath.exp(1j * phi) for phi in (0.1, 0.25, 0.1)]
    slid = [at.real + side * np.sqrt(20**2 - at.imag**2) + 0j for at, side in zip(rocker, (1, 1, -1), strict=True)]
    assert slider_crank(0j, 1 + 0j, rocker, slid).defect is Defect.BRANCH
    assert crank_slider(0j, 1 + 0j, rocker[:2], slid[:2]).defect is None


def test_positions_out_of_their_order_are_told_so_and_a_full_turn_takes_three_in_any() -> None:
    assert Driven(places=(0.1, 0.5, 0.3), sides=(1, 1, 1)).defect is Defect.ORDER
    assert Driven(places=(0.1, 0.5, 0.3), sides=(1, 1, 1), full=True).defect is None
    assert Driven(places=(0.1, 2.0, 1.0, 3.0), sides=(1, 1, 1, 1), full=True).defect is Defect.ORDER
    assert Driven(places=(0.0, 0.4 * tau, 0.7 * tau, 0.9 * tau), sides=(1, 1, 1, 1), full=True).defect is None


def test_a_position_at_a_dead_point_belongs_to_either_side() -> None:
    assert Driven(places=(0.1, 0.5), sides=(1, 0)).defect is None
    assert Driven(places=(0.1, 0.5), sides=(-1, 0)).defect is None
