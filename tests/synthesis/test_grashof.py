"""The condition for a crank: exercise 8-1, and the range of a link against turning every chain."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vecpoly
from tests.laws import often
from tests.synthesis.inversion import posed, solved
from vecpoly.errors import ProblemFileError


def test_exercise_8_1_is_solved_and_the_book_is_right() -> None:
    found = {key: answer.drawn for key, answer in solved(vecpoly.load("8-1")).answers.items()}
    assert found == pytest.approx({"ends": 840, "middle": 900, "CD_min": 140, "CD_max": 1340}, rel=1e-9)


@settings(max_examples=often(8))
@given(a=st.floats(20, 60), b=st.floats(61, 150), d=st.floats(61, 150), share=st.floats(0.02, 0.98))
def test_within_the_range_no_link_on_the_frame_turns_fully_and_below_it_one_does(
    a: float, b: float, d: float, share: float
) -> None:
    assume(abs(abs(b - d) - a) > 1)
    assume(a + b + d > 101 and abs(b - d) - a < 99)
    problem = posed("grashof", AB=f"{a!r} mm", BC=f"{b!r} mm", CD="100 mm", AD=f"{d!r} mm")
    solution = solved(problem)
    found = solution.answers
    assert not solution.suspect
    low, high = found["CD_min"].drawn, found["CD_max"].drawn
    frame = low + share * (high - low)
    assert not _turns(b, frame, d, a)
    assert not _turns(d, frame, b, a)
    if a > abs(b - d):
        assert _turns(b, 0.9 * low, d, a)
        assert _turns(d, 0.9 * low, b, a)


def _turns(link: float, frame: float, other: float, coupler: float) -> bool:
    """Whether the loop closes all round, tried degree by degree."""
    span = np.abs(frame - link * np.exp(1j * np.radians(np.arange(0, 360))))
    return bool(np.all((span >= abs(other - coupler)) & (span <= other + coupler)))


@pytest.mark.parametrize(
    ("links", "said"), [((300, 200, 250, 260), "must be the shortest"), ((20, 30, 30, 90), "below")]
)
def test_a_chain_that_cannot_be_is_refused(links: tuple[int, ...], said: str) -> None:
    data = {key: f"{value} mm" for key, value in zip(("AB", "BC", "CD", "AD"), links, strict=True)}
    with pytest.raises(ProblemFileError, match=said):
        posed("grashof", **data)
