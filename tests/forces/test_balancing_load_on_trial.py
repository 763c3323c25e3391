"""With friction the balancing load may act on any link: its size is put on trial until the last link is in balance."""

from __future__ import annotations

import re

import pytest

import vecpoly
from tests.at_once import exactly
from vecpoly.algebra.formula import plain
from vecpoly.mechanism.asked.forces import without_friction
from vecpoly.names import reaction
from vecpoly.solution import Solution

FOUR_BAR = """
id: on-the-coupler
title: a balancing moment on the coupler
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {BC: 180 mm}, 3: {DC: 120 mm}}
input: {link: 1, phi: 70 deg, omega: 8 rad/s ccw}
branch: [C above AD]
loads:
  M_1: {on: 1, size: 20 N*m}
  M_3: {on: 3, size: -12 N*m}
  %s
friction: {A: {rho: 2 mm}, B: {rho: 3 mm}, C: {rho: 2.5 mm}, D: {rho: 2 mm}}
find: [X_b, X_b_0, X_b_power, R_12, R_23, R_34, R_14]
"""


def solved(load: str) -> Solution:
    return exactly(vecpoly.loads(FOUR_BAR % load))


@pytest.mark.parametrize(
    "load", ['X_b: {on: 2, size: "?"}', 'X_b: {on: 2, at: C, size: "?", direction: 160 deg}'], ids=["moment", "force"]
)
def test_a_load_on_the_coupler_balances_against_friction_as_the_oracle_says(load: str) -> None:
    found = solved(load).answers
    assert found["X_b"].drawn != pytest.approx(found["X_b_0"].drawn, rel=1e-3)
    for answer in found.values():
        assert answer.deviation == pytest.approx(0.0, abs=1e-8 * max(1.0, abs(answer.exact))), answer.key


def test_the_step_says_that_the_size_is_found_by_trial() -> None:
    steps = solved('X_b: {on: 2, size: "?"}').construction.steps
    told = [step.words for step in steps if "用试算法" in step.words.zh]
    assert len(told) == 1 and "by trial" in told[0].en


def test_what_is_found_without_friction_bears_a_0_until_it_is_found_with_friction() -> None:
    """The moment about a pin had X_b, which was to be found yet."""
    steps = solved('X_b: {on: 2, size: "?"}').construction.steps
    (trial,) = [n for n, step in enumerate(steps) if "two trials" in step.words.en]
    before, after = (
        [plain(one) for step in part for one in step.formulas if "X_b" in plain(one)]
        for part in (steps[:trial], steps[trial:])
    )
    assert before and after and not any(re.search(r"X_b(?!0)", one) for one in before)
    assert not any("X_b0" in one for one in after if "η" not in one)


@pytest.mark.parametrize("sense", ["20", "-20"])
@pytest.mark.parametrize("at", ["", ", at: C, direction: 160 deg"], ids=["moment", "force"])
def test_the_trial_tells_a_size_and_its_way(at: str, sense: str) -> None:
    """It had a minus, and the lines that go on with it had none."""
    text = (FOUR_BAR % f'X_b: {{on: 2, size: "?"{at}}}').replace(
        "M_1: {on: 1, size: 20", f"M_1: {{on: 1, size: {sense}"
    )
    (said,) = [
        step.words.en for step in exactly(vecpoly.loads(text)).construction.steps if "two trials" in step.words.en
    ]
    value = exactly(vecpoly.loads(text)).answers["X_b"].exact
    way = ("against the direction given" in said) if at else ("counter-clockwise" not in said)
    assert "= −" not in said and way is (value < 0)


def test_reactions_of_links_with_two_digits_are_told_apart() -> None:
    """R_111 was the force of 1 on 11 and of 11 on 1."""
    names = [reaction(by, on) for by, on in (("1", "11"), ("11", "1"), ("1", "2"))]
    assert [name.key for name in names] == ["R_1_11", "R_11_1", "R_12"]
    assert [without_friction(name).symbol for name in names] == ["R_{1,11,0}", "R_{11,1,0}", "R_{12,0}"]


