"""Forces between teeth: along the line of action, at the pressure angle, on the flank that works."""

from __future__ import annotations

from math import cos, radians, tan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.at_once import exactly
from tests.laws import few, often
from vecpoly.algebra.formula import plain
from vecpoly.errors import LockedError, ProblemFileError
from vecpoly.solution import Solution, solve

TWO_GEARS = """
id: two-gears
title: two gears
frame: {A: [0 mm, 0 mm], B: [120 mm, 0 mm]}
links:
  1: {gear: A, radius: 40 mm%s}
  2: {gear: B, radius: 80 mm%s}
joints: [2 rolls on 1 at H]
input: {link: 1, phi: 0 deg, omega: 10 rad/s cw}
loads:
  M_2: {on: 2, size: %s}
  M_1: {on: 1, size: "?"}
find: [R_12, R_32, R_31, M_1]
"""


def solved(one: str = "", two: str = "", moment: str = "20 N*m") -> Solution:
    return exactly(vecpoly.loads(TWO_GEARS % (one, two, moment)))


def of_library(problem: str) -> Solution:
    return exactly(vecpoly.load(problem))


def vector(solution: Solution, key: str) -> complex:
    found = solution.answers[key].drawn_vector
    assert found is not None
    return found


def test_teeth_press_along_the_line_of_action_of_the_flank_that_works() -> None:
    """20 N·m ccw on gear 2 needs 250 N upwards at H, 80 mm left of its centre; α presses the gear to the right."""
    assert vector(solved(), "R_12") == pytest.approx(complex(250 * tan(radians(20)), 250), rel=1e-12)
    assert vector(solved(), "R_32") == pytest.approx(-vector(solved(), "R_12"), rel=1e-12)


@settings(max_examples=often(12))
@given(alpha=st.floats(0, 44), moment=st.floats(1, 900), way=st.sampled_from([1, -1]))
def test_gears_are_pressed_apart_whichever_way_they_are_loaded(alpha: float, moment: float, way: int) -> None:
    solution = solved(f", alpha: {alpha!r} deg", "", f"{way * moment!r} N*m")
    tangential = moment / 0.08
    force = complex(tangential * tan(radians(alpha)), way * tangential)
    assert vector(solution, "R_12") == pytest.approx(force, rel=1e-9)
    assert abs(force) == pytest.approx(tangential / cos(radians(alpha)), rel=1e-9)
    assert solution.answers["M_1"].drawn == pytest.approx(way * moment / 2, rel=1e-9)


def test_one_pressure_angle_of_two_gears_is_that_of_both() -> None:
    assert vector(solved(", alpha: 25 deg"), "R_12") == vector(solved("", ", alpha: 25 deg"), "R_12")


@pytest.mark.parametrize(
    ("one", "two", "told"),
    [(", alpha: 14.5 deg", ", alpha: 20 deg", ("14.5°", "20°")), (", alpha: 60 deg", "", ("60 deg", "45°"))],
)
def test_pressure_angles_that_cannot_be_are_refused_with_both_numbers(
    one: str, two: str, told: tuple[str, str]
) -> None:
    with pytest.raises(ProblemFileError) as refused:
        solved(one, two)
    assert all(number in refused.value.words.zh and number in refused.value.words.en for number in told)


def test_a_pressure_angle_of_what_has_no_teeth_is_refused() -> None:
    with pytest.raises(ProblemFileError, match="link 1 is neither gear nor rack"):
        vecpoly.loads(TWO_GEARS.replace("gear: A, radius: 40 mm%s", "AC: 40 mm, alpha: 20 deg%s") % ("", "", "20 N*m"))


def test_the_bearing_of_a_planet_bears_twice_the_tangential_force() -> None:
    """Sun and ring press with F_t each in one sense; what presses the planet inwards and outwards cancels."""
    found = of_library("planetary-reactions")
    tangential = abs(vector(found, "R_12")) * cos(radians(20))
    assert abs(vector(found, "R_32")) == pytest.approx(2 * tangential, rel=1e-9)
    assert abs(vector(found, "R_42")) == pytest.approx(abs(vector(found, "R_12")), rel=1e-9)


def test_loads_through_the_bearing_leave_the_teeth_alone() -> None:
    text = TWO_GEARS % ("", "", "20 N*m")
    found = solve(
        vecpoly.loads(text.replace("M_2: {on: 2, size: 20 N*m}", "Q: {on: 2, at: B, size: 70 N, direction: 40 deg}")),
        by="exact",
        repeats=0,
    )
    assert (vector(found, "R_12"), found.answers["M_1"].drawn) == (0j, 0.0)
    assert abs(vector(found, "R_32")) == pytest.approx(70)


@pytest.mark.parametrize(
    "problem",
    few(
        ["winch-gears", "rack-lift", "planetary-reactions", "plate-reactions", "plate-on-crank", "plate-two-slides"], 2
    ),
)
def test_drawn_forces_of_gears_and_plates_are_those_of_the_oracle(problem: str) -> None:
    for answer in of_library(problem).answers.values():
        assert answer.deviation == pytest.approx(0.0, abs=1e-9 * max(1.0, abs(answer.exact))), answer.key


