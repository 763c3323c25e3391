"""Class III groups whose legs hang on a moving link, so that no other driver makes class II of them:
their reactions are drawn by moments about a special point; those that another driver makes class II are
taken off from one that moves."""

from __future__ import annotations

import cmath
from math import radians

import pytest

from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.generators.equilibrium import in_equilibrium
from tests.laws import few
from vecpoly.problem.load import load
from vecpoly.solution import solve

CRANK = """
id: x
title: a plate with two legs on the crank
frame: {A: [0 mm, 0 mm], E: [90 mm, -60 mm]}
links:
  1: {AB: 60 mm, G: {along: AB, at: 20 mm, right: 90 mm}}
  2: {CD: 70 mm, H: {along: CD, at: 30 mm, left: 50 mm}}
  3: {BC: 80 mm}
  4: {%s}
  5: {%s}
joints: [%s]
input: {link: 1, phi: 100 deg, omega: 5 rad/s ccw}
guesses: {C: [40 mm, 120 mm], D: [100 mm, 80 mm], H: [100 mm, 30 mm]}
loads:
  Q_2: {on: 2, at: H, size: 400 N, direction: -65 deg}
  Q_4: {on: 4, at: %s, size: 60 N, direction: 30 deg}
  M_3: {on: 3, size: 4 N*m}
  M_5: {on: 5, size: -3 N*m}
  M_1: {on: 1, size: "?"}
"""
BARS = CRANK % ("GD: 75 mm", "EH: 85 mm", "", "D")
SLIDER = CRANK % ("GD: 75 mm", "block: H", "5 slides on line through E at 100 deg", "D")
SLEEVE = CRANK % ("block: G", "EH: 85 mm", "4 slides on CD of 2 with G 5 mm left", "G")
RUBBING = "friction: {A: {rho: 2 mm}, B: {rho: 2 mm}, C: {rho: 2 mm}, %s}\n"
FRICTION = {
    BARS: RUBBING % "D: {rho: 1 mm}, E: {rho: 1 mm}, G: {rho: 1 mm}, H: {rho: 1 mm}",
    SLIDER: RUBBING % "D: {rho: 1 mm}, G: {rho: 1 mm}, H: {rho: 1 mm}, 5-6: {phi: 6 deg}",
    SLEEVE: RUBBING % "E: {rho: 1 mm}, G: {rho: 1 mm}, H: {rho: 1 mm}, 2-4: {phi: 6 deg}",
}
MASSES = "masses: {2: {mass: 2 kg, inertia: 0.002 kg*m^2, centre: H}, 5: {mass: 3 kg, centre: H}}\nweight: yes\n"


@pytest.mark.parametrize("text", few([BARS, SLIDER, SLEEVE], 3))
@pytest.mark.parametrize("rubs", [False, True])
def test_every_reaction_is_drawn_where_two_legs_hang_on_the_crank(text: str, rubs: bool) -> None:
    solution = exact_hand(text + (FRICTION[text] if rubs else ""))
    assert agreeing(solution) == (10 if rubs else 8)  # with M_1 without friction, and η
    assert in_equilibrium(solution) == ""


def test_inertia_forces_and_weights_go_into_the_moments() -> None:
    solution = exact_hand(BARS + MASSES)
    assert agreeing(solution) == 8 and in_equilibrium(solution) == ""
    assert abs(solution.answers["R_25"].exact - exact_hand(BARS).answers["R_25"].exact) > 1.0


def test_about_the_special_point_two_reactions_have_no_moment() -> None:
    """S is where the legs EH and GD meet; ΣM_S leaves R^n_13 alone, as the step says."""
    solution = exact_hand(BARS.replace("  M_5: {on: 5, size: -3 N*m}\n", ""))
    told = [step.words.en for step in solution.construction.steps]
    assert any("$ΣM_S$ = 0 of the whole group gives $R^n_{13}$" in text for text in told)
    forces = solution.as_json()["forces"]
    places = {key: complex(*one["point"]) for key, one in forces.items() if "point" in one}
    ways = {key: solution.answers[key].drawn_vector for key in ("R_56", "R_14")}
    e, g = places["R_56"], places["R_14"]
    u, w = ways["R_56"], ways["R_14"]
    assert u is not None and w is not None
    s = e + u * ((g - e).conjugate() * w).imag / (u.conjugate() * w).imag
    sides = [(places[key] - s, solution.answers[key].drawn_vector) for key in ("R_13",)]
    loads_at = {"Q_2": (places["R_25"], 400, -65), "Q_4": (places["R_24"], 60, 30)}
    turned = sum((arm.conjugate() * force).imag for arm, force in sides if force is not None)
    turned += sum(((at - s).conjugate() * cmath.rect(size, radians(way))).imag for at, size, way in loads_at.values())
    assert turned + 4.0 == pytest.approx(0.0, abs=1e-9)


