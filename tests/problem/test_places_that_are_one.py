"""Places that coincide, and points of the frame that are asked for, are refused in words."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.errors import VecpolyError
from vecpoly.oracle.synthesis.inversion.meetings import beyond

LINKAGE = """id: x
title: x
frame: {{A: [0 mm, 0 mm], D: [{d}, 0 mm]}}
links: {{1: {{AB: 30 mm}}, 2: {two}, 3: {{DC: 60 mm}}}}
"""
DRIVEN = "input: {{link: 1, phi: 50 deg, omega: 1 rad/s ccw}}\nbranch: [C left of BD]\n{asked}\n"


@pytest.mark.parametrize(
    ("d", "two", "asked", "told"),
    [
        ("80 mm", "{BE: 90 mm, C: {along: BE, at: 0 mm}}", "find: [v_C]", "lie in one place"),
        ("0 mm", "{BC: 80 mm}", "method: curvature\nfind: [P_24, lambda_2]", "one place"),
    ],
)
def test_points_in_one_place_are_refused_with_what_to_do(d: str, two: str, asked: str, told: str) -> None:
    with pytest.raises(VecpolyError, match=told):
        vecpoly.solve(vecpoly.loads((LINKAGE + DRIVEN).format(d=d, two=two, asked=asked)))


def test_circles_about_one_point_do_not_meet() -> None:
    assert beyond(1 + 1j, 2.0, 1 + 1j, 2.0, 1) is None


def test_another_link_s_point_taken_on_the_frame_is_refused() -> None:
    text = (LINKAGE + DRIVEN).format(d="80 mm", two="{BC: 80 mm}", asked="find: [a_C0]")
    with pytest.raises(VecpolyError, match="C0 is a point of the frame and rests"):
        vecpoly.solve(vecpoly.loads(text))
