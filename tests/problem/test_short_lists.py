"""A list that is too short says how many entries it has and needs; one whose entries are wrong is not called short."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.errors import ProblemFileError

CAM = """
id: cam
title: cam
device: cam
data:
  follower: {roller: 10 mm}
  r0: 50 mm
  motion: MOTION
find: [s0, alpha_max]
"""


def test_a_motion_of_one_phase_is_told_how_many_there_are_and_should_be() -> None:
    with pytest.raises(ProblemFileError, match="2 entries are needed here, there is 1") as refused:
        vecpoly.loads(CAM.replace("MOTION", "[dwell 360 deg]"))
    assert "至少要有 2 项，现有 1 项" in refused.value.words.zh


def test_a_law_that_is_none_is_the_only_fault_of_its_list() -> None:
    with pytest.raises(ProblemFileError) as refused:
        vecpoly.loads(CAM.replace("MOTION", "[rise 30 mm in 120 deg trapezoid, return in 240 deg sine]"))
    assert [fault.said.en.split(";")[0] for fault in refused.value.faults] == ["'trapezoid' is no law of motion"]
