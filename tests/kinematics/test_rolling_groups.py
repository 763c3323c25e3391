"""Groups that the library has not: a hinge between a rolling gear and a slider, or between two rolling gears."""

from __future__ import annotations

import pytest

from tests.generators.judge import Kind, judge
from tests.laws import few
from vecpoly import loads, solve

HEAD = """
id: rolling
title: rolling
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw, alpha: 20 rad/s^2}
find: [p_C, v_C, a_C, omega_2, alpha_2, v_H, a_H2]
"""
WHEEL = "1: {AB: 35 mm, gear: B, radius: 20 mm}, 2: {gear: C, radius: 30 mm}"
SLIDER = f"links: {{{WHEEL}, 3: {{block: C}}}}\nbranch: [C right of B]\n"
GEARS = f"links: {{{WHEEL}, 3: {{gear: C, radius: 45 mm}}}}\nbranch: [C left of BD]\n"
FOUND = {
    "PRG": (f"{SLIDER}joints: [3 slides on y = 25 mm, 2 rolls on 1 at H]\n", {"B": 50}),
    "GRG": (f"{GEARS}joints: [2 rolls on 1 at H, 3 rolls on circle about D of 25 mm at K]\n", {"B": 50, "D": 70}),
    "GRG in a ring": (f"{GEARS}joints: [2 rolls on 1 at H, 3 rolls inside circle about D of 130 mm at K]\n", {"D": 85}),
}


@pytest.mark.parametrize("kind", FOUND)
@pytest.mark.parametrize("turned", few([50, 62], 2))
def test_a_hinge_of_a_rolling_gear_and_what_turns_with_it_is_the_oracle_s(kind: str, turned: int) -> None:
    verdict = judge(HEAD.replace("50 deg", f"{turned} deg") + FOUND[kind][0])
    assert (verdict.kind, verdict.why) == (Kind.RIGHT, "")


@pytest.mark.parametrize("kind", FOUND)
def test_the_distance_of_centres_that_is_swung_is_told_in_millimetres(kind: str) -> None:
    rule, distances = FOUND[kind]
    told = solve(loads(HEAD + rule), by="exact", repeats=0, precise=False).construction.steps[1].words
    for centre, size in distances.items():
        assert f"{size} mm apart: swing that arc about ${centre}$" in told.en
        assert f"{size} mm，以 ${centre}$ 为圆心画弧" in told.zh
