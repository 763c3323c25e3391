"""Every solution that a dense search finds is among the candidates; mirrored data give mirrored solutions."""

from __future__ import annotations

from math import cos, degrees, pi, radians, sin

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.laws import few, often
from tests.synthesis.test_laws import posed, ratios, solutions, swings
from vecpoly.designs.crank_rocker import LEAST, NEAREST

Numbers = npt.NDArray[np.float64]
CD, DENSE = 100.0, 20001  # mm; places of a search
WRITTEN = {
    "AB": "{:.12g} mm", "BC": "{:.12g} mm", "AD": "{:.12g} mm", "gamma_min": "{:.12g} deg", "x": "on x = {:.12g} mm",
    "y": "on y = {:.12g} mm",
}  # fmt: skip


def along(k: float, swing: float, side: int) -> tuple[dict[str, Numbers], npt.NDArray[np.bool_]]:
    """What linkages with A along one circle of K have, and which of them a rocker can swing in; D is the origin."""
    theta, half = pi * (k - 1) / (k + 1) / 2, radians(swing) / 2
    chord, level = 2 * CD * sin(half), CD * cos(half)
    u = theta + np.geomspace(NEAREST * sin(2 * theta), pi / 2 - theta, DENSE)[1:-1]  # from A beside C₁ to the bisector
    ab, bc = chord / 2 * np.cos(u) / cos(theta), chord / 2 * np.sin(u) / sin(theta)
    x = -2 * ab * bc / chord
    y = level + side * np.sqrt(np.maximum((bc - ab) ** 2 - (x + chord / 2) ** 2, 0))
    ad, one, other = np.hypot(x, y), -x * level + y * -chord / 2, -x * level + y * chord / 2
    both = [
        np.degrees(np.arccos(np.clip((bc**2 + CD**2 - (ad + way * ab) ** 2) / (2 * bc * CD), -1, 1))) for way in (-1, 1)
    ]
    gamma = np.min([np.minimum(mu, 180 - mu) for mu in both], axis=0)
    return {"AB": ab, "BC": bc, "AD": ad, "gamma_min": gamma, "x": x, "y": y}, one * other > 0


def count(values: Numbers, usable: npt.NDArray[np.bool_], wanted: float) -> int:
    """How often the wanted value is passed."""
    off = values - wanted
    return int(np.count_nonzero((off[1:] * off[:-1] < 0) & usable[1:] & usable[:-1]))


@pytest.mark.parametrize("datum", few(tuple(WRITTEN), 3))
@settings(max_examples=often(1, 80), deadline=None)
@given(k=ratios, swing=swings, share=st.floats(0.02, 0.98), side=st.sampled_from([-1, 1]))
def test_no_crank_rocker_of_a_dense_search_is_missed(
    datum: str, k: float, swing: float, share: float, side: int
) -> None:
    found = {way: along(k, swing, way) for way in (-1, 1)}
    values, usable = found[side]
    assume(usable.any())
    within = (values["AB"] < values["AB"].max() * (1 - share)) & usable  # any crank, short or long
    assume(within.any())
    n = int(np.argmax(within))
    wanted = float(values[datum][n : n + 2].mean())
    assume(datum != "gamma_min" or wanted > 1.001 * degrees(LEAST))
    counts = {
        sum(count(have[datum], good, wanted * (1 + slip)) for have, good in found.values()) for slip in (-1e-4, 0, 1e-4)
    }
    assume(len(counts) == 1)  # one that is touched, or stands at the end of what can be used, is for neither
    given_as = {"A": WRITTEN[datum]} if datum in "xy" else {datum: WRITTEN[datum]}
    data = {key: text.format(wanted) for key, text in given_as.items()}
    drawn = solutions(posed("crank-rocker", K=f"{k!r}", CD=f"{CD} mm", swing=f"{swing!r} deg", **data))
    assert {len(drawn)} == counts


@settings(max_examples=often(4), deadline=None)
@given(k=ratios, adc=st.floats(15, 165), frame=st.floats(40, 250))
def test_no_other_limit_of_a_dense_search_is_missed(k: float, adc: float, frame: float) -> None:
    theta = pi * (k - 1) / (k + 1)
    c1 = frame - CD * np.exp(-1j * radians(adc))
    psi = np.linspace(-pi, pi, DENSE)
    c2 = frame + CD * np.exp(1j * psi)
    off = np.abs(np.angle(c2 / c1)) - theta
    usable = (c2.imag * c1.imag > 0) & (np.abs(np.abs(c2) - abs(c1)) > 1e-3)
    counts = {count(off, usable, slip) for slip in (-1e-3, 0.0, 1e-3)}
    assume(len(counts) == 1)
    data = {"K": f"{k!r}", "CD": f"{CD} mm", "ADC": f"{adc!r} deg", "AD": f"{frame!r} mm"}
    assert {len(solutions(posed("crank-rocker", **data)))} == counts


TURNS = st.floats(5, 355)


@settings(max_examples=often(4), deadline=None)
@given(k=ratios, phi=TURNS, psi=TURNS, frame=st.floats(15, 50))
def test_a_mirrored_drag_link_is_the_same(k: float, phi: float, psi: float, frame: float) -> None:
    """The other way round it takes the quick half first: from the second position, 360° − β on."""
    beta = 360 / (k + 1)
    here = _verdict("drag-link", AD=f"{frame!r} mm", AB="60 mm", K=f"{k!r}", phi_1=f"{phi!r} deg", psi_1=f"{psi!r} deg")
    there = _verdict(
        "drag-link",
        AD=f"{frame!r} mm",
        AB="60 mm",
        K=f"{k!r}",
        phi_1=f"{-phi - beta!r} deg",
        psi_1=f"{-psi - 180!r} deg",
    )
    assert here[0] == there[0] and here[1] == pytest.approx(there[1], rel=1e-6)


@settings(max_examples=often(4), deadline=None)
@given(one=TURNS, other=TURNS, turn=TURNS)
def test_a_mirrored_dead_centre_is_the_same(one: float, other: float, turn: float) -> None:
    here, there = (
        _verdict(
            "dead-centre",
            AD="100 mm",
            CD="60 mm",
            psi_1=f"{way * one!r} deg",
            psi_2=f"{way * other!r} deg",
            phi_12=f"{way * turn!r} deg",
        )
        for way in (1, -1)
    )
    assert here[0] == there[0] and here[1] == pytest.approx(there[1], rel=1e-6)


def _verdict(kind: str, **data: str) -> tuple[str, list[float]]:
    """What is said of the one candidate, and its pins' distances from A (mm on paper, in ratios)."""
    solution = posed(kind, **data).solve(by="exact")
    warning = solution.construction.warning
    assert warning is None or "badly conditioned" in warning.en, warning  # as of two positions that hardly differ
    (one,) = solution.construction.candidates
    a, scale = one.pins["A"], abs(one.pins["D"] - one.pins["A"])
    return one.verdict, sorted(abs(at - a) / scale for at in one.pins.values())
