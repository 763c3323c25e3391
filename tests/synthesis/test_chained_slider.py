"""A slider on the rocker of a four-bar: each loop may pass through the positions alone, and both together not."""

from __future__ import annotations

from cmath import exp, phase
from math import degrees, radians, sqrt

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


SIX = """
id: t
title: t
synthesis: stages
data:
  frame: {A: [0 mm, 0 mm], D: [106 mm, -57 mm], F: [157 mm, -45 mm]}
  links: {AB: 67 mm, BC: 105 mm, CD: 102 mm}
  rays: {AB: [-78 deg, -53 deg], FE: [3 deg, -23 deg]}
  stages: [{join: C, to: BD, side: right}, {find: E, on: FE, from: C}]
find: [CE, EF]
"""  # C goes out and comes back meanwhile, farther than CE and EF reach


def test_a_rocker_on_a_rocker_that_is_led_beyond_its_reach_between_the_positions_is_no_solution() -> None:
    problem = vecpoly.loads(SIX)
    assert [one.verdict for one in linkages(problem.design)] == [Verdict.BRANCH]
    assert [one.verdict for one in problem.solve(by="exact").construction.candidates] == ["BRANCH"]


@pytest.mark.parametrize("to", ["BD, side: right", "DB, side: left"])
def test_a_pin_joins_a_pin_and_a_pivot_in_either_order(to: str) -> None:
    text = SIX.replace("BD, side: right", to).replace("rays: {AB: [-78 deg, -53 deg]", "rays: {AB: [-78 deg, -70 deg]")
    solution = vecpoly.loads(text).solve(by="exact")
    assert [one.verdict for one in solution.construction.candidates] == ["VALID"]
    assert solution.answers["CE"].exact == pytest.approx(135.9737, abs=1e-4)


@pytest.mark.parametrize("to", ["BE, side: left", "AD, side: left", "AB, side: left"])
def test_a_pin_between_two_pivots_or_no_pivot_of_its_own_is_refused(to: str) -> None:
    with pytest.raises(vecpoly.VecpolyError, match="C must join a fixed pivot and a pin of a link"):
        vecpoly.loads(
            SIX.replace("BD, side: right", to).replace("CD: 102 mm", "CD: 102 mm, FE: 90 mm, CE: 80 mm, CA: 80 mm")
        )


def test_a_rocker_that_turns_back_between_the_positions_may_lead_a_slider() -> None:
    b = [25 * exp(1j * radians(phi)) for phi in (120, 200, 280)]
    c = [met(at, 70, 80, 50) for at in b]
    turns = [degrees(phase(at - 80)) for at in c]
    assert (turns[1] - turns[0]) * (turns[2] - turns[1]) < 0
    places = ", ".join(f'"({at.real + sqrt(120**2 - at.imag**2)!r}, 0) mm"' for at in c)
    text = STAGES.format(
        d="[80 mm, 0 mm]",
        ab="[120 deg, 200 deg, 280 deg]",
        dc=f"[{', '.join(f'{turn!r} deg' for turn in turns)}]",
        e=f"[{places}]",
    )
    problem = vecpoly.loads(text)
    assert [one.verdict for one in linkages(problem.design)] == [Verdict.VALID]
    assert [one.verdict for one in problem.solve(by="exact").construction.candidates] == ["VALID"]


def met(p: complex, r: float, q: complex, s: float) -> complex:
    """To the left of the ray from p to q, at r from p and at s from q."""
    span = abs(q - p)
    along = (r * r - s * s + span * span) / (2 * span)
    return p + (q - p) / span * complex(along, sqrt(r * r - along * along))
