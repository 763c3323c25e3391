"""Every solution that a dense search finds is among the candidates: slider-cranks, function generators, four positions.

The searches know the geometry of the task alone: from where a chord is seen, how far pins are apart, whether four
places lie on one circle.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise, product
from math import cos, pi, sin
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.synthesis.inversion import drawn_anyhow, pose, posed
from vecpoly.board.candidates import Candidate
from vecpoly.errors import AssemblyError, DeadPointError

Numbers = npt.NDArray[np.float64]
Places = npt.NDArray[np.complex128]
SEED = st.integers(0, 2**32 - 1)
DENSE, FAR = 40001, 50.0  # places of a search, and how far it goes, in sizes of the figure


def candidates(kind: str, **data: Any) -> tuple[Candidate, ...]:
    """Everything that is drawn, valid or not; nothing where the data are refused."""
    try:
        return drawn_anyhow(kind, **data)
    except (AssemblyError, DeadPointError):
        return ()


# -- slider-cranks -------------------------------------------------------------------------------------------------


def seen_under(theta: float, stroke: float) -> Places:
    """Every A above the guide from which the stroke from 0 is seen under θ: an arc through both of its ends."""
    radius = stroke / 2 / sin(theta)
    half = np.linspace(0, pi - theta, DENSE)[1:-1]  # from the top of the arc to C₁, A on the left
    ends = np.pi - theta - np.geomspace(1e-9, 1e-3, DENSE)[::-1]  # and once more close to C₁
    turn = np.unique(np.concatenate([half, ends]))
    return np.asarray(stroke / 2 + 1j * radius * cos(theta) + 1j * radius * np.exp(1j * turn), np.complex128)


@pytest.mark.parametrize("datum", ["AB", "BC", "e"])
@settings(max_examples=often(2, 120), deadline=None)
@given(k=st.floats(1.05, 1.9), stroke=st.floats(40, 200), share=st.floats(0.02, 0.98))
def test_no_slider_crank_of_a_dense_search_is_missed(datum: str, k: float, stroke: float, share: float) -> None:
    at = seen_under(pi * (k - 1) / (k + 1), stroke)
    near, far = np.abs(at), np.abs(at - stroke)
    of = {"AB": (far - near) / 2, "BC": (far + near) / 2, "e": at.imag}
    wanted = float(of[datum].min() + share * np.ptp(of[datum]))
    off = of[datum] - wanted
    passed = np.flatnonzero(off[1:] * off[:-1] < 0)
    found = [{key: float(value[n : n + 2].mean()) for key, value in of.items()} for n in passed]
    drawn = candidates("slider-crank", K=f"{k!r}", H=f"{stroke!r} mm", **{datum: f"{wanted!r} mm"})
    assert len(drawn) == len(found)
    for one, other in zip(drawn, found, strict=True):
        ends = sorted(abs(one.pins[c] - one.pins["A"]) for c in ("C1", "C2"))
        lengths = (ends[1] - ends[0]) / 2, (ends[1] + ends[0]) / 2
        assert lengths == pytest.approx((other["AB"], other["BC"]), abs=1e-3 * stroke)


@settings(max_examples=often(6), deadline=None)
@given(k=st.floats(1.05, 1.9), stroke=st.floats(40, 200), share=st.floats(0.02, 0.9))
def test_the_mirror_image_of_a_slider_crank_has_the_same_stroke_and_is_announced(
    k: float, stroke: float, share: float
) -> None:
    at = seen_under(pi * (k - 1) / (k + 1), stroke)
    crank = share * stroke / 2
    data = {"K": f"{k!r}", "H": f"{stroke!r} mm", "AB": f"{crank!r} mm"}
    (one,) = candidates("slider-crank", **data)
    a, c1 = one.pins["A"], one.pins["C1"]
    assert min(abs(at - (a - c1))) < 1e-2 * stroke  # on the left; its image on the right is seen under θ too
    steps = posed("slider-crank", **data).solve(by="exact").construction.steps
    assert any("mirror image" in step.words.en for step in steps)


# -- function generators -------------------------------------------------------------------------------------------


def generators(phi: Numbers, psi: Numbers) -> list[tuple[float, float, float]]:
    """(AB, BC, CD) in frames, AB and CD with signs: for every CD the AB that keeps BC alike at the first two pairs,
    where BC at the third is the same too."""
    c = np.concatenate([-np.geomspace(FAR, 1 / FAR, DENSE), np.geomspace(1 / FAR, FAR, DENSE)])
    first, second, third = ((np.cos(one), np.cos(two), np.cos(two - one)) for one, two in zip(phi, psi, strict=True))
    under = first[0] - second[0] + c * (first[2] - second[2])
    a = c * (first[1] - second[1]) / under

    def coupler(pair: tuple[float, float, float], a: Any, c: Any) -> Any:
        return 1 + a * a + c * c + 2 * c * pair[1] - 2 * a * pair[0] - 2 * a * c * pair[2]

    off = coupler(third, a, c) - coupler(first, a, c)
    found = []
    smooth = (c[1:] * c[:-1] > 0) & (under[1:] * under[:-1] > 0)
    for n in np.flatnonzero((off[1:] * off[:-1] < 0) & smooth):
        share = off[n] / (off[n] - off[n + 1])
        ends = tuple(float(of[n] + share * (of[n + 1] - of[n])) for of in (a, c))
        found.append((ends[0], float(np.sqrt(max(coupler(first, *ends), 0.0))), ends[1]))
    return [one for one in found if 1 / FAR < abs(one[0]) < FAR]


@settings(max_examples=often(5), deadline=None)
@given(seed=SEED)
def test_no_function_generator_of_a_dense_search_is_missed(seed: int) -> None:
    rng = np.random.default_rng(seed)
    phi, psi = (np.cumsum(rng.uniform(8, 60, 3)) + rng.uniform(0, 360) for _ in range(2))
    pairs = [f"{one!r} deg -> {two!r} deg" for one, two in zip(phi.tolist(), psi.tolist(), strict=True)]
    found = generators(np.radians(phi), np.radians(psi))
    drawn = candidates("function-generator", AD="1000 mm", pairs=pairs)
    have = [_lengths(one.pins, phi, psi) for one in drawn]
    for one in found:
        assert any(other == pytest.approx([1e3 * x for x in one], rel=1e-4, abs=0.1) for other in have)
    inside = [one for one in have if all(20.1 < abs(x) < 49e3 for x in (one[0], one[2]))]
    assert len(inside) <= len(found)


def _lengths(pins: Mapping[str, complex], phi: Numbers, psi: Numbers) -> tuple[float, float, float]:
    """AB, BC, CD of what stands on paper, with signs: against its angle a link is negative."""
    ab, dc = pins["B1"] - pins["A"], pins["C1"] - pins["D"]
    ahead = (float((at * np.exp(-1j * np.radians(angle))).real) for at, angle in ((ab, phi[0]), (dc, psi[0])))
    return next(ahead), abs(pins["C1"] - pins["B1"]), next(ahead)


# -- four positions ------------------------------------------------------------------------------------------------


def round_ones(poses: list[tuple[float, float, float]], level: float) -> list[float]:
    """x of every A on the line y = level whose four places on the body lie on one circle: the power of the fourth with
    respect to the circle of the others changes its sign."""
    x = np.linspace(-30, 30, DENSE) ** 3  # mm, close together in the middle
    a = x + 1j * level
    seen = [(a - complex(px, py)) * np.exp(-1j * np.radians(deg)) for px, py, deg in poses]
    two, three, four = (z - seen[0] for z in seen[1:])
    area = (np.conj(two) * three).imag
    centre = 1j * (two * np.abs(three) ** 2 - three * np.abs(two) ** 2) / (2 * area)
    power = (np.abs(four) ** 2 - 2 * (np.conj(centre) * four).real) * area  # a cubic: without the pole where area = 0
    share = power[:-1] / (power[:-1] - power[1:])
    return [float(x[n] + share[n] * (x[n + 1] - x[n])) for n in np.flatnonzero(power[1:] * power[:-1] < 0)]


@settings(max_examples=often(2, 120), deadline=None)
@given(seed=SEED)
def test_no_centre_point_of_a_dense_search_is_missed(seed: int) -> None:
    """A on one line, D on another: each of the centre points on them with each of the others is a candidate."""
    rng = np.random.default_rng(seed)
    turns, at = np.cumsum(rng.uniform(8, 30, 4)).round(2), np.cumsum(rng.uniform(-20, 40, (4, 2)), axis=0).round(2)
    poses = [(float(x), float(y), float(deg)) for (x, y), deg in zip(at, turns, strict=True)]
    levels = rng.choice(np.arange(-90, 90), 2, replace=False).tolist()
    found = [[x for x in round_ones(poses, level) if abs(x) < 5000] for level in levels]
    assume(all(abs(b - a) > 1 for one in found for a, b in pairwise(one)))  # two that touch are for neither
    assume(all(found))
    data = {"poses": [pose(*one) for one in poses], "A": f"on y = {levels[0]} mm", "D": f"on y = {levels[1]} mm"}
    have = [(one.pins["A"].real, one.pins["D"].real) for one in candidates("positions", **data)]
    for pair in product(*found):
        assert any(other == pytest.approx(pair, rel=1e-3, abs=0.1) for other in have)
    near = [one for one in have if all(abs(x) < 4900 for x in one)]
    assert len(near) <= len(found[0]) * len(found[1])


def test_two_centre_points_closer_on_paper_than_one_trial_and_the_next_are_found() -> None:
    """The circle point of a third is 37 m away, so that the sheet has a small scale."""
    poses = [(25.4, -18.57, 29.04), (39.2, -37.57, 53.14), (52.8, 1.07, 79.16), (40.91, 33.93, 90.32)]
    drawn = candidates("positions", poses=[pose(*one) for one in poses], A="on y = -55 mm", D="on y = 21 mm")
    assert len(drawn) == 9
    assert {round(one.pins["D"].real, 2) for one in drawn} == {-15.57, 1.61, 7.21}