TURNS_ROUND = """
id: turns-round
title: a balancing moment on a link of which friction turns the couple round
frame: {A: [0 mm, 0 mm], C: [64 mm, 73 mm], E: [-37 mm, 112 mm]}
links:
  1: {AB: 48 mm}
  2: {BD: 115 mm}
  3: {CD: 90 mm}
  4: {DF: 53 mm}
  5: {EF: 134 mm}
  6: {FG: 133 mm}
  7: {BG: 113 mm}
branch: [D right of BC, F right of DE, G left of FB]
input: {link: 1, phi: 114 deg, omega: 10 rad/s ccw}
loads:
  M_6: {on: 6, size: -39 N*m}
  F_1: {on: 2, at: B, size: 896 N, direction: 115 deg}
  X_b: {on: 6, size: "?"}
friction:
  {A: {rho: 1 mm}, C: {rho: 0.4 mm}, E: {rho: 1.5 mm}, B: {rho: 0.6 mm}, D: {rho: 0.3 mm}, F: {rho: 1.3 mm}}
find: [X_b, X_b_0, R_56, R_67]
"""


def test_a_couple_that_turns_round_while_its_size_is_on_trial_is_not_locked() -> None:
    """Without friction X_b leaves the couple M_6 the upper hand on link 6, with it the friction has it."""
    found = exactly(vecpoly.loads(TURNS_ROUND)).answers
    assert found["X_b_0"].exact < 39.0 < found["X_b"].exact
    for answer in found.values():
        assert answer.deviation == pytest.approx(0.0, abs=1e-8 * max(1.0, abs(answer.exact))), answer.key


LEG_OF_TWO_SLIDES = """
id: leg-of-two-slides
title: the load on the central link is parallel to a leg's force where the leg with two slides bears nothing
frame: {A: [0 mm, 0 mm], F: [139 mm, 10 mm], J: [103 mm, 224 mm], K: [68 mm, 121 mm]}
links:
  1: {AB: 46 mm, M: {along: AB, at: 145 mm, left: 138 mm}, N: {along: AB, at: 7 mm, left: 36 mm}}
  2:
    CD: 31 mm
    G: {along: CD, at: 85 mm, left: 2 mm}
    H: {along: CD, at: 31 mm, left: -105 mm}
    I: {along: CD, at: -43 mm, left: -8 mm}
    L: {along: CD, at: 18 mm, left: -86 mm}
  3: {block: E}
  4: {block: I}
  5: {block: L}
joints:
  ["3 slides on line through F at 85 deg", "3 slides on GH of 2 turned -126 deg", "4 slides on JK", "5 slides on MN"]
input: {link: 1, phi: 344 deg, omega: 3 rad/s ccw}
guesses: {C: [122 mm, 144 mm], D: [148 mm, 128 mm], G: [195 mm, 101 mm], H: [93 mm, 39 mm], I: [81 mm, 159 mm],
  L: [92 mm, 61 mm], E: [144 mm, 70 mm]}
loads:
  F_q: {on: 2, at: D, size: 262 N, direction: -54 deg}
  X_b: {on: 1, size: "?"}
friction: {A: {rho: 0.13 mm}, L: {rho: 0.19 mm}, 3-2: {phi: 5 deg}}
find: [X_b, X_b_0, R_25, R_24, R_23, R_63]
"""


def test_a_load_on_trial_is_not_settled_where_two_lines_are_nearly_parallel() -> None:
    """Within a millionth the guide was said to bear nothing, and the trial ended 1e-9 from equilibrium."""
    found = exactly(vecpoly.loads(LEG_OF_TWO_SLIDES)).answers
    assert found["R_23"].exact == pytest.approx(0.0, abs=1e-9) and found["R_24"].exact > 10
    for answer in found.values():
        assert answer.deviation == pytest.approx(0.0, abs=1e-11 * max(1.0, abs(answer.exact))), answer.key
