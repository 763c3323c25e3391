"""Plate cams that move their followers: any follower, law and sense, at any place of the turn."""

from __future__ import annotations

import numpy as np

from tests.devices.cams_moving import FOLLOWERS, LAWS, moved
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

from .family import family


def moved_as_the_law_says(solution: Solution) -> str:
    """What is drawn with the centre of curvature is what the law gives, to rounding."""
    mech = solution.problem.subject
    assert isinstance(mech, Mechanism) and mech.cams
    for key, answer in solution.answers.items():
        if abs(answer.drawn - answer.exact) > 0.25 * abs(answer.exact) + 5 * answer.expected_error + 1e-6:
            return f"{key}: {answer.drawn} drawn, {answer.exact} by the law"
    return ""


@family("plate cam", moved_as_the_law_says, often=3)
def plate_cam(rng: np.random.Generator) -> str:
    """A rise or a return, off its ends, where there is a polygon to draw."""
    follower = str(rng.choice(sorted(FOLLOWERS)))
    by = f"{rng.integers(6, 12)} {'deg' if 'arm' in follower else 'mm'}"
    up, back = (int(rng.integers(100, 130)) for _ in range(2))
    one, two = (str(rng.choice(LAWS)) for _ in range(2))
    turns = str(rng.choice(["ccw", "cw"]))
    motion = f"[rise {by} in {up} deg {one}, dwell 20 deg, return in {back} deg {two}, dwell {340 - up - back} deg]"
    share = float(rng.uniform(0.15, 0.4)) + 0.5 * float(rng.integers(0, 2))
    start, wide = (0, up) if rng.random() < 0.5 else (up + 20, back)
    phi = (1 if turns == "ccw" else -1) * (start + share * wide)
    return moved(follower, motion, turns, round(phi, 3), alpha=0.0).text
