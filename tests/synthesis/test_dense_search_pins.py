"""Every pin on its ray that a dense search finds is among the candidates: dead centres, drag links, pairs of angles.

The search tries a pin all along its line and looks where a bar is equally long in two positions.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.synthesis.inversion import pose
from tests.synthesis.test_dense_search import candidates

Reals = npt.NDArray[np.float64]
SEED = st.integers(0, 2**32 - 1)
ALONG = np.linspace(-5.0, 5.0, 40001) ** 5  # mm: a pin on its line, close together in the middle


def passed(off: Callable[[Reals], Reals]) -> list[float]:
    """Where a bar has the same length in both positions."""
    values = off(ALONG)
    n = np.flatnonzero(values[1:] * values[:-1] < 0)
    share = values[n] / (values[n] - values[n + 1])
    return [float(at) for at in ALONG[n] + share * (ALONG[n + 1] - ALONG[n])]


def turn(deg: Any) -> Any:
    """A direction."""
    return np.exp(1j * np.radians(deg))


@settings(max_examples=often(5), deadline=None)
@given(seed=SEED)
def test_no_crank_of_a_dead_centre_is_missed(seed: int) -> None:
    """B on the line A C₂ in position 2, turned back by φ₁₂ in position 1."""
    one, two, back = np.random.default_rng(seed).uniform([60, 10, -170], [170, 120, 170]).round(3).tolist()
    c1, c2 = 100 + 60 * turn(one), 100 + 60 * turn(two)
    way = c2 / abs(c2)
    found = passed(lambda t: np.abs(t * way - c2) - np.abs(t * way / turn(back) - c1))
    drawn = candidates(
        "dead-centre", AD="100 mm", CD="60 mm", psi_1=f"{one} deg", psi_2=f"{two} deg", phi_12=f"{back} deg"
    )
    _same([complex(at.pins["B2"] - at.pins["A"]) for at in drawn], [t * way for t in found])


@settings(max_examples=often(5), deadline=None)
@given(seed=SEED)
def test_no_driven_crank_of_a_drag_link_is_missed(seed: int) -> None:
    """C on the ray of DC in position 1, beyond D in position 2."""
    rng = np.random.default_rng(seed)
    k, phi, psi, frame = rng.uniform([1.1, 0, 0, 15], [2.5, 360, 360, 50]).round(3).tolist()
    b1, b2, way = 60 * turn(phi), 60 * turn(phi + 360 / (k + 1)), turn(psi)
    found = passed(lambda t: np.abs(frame + t * way - b1) - np.abs(frame - t * way - b2))
    data = {"AD": f"{frame} mm", "AB": "60 mm", "K": f"{k}", "phi_1": f"{phi} deg", "psi_1": f"{psi} deg"}
    drawn = candidates("drag-link", **data)
    _same([complex(at.pins["C1"] - at.pins["D"]) for at in drawn], [t * way for t in found])


@settings(max_examples=often(5), deadline=None)
@given(seed=SEED)
def test_no_pin_on_a_line_of_the_output_link_is_missed(seed: int) -> None:
    """Two pairs of angles; C on a line beside DE."""
    rng = np.random.default_rng(seed)
    phi, psi = np.cumsum(rng.uniform(8, 60, 2)).round(3), np.cumsum(rng.uniform(8, 60, 2)).round(3)
    aside = round(float(rng.uniform(-20, 20)), 2)
    b = 40 * turn(phi)
    found = passed(
        lambda t: (
            np.abs(100 + (t + 1j * aside) * turn(psi[0]) - b[0]) - np.abs(100 + (t + 1j * aside) * turn(psi[1]) - b[1])
        )
    )
    pairs = [f"{one} deg -> {two} deg" for one, two in zip(phi.tolist(), psi.tolist(), strict=True)]
    drawn = candidates("angle-pairs", AB="40 mm", AD="100 mm", pairs=pairs, C=f"on y = {aside} mm")
    _same([complex((at.pins["C1"] - at.pins["D"]) / turn(psi[0])) for at in drawn], [t + 1j * aside for t in found])


def _same(drawn: list[complex], found: list[complex]) -> None:
    """Each that was found is drawn, and no other within the reach of the search."""
    for at in found:
        assert any(other == pytest.approx(at, rel=1e-3, abs=0.1) for other in drawn), (at, drawn)
    reach = 0.9 * float(ALONG[-1])
    assert len([at for at in drawn if abs(at) < reach]) <= len(found)


@settings(max_examples=often(4), deadline=None)
@given(seed=SEED)
def test_every_bar_of_four_positions_is_as_long_in_each_and_its_pins_go_with_the_body(seed: int) -> None:
    rng = np.random.default_rng(seed)
    turns, at = np.cumsum(rng.uniform(8, 30, 4)).round(2), np.cumsum(rng.uniform(-20, 40, (4, 2)), axis=0).round(2)
    poses = [pose(float(x), float(y), float(deg)) for (x, y), deg in zip(at, turns, strict=True)]
    starts, level = at[:, 0] + 1j * at[:, 1], int(rng.integers(-90, 90))
    for one in candidates("positions", poses=poses, A=f"on y = {level} mm", D=f"on y = {level} mm"):
        for fixed, moving in ("AB", "DC"):
            pins = np.array([one.pins[f"{moving}{n}"] for n in (1, 2, 3, 4)])
            bars, on_body = np.abs(pins - one.pins[fixed]), (pins - starts) / turn(turns)
            size = bars.max() + np.abs(pins).max()
            assert abs(one.pins[fixed].imag - level) < 1e-6 * size
            assert np.ptp(bars) < 1e-6 * size and np.abs(on_body - on_body[0]).max() < 1e-6 * size
