"""Linkages that all but stand at a change point are drawn by every hand: arcs that miss by a hair touch."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.synthesis.inversion import posed
from vecpoly.errors import VecpolyError
from vecpoly.report.document import report_bytes
from vecpoly.solution import REPEATS, Solution, solve

NEAR: tuple[tuple[str, dict[str, Any], str], ...] = (
    ("crank-rocker", {"K": "1.25", "CD": "80 mm", "swing": "40 deg", "A": "on x = -70 mm", "take": "2"}, "gamma_min"),
    (
        "limit-lines",
        {"C1": "(0, 0) mm", "line_1": "213 deg", "C2": "(34, 24) mm", "line_2": "260 deg", "alpha_1": "52 deg"},
        "gamma_min",
    ),
    ("slider-crank", {"K": "1.82", "H": "38 mm", "AB": "9.7 mm"}, "gamma_min"),
)


def drawn(kind: str, by: str, data: dict[str, Any], seed: int = 0, repeats: int = REPEATS) -> Solution:
    """The solution by this hand, with repeated hands beside it."""
    return solve(posed(kind, **data), by=by, seed=seed, repeats=repeats)


@pytest.mark.parametrize("by", ["exact", "drafting", "pencil"])
@pytest.mark.parametrize(("kind", "data", "key"), NEAR, ids=[kind for kind, _, _ in NEAR])
def test_a_least_angle_below_what_can_be_drawn_is_read_with_its_error_and_alone_may_be_no_answer(
    kind: str, data: dict[str, Any], key: str, by: str
) -> None:
    found = drawn(kind, by, data)
    answer = found.answers[key]
    assert [each.key for each in found.answers.values() if each.suspect] in ([], [key])
    assert 0 < answer.exact < 1 and abs(answer.drawn - answer.exact) <= max(answer.expected_error, 1e-6)


def test_arcs_that_only_touch_are_said_to() -> None:
    steps = drawn("limit-lines", "pencil", NEAR[1][1]).construction.steps
    assert any("they touch, and $C′$ lies on the line $BD$" in step.words.en for step in steps)
    assert any("$C′$ 在直线 $BD$ 上" in step.words.zh for step in steps)


def test_their_report_is_written() -> None:
    assert report_bytes([drawn("limit-lines", "drafting", NEAR[1][1])], lang="zh").startswith(b"%PDF")


@settings(max_examples=often(3), deadline=None)
@given(k=st.floats(1.05, 1.8), swing=st.floats(15, 90), x=st.floats(2, 150), seed=st.integers(0, 99))
def test_what_the_exact_hand_draws_every_hand_draws(k: float, swing: float, x: float, seed: int) -> None:
    data = {"K": f"{k!r}", "CD": "80 mm", "swing": f"{swing!r} deg", "A": f"on x = {-x!r} mm"}
    try:
        count = len(drawn("crank-rocker", "exact", data, repeats=0).construction.candidates)
    except VecpolyError:
        assume(False)
    assert len(drawn("crank-rocker", "drafting", data, seed, 0).construction.candidates) == count
