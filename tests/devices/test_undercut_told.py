"""That a cam is undercut is no matter of ρ_a alone: a corner of the pitch curve loses the motion too."""

from __future__ import annotations

import vecpoly
from vecpoly.report.values import called

UNIFORM = """
id: t
title: t
device: cam
data:
  follower: {roller: 8 mm}
  r0: 40 mm
  motion: [rise 30 mm in 180 deg uniform, return in 180 deg uniform]
find: [rho_profile, undercut]
"""


def test_a_motion_lost_at_a_corner_is_not_told_as_a_negative_radius() -> None:
    answers = vecpoly.loads(UNIFORM).solve(by="exact").answers
    assert answers["undercut"].drawn == 1.0 and answers["rho_profile"].drawn > 0
    symbol = answers["undercut"].rel.symbol
    for lang, word in (("zh", "运动失真"), ("en", "motion lost")):
        told = called(symbol, "undercut", "zh" if lang == "zh" else "en")
        assert word in told and "< 0" not in told