def test_friction_of_the_bearings_asks_more_of_the_handle() -> None:
    found = of_library("winch-gears").answers
    assert abs(found["M_1"].drawn) > abs(found["M_1_0"].drawn) == pytest.approx(25.0)
    assert found["eta"].drawn == pytest.approx(found["M_1_0"].drawn / found["M_1"].drawn)


IDLE_PIN = """
id: idle-pin
title: a planet whose two teeth bear its couple alone
frame: {A: [0 mm, 0 mm]}
links:
  1: {gear: A, radius: 22 mm}
  2: {gear: C, radius: 38 mm}
  3: {AC: 60 mm, phi: 62 deg}
joints: [2 rolls on 1 at D, 2 of 26 mm rolls inside circle about A of 86 mm at E]
input: {link: 1, phi: 0 deg, omega: 10 rad/s ccw}
loads: {M_2: {on: 2, size: -4 N*m}, M_1: {on: 1, size: "?"}}
friction: {C: {rho: 1.5 mm}}
find: [M_1, R_12, R_23, R_24]
"""


def test_a_pin_with_friction_that_bears_nothing_is_no_lock() -> None:
    """The teeth are on one radius: both press with M / (r + r′), and their radial parts cancel."""
    found = exactly(vecpoly.loads(IDLE_PIN))
    tangential = 4.0 / (0.038 + 0.026)
    assert found.answers["M_1"].drawn == pytest.approx(-tangential * 0.022)
    assert abs(vector(found, "R_12")) == pytest.approx(tangential / cos(radians(20)))
    assert abs(vector(found, "R_23")) == pytest.approx(0.0, abs=1e-9)


# Gear 3 runs idle: the load passes through B. Its bearing has a friction circle larger than its pitch circle.
IDLE_GEAR = """
id: idle-gear
title: an idle gear on a rack
frame: {A: [0 mm, 0 mm], D: [-116 mm, 84 mm]}
links:
  1: {AB: 27 mm}
  2: {rack: {through: B, left: -11 mm}}
  3: {gear: D, radius: 21 mm}
joints: [3 rolls on 2 at C]
input: {link: 1, phi: 207 deg, omega: 4 rad/s cw}
loads:
  F: {on: 2, at: B, size: 744 N, direction: 27 deg}
  M_1: {on: 1, size: "?"}
friction: {A: {rho: 5 mm}, D: {rho: 22 mm}}
find: [M_1, R_12, R_23, R_43]
"""


def test_a_gear_that_passes_on_nothing_is_not_locked_however_large_its_friction_circle() -> None:
    """Where nothing presses nothing rubs: only the crank's own bearing takes its toll, 744 N · 5 mm."""
    solution = exactly(vecpoly.loads(IDLE_GEAR))
    assert solution.answers["M_1"].drawn == pytest.approx(-3.72, rel=1e-9)
    assert [abs(vector(solution, key)) for key in ("R_23", "R_43")] == [0.0, 0.0]
    told = [step.words.en for step in solution.construction.steps if "could pass on no force" in step.words.en]
    assert len(told) == 1 and "along $DC$" in told[0]


def test_a_gear_that_must_turn_against_such_a_bearing_is_locked() -> None:
    with pytest.raises(LockedError, match="friction"):
        solve(
            vecpoly.loads(IDLE_GEAR.replace("  M_1", "  M_2: {on: 2, size: 1 N*m}\n  M_1")),
            by="exact",
            repeats=0,
            precise=False,
        )


FAR_FROM_THE_SHEET = """
id: far-line
title: a gear pair that drives a slide
frame: {A: [0 mm, 0 mm], D: [-100 mm, 0 mm]}
links:
  1: {gear: A, radius: 40 mm, alpha: 14.5 deg}
  2: {gear: D, radius: 60 mm, alpha: 14.5 deg, E: {DE: 45 mm, angle: 50 deg from AD}}
  3: {EF: 150 mm}
  4: {block: F}
joints: [1 rolls on 2 at H, 4 slides on x = -100 mm]
input: {link: 1, phi: 0 deg, omega: 20 rad/s cw}
branch: [F below E]
weight: yes
masses: {4: {mass: 15 kg}}
loads:
  Q: {on: 4, at: F, size: 500 N, direction: 90 deg}
  M_1: {on: 1, size: "?"}
friction: {D: {rho: 5 mm}, A: {rho: 4 mm}, 4-5: {f: 0.1}}
find: [M_1, R_12, R_51]
"""


def test_a_bearing_that_passes_on_a_force_found_by_moments_has_that_force_and_no_length_of_its_own() -> None:
    found = solve(vecpoly.loads(FAR_FROM_THE_SHEET), repeats=0, precise=False)
    lines = [plain(line) for step in found.construction.steps for line in step.formulas]
    assert found.answers["R_51"].drawn == found.answers["R_12"].drawn
    (line,) = (line for line in lines if line.startswith("R_51 = R_12 = "))
    assert line.endswith(f" {found.answers['R_12'].drawn:.1f} N") and not any("—" in line for line in lines)
