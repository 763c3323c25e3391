"""Corners of a cam, where a velocity drops at once, have no radius of curvature: ρ_min says that it leaves them out."""

from __future__ import annotations

from math import degrees, tau

import numpy as np
import pytest

from vecpoly import load, loads
from vecpoly.devices.cams.cam import Cam
from vecpoly.devices.cams.corners import corners_of
from vecpoly.oracle.devices.cams.shape import jumps
from vecpoly.problem.problem import Problem

MOTIONS = (
    "rise 30 mm in 180 deg uniform, return in 180 deg uniform",
    "rise 30 mm in 120 deg uniform, dwell 60 deg, return in 90 deg sine, dwell 90 deg",
    "rise 10 mm in 90 deg uniform, rise 20 mm in 90 deg uniform, return in 180 deg cosine",
    "rise 20 mm in 90 deg uniform, rise 10 mm in 90 deg uniform, return in 180 deg uniform",
    "rise 30 mm in 180 deg sine, return in 180 deg cosine",
)


def cam_of(motion: str, follower: str = "knife: yes", find: str = "[rho_min]") -> Problem:
    data = f"{{follower: {{{follower}}}, r0: 40 mm, motion: [{motion}]}}"
    return loads(f"id: mine\ntitle: mine\ndevice: cam\ndata: {data}\nfind: {find}")


@pytest.mark.parametrize("motion", MOTIONS)
def test_corners_stand_where_the_exact_velocity_drops(motion: str) -> None:
    cam = cam_of(motion).subject
    assert isinstance(cam, Cam)
    drops = [degrees(piece.end % tau or tau) for piece, by in zip(cam.pieces, jumps(cam), strict=True) if by < 0]
    assert np.allclose(corners_of(cam.pieces), drops)


@pytest.mark.parametrize("follower", ["knife: yes", "roller: 5 mm"])
def test_the_least_radius_is_told_to_leave_corners_out(follower: str) -> None:
    (told,) = cam_of(MOTIONS[0], follower).warnings
    assert "φ = 180°" in told.zh and "尖点" in told.zh and "φ = 180°" in told.en and "corner" in told.en
    assert not cam_of(MOTIONS[-1], follower).warnings
    assert not cam_of(MOTIONS[0], follower, find="[alpha_rise]").warnings


def test_the_step_that_finds_the_least_radius_says_corners_apart() -> None:
    steps = [step.words for step in load("cam-heart").solve(by="exact").construction.steps]
    (told,) = [words for words in steps if "Hartmann" in words.en]
    assert "尖点除外" in told.zh and "corners apart" in told.en
    other = [step.words.en for step in load("cam-rocker").solve(by="exact").construction.steps]
    assert any("Hartmann" in words for words in other) and not any("corners apart" in words for words in other)