def test_the_library_s_plate_on_the_crank_needs_no_other_driver() -> None:
    solution = solve(load("plate-on-crank"), by="exact", repeats=0, precise=False)
    assert agreeing(solution) == 9
    assert not any("taken as the driver" in step.words.en for step in solution.construction.steps)


TWO_SLIDES = """
id: x
title: a leg with two slides, and two legs on the crank
frame: {A: [0 mm, 0 mm], F: [150 mm, -40 mm]}
links:
  1: {AB: 40 mm, G: {along: AB, at: 20 mm, right: 60 mm}}
  2: {CD: 60 mm, E: {along: CD, at: 30 mm, left: 40 mm}}
  3: {BC: 70 mm}
  4: {GD: 80 mm}
  5: {block: K}
joints: [5 slides on CE of 2, 5 slides on line through F at 70 deg turned 20 deg]
input: {link: 1, phi: 60 deg, omega: 5 rad/s ccw}
guesses: {C: [60 mm, 90 mm], D: [110 mm, 60 mm], K: [120 mm, 100 mm]}
loads:
  Q: {on: 2, at: D, size: 50 N, direction: 30 deg}
  M_1: {on: 1, size: "?"}
"""


TWO_SLIDES_RUB = "friction: {B: {rho: 2 mm}, D: {rho: 1 mm}, 5-2: {phi: 6 deg}, 5-6: {phi: 8 deg}}\n"
ON_THE_LEG = "  Q_5: {on: 5, at: K, size: 80 N, direction: 50 deg}\n  M_5: {on: 5, size: 2 N*m}\n"


@pytest.mark.parametrize(("loaded", "rubs"), few([(False, False), (False, True), (True, False), (True, True)], 3))
def test_a_leg_with_two_slides_is_solved_by_itself_first(loaded: bool, rubs: bool) -> None:
    """Unloaded it passes on a couple and no force; loaded, the forces of both slides close its own polygon."""
    text = TWO_SLIDES + (ON_THE_LEG if loaded else "") + (TWO_SLIDES_RUB if rubs else "")
    solution = exact_hand(text)
    assert agreeing(solution) == (10 if rubs else 8)
    assert in_equilibrium(solution) == ""
    couple = solution.construction.readings["R_25"].acts
    assert couple is not None and (couple.couple is None) == loaded
    assert any("both slides of link 5" in step.words.en for step in solution.construction.steps) == loaded


def test_the_balancing_moment_alone_needs_no_reaction() -> None:
    assert agreeing(exact_hand(TWO_SLIDES + "find: [M_1, M_1_power, M_1_lever]\n")) == 3


def test_a_polygon_has_letters_for_as_many_loads_as_there_are() -> None:
    many = "".join(f"  F_{n}: {{on: 2, at: H, size: {n} N, direction: {17 * n} deg}}\n" for n in range(20, 45))
    assert agreeing(exact_hand(BARS.replace("  M_3:", many + "  M_3:"))) == 8


STANDS_STILL = """
id: stands-still
title: the rocker FC stands still while GD swings, for C is the instant centre of the plate
frame: {A: [0 mm, 0 mm], F: [60 mm, 40 mm], G: [160 mm, 120 mm]}
links:
  1: {AB: 50 mm, H: {along: AB, at: 90 mm, right: 20 mm}}
  2: {CD: 40 mm, E: {along: CD, at: 20 mm, left: 50 mm}}
  3: {FC: 80 mm}
  4: {GD: 60 mm}
  5: {HE: 100 mm}
input: {link: 1, phi: 90 deg, omega: 5 rad/s ccw}
guesses: {C: [60 mm, 120 mm], D: [100 mm, 120 mm], E: [80 mm, 170 mm]}
loads:
  Q: {on: 2, at: E, size: 400 N, direction: -65 deg}
  X_b: {on: %s, size: "?"}
"""
PINS_RUB = "friction: {A: {rho: 1 mm}, G: {rho: 1 mm}, C: {rho: 1 mm}, E: {rho: 1 mm}}\n"


@pytest.mark.parametrize(("balanced", "more"), [(2, ""), (1, ""), (1, PINS_RUB)])
def test_groups_are_taken_off_from_a_link_that_moves(balanced: int, more: str) -> None:
    """From link 3, the first on the frame, the dyad of 2 and 4 is at a change point: no line of R_32 was found."""
    solution = exact_hand(STANDS_STILL % balanced + more)
    assert solution.answers["R_36"].exact > 100 and agreeing(solution) >= 8
    (said,) = (one.words for one in solution.construction.steps if "link 4 is taken as the driver" in one.words.en)
    assert "from link 1 the mechanism has groups above class II." in said.en and "含有高于 Ⅱ 级的杆组" in said.zh
    assert "Then there are only class II groups, which" in said.en and "全由 Ⅱ 级杆组组成" in said.zh
