"""Laws of linkages through positions: they go through them, none is missed, and paper may be moved or turned over."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import cos, pi, radians, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import root

from tests.laws import often
from tests.synthesis.inversion import drawn_anyhow, place, pose, posed
from vecpoly.designs.base import Design
from vecpoly.errors import AssemblyError
from vecpoly.oracle.synthesis.inversion.linkages import angle_pairs, positions
from vecpoly.oracle.synthesis.registry import Linkage

SEED = st.integers(0, 2**32 - 1)
Motion = list[tuple[float, float, float]]  # x, y (mm) and the angle (deg) of a body


def _motion(draw: np.random.Generator, count: int) -> Motion:
    """Positions that a mechanism might have: near each other, turned one way."""
    angles = np.cumsum(draw.uniform(10, 40, count))
    places = np.cumsum(draw.uniform(-40, 40, (count, 2)), axis=0)
    return [
        (round(float(x), 3), round(float(y), 3), round(float(a), 3)) for (x, y), a in zip(places, angles, strict=True)
    ]


def _spot(draw: np.random.Generator) -> tuple[float, float]:
    return round(float(draw.uniform(-50, 50)), 3), round(float(draw.uniform(-50, 50)), 3)


def _pins_given(motion: Motion, b: tuple[float, float], c: tuple[float, float]) -> dict[str, Any]:
    data: dict[str, Any] = {"poses": [pose(*at) for at in motion], "body": {"B": place(*b), "C": place(*c)}}
    return data if len(motion) == 3 else data | {"A": "on y = -70 mm", "D": "on x = 60 mm"}


def _lengths(values: Mapping[str, float]) -> dict[str, float]:
    """AB, BC, CD, AD (mm)."""
    return {key: values[key] for key in ("AB", "BC", "CD", "AD")}


def _one(data: dict[str, Any]) -> Linkage:
    (found,) = positions(_design("positions", data))
    assume(max(found.values.values()) < 2000)
    return found


def _design(kind: str, data: dict[str, Any]) -> Any:
    subject = posed(kind, **data).subject
    assert isinstance(subject, Design)
    return subject


def _assembled(lengths: dict[str, float], a: complex, d: complex, b: complex) -> list[complex]:
    """Both places of C, by nothing but the lengths found (mm)."""
    span, ab = d - b, abs(d - b)
    along = (ab**2 + lengths["BC"] ** 2 - lengths["CD"] ** 2) / (2 * ab)
    across = np.sqrt(max(lengths["BC"] ** 2 - along**2, 0.0))
    return [b + span / ab * complex(along, side * across) for side in (1, -1)]


@given(SEED)
@settings(max_examples=often(6))
def test_a_linkage_on_paper_goes_through_the_given_positions(seed: int) -> None:
    draw = np.random.default_rng(seed)
    motion, pins = _motion(draw, int(draw.integers(2, 4))), (_spot(draw), _spot(draw))
    data = _pins_given(motion, *pins)
    true = _one(data)
    (found,) = drawn_anyhow("positions", **data)
    a, d = (found.pins[letter] for letter in "AD")
    b, c = (found.pins[f"{letter}1"] for letter in "BC")
    lengths = {"AB": abs(b - a), "BC": abs(c - b), "CD": abs(d - c), "AD": abs(d - a)}
    assert lengths == pytest.approx(_lengths(true.values), rel=1e-6)
    for x, y, deg in motion:
        at, turn = complex(x, y), cmath.exp(1j * radians(deg))
        b, c = (at + turn * complex(*pin) for pin in pins)
        assert abs(b - a) == pytest.approx(lengths["AB"], rel=1e-6)
        assert min(abs(c - other) for other in _assembled(lengths, a, d, b)) < 1e-4 * (1 + lengths["CD"])


@given(SEED)
@settings(max_examples=often(10))
def test_the_verdict_read_off_the_paper_is_that_of_the_closed_form(seed: int) -> None:
    draw = np.random.default_rng(seed)
    data = _pins_given(_motion(draw, 3), _spot(draw), _spot(draw))
    true = _one(data)
    (found,) = drawn_anyhow("positions", **data)
    assert found.verdict == true.verdict.name


@given(SEED, st.floats(-300, 300), st.floats(-pi, pi))
def test_the_whole_paper_may_be_moved_and_turned(seed: int, shift: float, turn: float) -> None:
    draw = np.random.default_rng(seed)
    motion, pins = _motion(draw, 3), (_spot(draw), _spot(draw))
    carried = [
        (*_turned(x, y, turn, shift), deg + turn * 180 / pi)  # of the body's pins nothing changes
        for x, y, deg in motion
    ]
    here, there = _one(_pins_given(motion, *pins)), _one(_pins_given(carried, *pins))
    assert _lengths(there.values) == pytest.approx(_lengths(here.values), rel=1e-5)
    assert there.verdict is here.verdict


def _turned(x: float, y: float, turn: float, shift: float) -> tuple[float, float]:
    return x * cos(turn) - y * sin(turn) + shift, x * sin(turn) + y * cos(turn) - shift / 2


@given(SEED)
def test_data_seen_in_a_mirror_give_the_linkage_seen_in_it(seed: int) -> None:
    draw = np.random.default_rng(seed)
    motion, (b, c) = _motion(draw, 3), (_spot(draw), _spot(draw))
    seen = [(x, -y, -deg) for x, y, deg in motion]
    here = _one(_pins_given(motion, b, c))
    there = _one(_pins_given(seen, (b[0], -b[1]), (c[0], -c[1])))
    assert _lengths(there.values) == pytest.approx(_lengths(here.values), rel=1e-6)
    assert there.verdict is here.verdict
    assert 1e3 * there.pins["A"] == pytest.approx(1e3 * here.pins["A"].conjugate(), rel=1e-6, abs=1e-4)


@given(SEED)
def test_fixed_pins_given_are_found_again_from_the_moving_pins_that_they_give(seed: int) -> None:
    draw = np.random.default_rng(seed)
    motion, a, d = _motion(draw, 3), _spot(draw), _spot(draw)
    data = {"poses": [pose(*at) for at in motion], "frame": {"A": place(*a), "D": place(*d)}}
    first = _one(data)
    at, turn = complex(*motion[0][:2]), cmath.exp(1j * radians(motion[0][2]))
    b, c = ((1e3 * first.pins[f"{letter}1"] - at) / turn for letter in "BC")
    again = _one(_pins_given(motion, (b.real, b.imag), (c.real, c.imag)))
    assert _lengths(again.values) == pytest.approx(_lengths(first.values), rel=1e-4)


@given(SEED)
@settings(max_examples=often(6))
def test_no_linkage_of_a_search_from_many_starts_is_missed(seed: int) -> None:
    draw = np.random.default_rng(seed)
    phi, psi = (np.round(np.cumsum(draw.uniform(10, 40, 3)), 3) for _ in range(2))
    pairs = [f"{one!r} deg -> {two!r} deg" for one, two in zip(phi.tolist(), psi.tolist(), strict=True)]
    data = {"AB": "30 mm", "AD": "70 mm", "pairs": pairs}
    (true,) = angle_pairs(_design("angle-pairs", data))
    assume(max(true.values["BC"], true.values["CD"]) < 500)
    for found in _searched(np.radians(phi), np.radians(psi), draw):
        assert found == pytest.approx((true.values["BC"], true.values["CD"]), rel=1e-5)


def _searched(phi: Any, psi: Any, draw: np.random.Generator) -> list[tuple[float, float]]:
    """BC and CD by Newton's method on the three loops, unknown BC and the place of C on its link."""
    b = 30 * np.exp(1j * phi)

    def off(x: Any) -> Any:
        return np.abs(70 + np.exp(1j * psi) * complex(x[1], x[2]) - b) ** 2 - x[0] ** 2

    ends = [root(off, start) for start in draw.uniform(-120, 120, (12, 3))]
    good = [end.x for end in ends if end.success and np.abs(off(end.x)).max() < 1e-6 and np.abs(end.x).max() < 500]
    return [(abs(float(x[0])), float(np.hypot(x[1], x[2]))) for x in good]


def test_places_in_a_row_are_refused_and_a_slider_is_advised() -> None:
    data = {"poses": [pose(0, 0, 0), pose(30, 0, 20), pose(70, 0, 50)], "body": {"B": place(0, 0), "C": place(30, 5)}}
    with pytest.raises(AssemblyError, match="B needs a slider, on a guide at 0 deg") as refused:
        posed("positions", **data).solve()
    assert "B 需要一个滑块" in refused.value.words.zh
