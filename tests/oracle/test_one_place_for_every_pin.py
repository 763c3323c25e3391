"""A pin has one place, one velocity and one acceleration, whichever of its links tells it, all over the motion."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from tests.devices.cams_moving import FOLLOWERS
from tests.drawn_library import given, ids
from tests.each import Later, each
from tests.generators.plate_cams import hung_on
from tests.laws import few
from vecpoly import oracle
from vecpoly.mechanism.model import FRAME, Mechanism, Revolute
from vecpoly.oracle.motion import Motion
from vecpoly.problem.load import loads

PLACES = 25
MOTION = "[rise 10 {} in 120 deg cosine, dwell 20 deg, return in 110 deg 3-4-5, dwell 110 deg]"


def gaps(mech: Mechanism) -> Iterator[float]:
    """How far a pin of one link is from itself on the other: places, velocities, accelerations, of their size."""
    drive, of = mech.drive, np.linspace(0.0, 2 * np.pi, PLACES)
    motion = oracle.solve(mech, drive.position + (of if not drive.slide else 0.01 * mech.scale * of), strict=False)
    centres = {cam.centre for cam in mech.cams}  # of curvature: on no link for long
    for joint in mech.joints:
        if isinstance(joint, Revolute) and joint.point not in centres:
            one, other = (_told(motion, mech, link, joint.point) for link in (joint.a, joint.b))
            for mine, theirs in zip(one, other, strict=True):
                size = max(np.nanmax(np.abs(mine), initial=0.0), mech.scale)
                yield float(np.nanmax(np.abs(mine - theirs), initial=0.0)) / size


def _told(motion: Motion, mech: Mechanism, link: str, letter: str) -> tuple[np.ndarray, ...]:
    body = motion.body(link)
    local = mech.frame[letter] if link == FRAME else mech.link(link).points[letter]
    return tuple(
        np.broadcast_to(part, PLACES)
        for part in (body.point(local), body.velocity_of(local), body.acceleration_of(local))
    )


@each(Later(lambda: few(ids(), 3)))
def test_every_pin_of_the_library_is_where_its_links_are(name: str) -> None:
    mech = given(name).subject
    assert isinstance(mech, Mechanism) and max(gaps(mech), default=0.0) < 1e-6


@pytest.mark.parametrize("turns", ["ccw", "cw"])
@pytest.mark.parametrize("follower", [one for one in FOLLOWERS if "face" not in one])
def test_what_hangs_on_the_tip_of_a_follower_stays_on_it(follower: str, turns: str) -> None:
    motion = MOTION.format("deg" if "arm" in follower else "mm")
    mech = loads(hung_on(follower, motion, turns, 70.0 if turns == "ccw" else -70.0)).subject
    assert isinstance(mech, Mechanism) and max(gaps(mech)) < 1e-9
