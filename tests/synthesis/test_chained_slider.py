"""A slider on the rocker of a four-bar: each loop may pass through the positions alone, and both together not."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.designs.verdict import Verdict
from vecpoly.oracle.synthesis.registry import linkages

STAGES = """
id: t
title: t
synthesis: stages
data:
  frame: {{A: [0 mm, 0 mm], D: {d}}}
  rays: {{AB: {ab}, DC: {dc}}}
  points: {{E: {e}}}
  stages: [{{find: C, on: DC, from: E}}, {{find: B, on: AB, from: C}}]
find: [DC, CE, AB, BC]
"""
STOPPED = [
    ("[140 mm, -11 mm]", "[-158 deg, -116 deg]", "[-42 deg, -134 deg]", '["(148, 39) mm", "(96, 46) mm"]'),
    ("[62 mm, 30 mm]", "[168 deg, -87 deg]", "[17 deg, -89 deg]", '["(107, 25) mm", "(60, -44) mm"]'),
    ("[134 mm, 13 mm]", "[-16 deg, 23 deg]", "[160 deg, -104 deg]", '["(167, -50) mm", "(124, 17) mm"]'),
]


@pytest.mark.parametrize(("d", "ab", "dc", "e"), STOPPED)
def test_a_rocker_that_leads_its_slider_beyond_its_reach_on_every_way_is_no_solution(
    d: str, ab: str, dc: str, e: str
) -> None:
    problem = vecpoly.loads(STAGES.format(d=d, ab=ab, dc=dc, e=e))
    [exact] = linkages(problem.design)
    [drawn] = problem.solve(by="exact").construction.candidates
    assert exact.verdict is Verdict.BRANCH and drawn.verdict == "BRANCH"


def test_one_that_stays_within_it_is() -> None:
    text = STAGES.format(
        d="[45 mm, 21 mm]", ab="[94 deg, -10 deg]", dc="[128 deg, 66 deg]", e='["(221, 37) mm", "(214, 4) mm"]'
    )
    problem = vecpoly.loads(text)
    assert [one.verdict for one in linkages(problem.design)] == [Verdict.VALID]
    assert [one.verdict for one in problem.solve(by="drafting").construction.candidates] == ["VALID"]
