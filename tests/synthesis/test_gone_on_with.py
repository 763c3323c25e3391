"""What a synthesis finds can be gone on with, driven by the link that leads it through its positions."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from tests.drawn_library import LIBRARY, given
from tests.each import Later, each
from tests.synthesis.inversion import posed
from vecpoly.check.grashof import CRANK_ROCKER, DOUBLE_CRANK, DRIVEN_BY_ROCKER, PARALLELOGRAM, grashof
from vecpoly.designs.base import Design

SEVERAL = {"8-1", "cognates"}  # inversions of one chain; two linkages beside the given one
FOUND = Later(lambda: [one for one in LIBRARY if one not in SEVERAL and isinstance(given(one).subject, Design)])
LED_BY_DC = [  # positions of a body, B and C on it (mm): AB would meet a dead point between the positions
    (("(-2, 12) mm at 75 deg", "(30, 17) mm at 26 deg", "(62, 39) mm at -4 deg"), (-9, 8), (43, -9)),
    (("(16, 16) mm at -60 deg", "(65, 3) mm at -68 deg", "(102, -16) mm at -96 deg"), (18, 11), (51, -8)),
]
ROCKING = [
    "8-6",
    "8-6-2",
    "8-8",
    "8-11",
    "three-positions",
    "three-positions-frame",
    "four-positions-b",
    "function-log",
]


@each(FOUND)
def test_every_linkage_that_a_task_of_the_library_finds_is_a_problem_that_can_be_solved(name: str) -> None:
    found = vecpoly.load(name).solve(by="exact").linkage
    assert isinstance(found, vecpoly.Problem)
    answers = found.solve(by="exact").answers.values()
    assert answers
    for one in answers:
        assert one.drawn == pytest.approx(one.exact, rel=1e-6, abs=1e-9)
    assert np.isfinite(found.cycle(37).column("omega_1")).any()


@pytest.mark.parametrize(("poses", "b", "c"), LED_BY_DC)
def test_a_linkage_that_only_dc_leads_through_its_positions_is_driven_by_it(
    poses: tuple[str, ...], b: tuple[float, float], c: tuple[float, float]
) -> None:
    """AB stands near a dead point: with the lengths read such a linkage did not even close."""
    body = {"B": [f"{x} mm" for x in b], "C": [f"{x} mm" for x in c]}
    task = posed("positions", poses=list(poses), body=body)
    for hand in ("exact", "drafting", "pencil"):
        done = task.solve(by=hand)
        (one,), (candidate,) = done.verification, done.construction.candidates
        assert candidate.last and one.broken is None and one.driver == "DC"
        drive = done.mechanism.drive
        assert "".join(done.mechanism.link(drive.link).axis) == "DC"


def least_between(pins: dict[str, complex], a: str, b: str, c: str, d: str) -> float:
    """The least transmission angle (deg) while AB turns from the first of its positions to the last: by circles."""
    count = sum(f"{b}{n}" in pins for n in range(1, 10))
    at = [np.angle((pins[f"{b}{n}"] - pins[a]) / (pins[f"{b}1"] - pins[a])) for n in range(1, count + 1)]
    crank = (pins[f"{b}1"] - pins[a]) * np.exp(1j * np.linspace(min(at), max(at), 2001))
    span = pins[d] - (pins[a] + crank)
    near, far = abs(pins[f"{c}1"] - pins[f"{b}1"]), abs(pins[f"{c}1"] - pins[d])
    cosine = (near**2 + far**2 - np.abs(span) ** 2) / (2 * near * far)
    assert np.abs(cosine).max() <= 1
    corner = np.degrees(np.arccos(cosine))
    return float(np.minimum(corner, 180 - corner).min())


@each(ROCKING)
def test_of_a_linkage_that_rocks_the_least_transmission_angle_between_its_positions_is_told(name: str) -> None:
    done = vecpoly.load(name).solve(by="exact")
    (one,) = (one for one in done.verification if one.number == 1)
    candidate = next(one for one in done.construction.candidates if one.number == 1)
    assert not one.full and not candidate.last
    assert one.between == pytest.approx(least_between(dict(candidate.pins), *"ABCD"), abs=1e-3)


def test_a_chain_is_told_the_type_of_its_four_bar_and_the_angle_between_its_positions() -> None:
    (one,) = vecpoly.load("8-13").solve(by="exact").verification
    assert one.kind is not None and "not Grashof" in one.kind.en and not one.full
    pins = {"A": 0j, "B1": 10.26258j, "B2": 10.26258 * np.exp(1j * np.pi / 6)}
    pins |= {"D": 30 + 0j, "C1": 30 + 37.260211 * np.exp(1j * np.pi / 4)}
    assert one.between == pytest.approx(least_between(pins, *"ABCD"), abs=1e-3)


def test_a_rocker_slider_that_is_found_on_the_coupler_s_line_is_moved() -> None:
    (one,) = vecpoly.load("8-10").solve(by="exact").verification
    assert one.broken is None and not one.full and 0 < one.between < 90


def test_equal_opposite_sides_are_a_parallelogram_and_of_a_kite_what_turns_is_a_crank() -> None:
    assert grashof(56.84, 90, 56.84, 90)[0] == grashof(56.84, 30, 56.84, 30)[0] == PARALLELOGRAM
    assert grashof(30, 60, 60, 30)[0] == DOUBLE_CRANK
    assert grashof(30, 30, 60, 60)[0] == CRANK_ROCKER
    assert grashof(60, 30, 30, 60)[0] == DRIVEN_BY_ROCKER
    parallel = [f"({x}, {y}) mm at 0 deg" for x, y in ((20, 70), (45, 82), (75, 80))]
    task = posed("positions", poses=parallel, frame={"A": ["0 mm", "0 mm"], "D": ["90 mm", "0 mm"]})
    (one,) = task.solve(by="exact").verification
    assert one.kind == PARALLELOGRAM and one.spoilt is None
