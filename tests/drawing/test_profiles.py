"""Profiles of higher pairs on the frame: a hatched strip that the other link touches from outside."""

from __future__ import annotations

import cmath
from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly.board.paper.marks import Outline
from vecpoly.diagram.profiles import DEEP, profile
from vecpoly.foundation.slotted import dataclass
from vecpoly.mechanism.joints import FRAME

angles = st.floats(-pi, pi)
radii = st.floats(20.0, 200.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch:
    """The frame and link 2 touch in a point; their profiles are round about these centres."""

    at: complex
    about: tuple[complex | None, complex | None]
    normal: complex = 1j
    links: tuple[str, ...] = (FRAME, "2")
    meshes: bool = False


def strip(touch: Touch) -> list[complex]:
    (mark,) = profile(touch, FRAME)
    assert isinstance(mark, Outline) and mark.fixed
    return list(mark.points)


@settings(max_examples=often(20))
@given(turn=angles, radius=radii, hollow=st.booleans(), share=st.floats(0.1, 0.8))
def test_a_round_profile_of_the_frame_is_a_strip_of_one_thickness_away_from_what_touches_it(
    turn: float, radius: float, hollow: bool, share: float
) -> None:
    centre, way = complex(30, -20), cmath.rect(1.0, turn)
    at = centre + radius * way
    points = strip(Touch(at=at, about=(centre, at - way * radius * share if hollow else at + way * radius * share)))
    far = sorted({round(abs(point - centre), 6) for point in points})
    deep = radius + DEEP if hollow else radius - DEEP
    assert far == pytest.approx(sorted((radius, deep)), abs=1e-5)
    assert min(abs(point - at) for point in points) < 1e-9 and max(abs(point - at) for point in points) < 32
    middle = sum(points) / len(points) - centre
    assert abs(cmath.phase(middle / way)) < 1e-6


@given(turn=angles)
def test_a_flat_profile_of_the_frame_lies_behind_its_face(turn: float) -> None:
    normal = cmath.rect(1.0, turn)
    for order, side in (((FRAME, "2"), -1), (("2", FRAME), 1)):
        points = strip(Touch(at=5 + 5j, about=(None, None), normal=normal, links=order))
        depths = [((point - (5 + 5j)) / normal).real * side for point in points]
        assert sorted(depths) == pytest.approx([0, 0, DEEP, DEEP], abs=1e-9)
