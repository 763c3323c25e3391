"""Gears: phases are data, gears must fit, pitch points have letters of their own;
drawn and exact agree with Willis, arc lengths and differences."""

from __future__ import annotations

import cmath
from math import cos, pi, radians, sin

import numpy as np
import pytest

from tests.at_once import exactly
from tests.generators.judge import Kind, judge
from tests.laws import few
from vecpoly import Problem, load, loads, oracle
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import GearMark, RackMark
from vecpoly.errors import NoMethodError, ProblemFileError
from vecpoly.mechanism.model import Circle, Rolling, Side

MACHINES = (
    "planet-drive",
    "geared-five-bar",
    "hypocycloid-drive",
    "rack-drives-pinion",
    "pinion-drives-rack",
    "crank-rack-pinion",
    "rack-on-a-rocker",
    "planetary-sun-drives",
    "ring-output",
    "travel-doubler",
    "stepped-planet",
)

FIVE_BAR = """
id: five
title: five-bar
frame: {{A: [0 mm, 0 mm], D: [120 mm, 0 mm]}}
links:
  1: {{AB: 35 mm, gear: A, radius: 60 mm}}
  2: {{BC: 120 mm}}
  3: {{EC: 110 mm}}
  4: {{{gear}}}
joints: [4 rolls on 1 at H]
input: {{link: 1, phi: 130 deg, omega: 10 rad/s ccw, alpha: 20 rad/s^2}}
branch: [C left of BE]
find: [v_E, v_C, a_E, a_C, omega_4, alpha_4, p_E]
"""

PLANET = """
id: planet
title: planet
frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: {arm} mm}}, 2: {{gear: B, radius: {radius} mm}}}}
joints: [2 rolls {how} circle about A of {fixed} mm at {letter}]
input: {{link: 1, phi: 50 deg, omega: 10 rad/s ccw, alpha: 30 rad/s^2}}
find: [omega_2, alpha_2]
"""


def refusal(text: str) -> str:
    with pytest.raises(ProblemFileError) as found:
        loads(text)
    return str(found.value)


def planet(arm: float = 60, radius: float = 20, fixed: float = 40, how: str = "on", letter: str = "H") -> str:
    return PLANET.format(arm=arm, radius=radius, fixed=fixed, how=how, letter=letter)


def exact(problem: Problem, key: str) -> complex:
    answer = exactly(problem).answers[key]
    drawn = answer.drawn if answer.drawn_vector is None else answer.drawn_vector
    truth = answer.exact if answer.exact_vector is None else answer.exact_vector
    assert drawn == pytest.approx(truth, rel=1e-9, abs=1e-9)
    return complex(truth)


@pytest.mark.parametrize("name", few(MACHINES, 4))
def test_the_library_s_machines_with_gears_are_right(name: str) -> None:
    verdict = judge(load(name).text)
    assert (verdict.kind, verdict.why) == (Kind.RIGHT, "")


def test_the_phase_of_a_crank_pin_is_where_the_file_puts_it() -> None:
    for form in (
        "gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg}",
        "DE: 40 mm, gear: D, radius: 60 mm, phi: 75 deg",
        "gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg from AD}",
        "gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 255 deg from DA}",
        "gear: D, radius: 60 mm, F: {DF: 10 mm, angle: 30 deg}, E: {DE: 40 mm, angle: 45 deg from DF}",
    ):
        assert exact(loads(FIVE_BAR.format(gear=form)), "p_E") == pytest.approx(
            0.12 + cmath.rect(0.04, radians(75)), abs=1e-12
        )


def test_the_phase_may_count_from_a_moving_line() -> None:
    form = "gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 10 deg from AB}"
    assert exact(loads(FIVE_BAR.format(gear=form)), "p_E") == pytest.approx(
        0.12 + cmath.rect(0.04, radians(140)), abs=1e-12
    )


def test_another_phase_gives_other_velocities() -> None:
    one, two = (
        exact(loads(FIVE_BAR.format(gear=f"DE: 40 mm, gear: D, radius: 60 mm, phi: {phi} deg")), "v_C")
        for phi in (75, 85)
    )
    assert abs(one - two) > 0.01


def test_a_missing_phase_is_refused_with_both_ways_to_write_it() -> None:
    text = refusal(FIVE_BAR.format(gear="DE: 40 mm, gear: D, radius: 60 mm"))
    assert "links.4" in text and "phi: 40 deg" in text and "E: {DE: 30 mm, angle: 40 deg}" in text


def test_guesses_are_no_phase() -> None:
    assert "phase of gear 4" in refusal(
        FIVE_BAR.format(gear="DE: 40 mm, gear: D, radius: 60 mm") + "guesses: {E: [130 mm, 40 mm]}\n"
    )


@pytest.mark.parametrize(
    ("gear", "said"),
    [
        ("gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg}, phi: 75 deg", "angle of a point already tells"),
        (
            "gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg}, F: {DF: 40 mm, angle: 75 deg from AD}",
            "count from two lines",
        ),
        ("DE: 40 mm, gear: D, radius: 60 mm, phi: 75 deg, s: 3 mm", "not both"),
        ("gear: D, radius: 60 mm, phi: 75 deg", "no point but D"),
        ("gear: D, radius: 60 mm, E: {AE: 40 mm, angle: 75 deg}", "from the gear's centre"),
        ("gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg from AX}", "'X' does not exist"),
        ("DE: 40 mm, gear: D, radius: 60 mm, s: 75 mm", "phi, and not s"),
    ],
)
def test_contradictory_data_of_a_gear_are_refused(gear: str, said: str) -> None:
    assert said in refusal(FIVE_BAR.format(gear=gear))


def test_a_place_that_the_joints_tell_is_not_told_again() -> None:
    four_bar = (
        FIVE_BAR.format(gear="DE: 40 mm")
        .replace("joints: [4 rolls on 1 at H]\n", "")
        .replace("  4: {DE: 40 mm}\n", "")
        .replace("{EC: 110 mm}", "{DC: 110 mm, phi: 60 deg}")
    )
    assert "the joints already tell where link 3 stands" in refusal(
        four_bar.replace("C left of BE", "C left of BD").replace("v_E, v_C, a_E, a_C, omega_4, alpha_4, p_E", "v_C")
    )


def test_the_input_gear_s_own_angle_must_agree_with_the_input() -> None:
    text = planet().replace("1: {AB: 60 mm}", "1: {gear: A, radius: 40 mm, B: {AB: 60 mm, angle: ANGLE deg}}")
    assert exact(loads(text.replace("ANGLE", "50")), "omega_2") == pytest.approx(30)
    assert "link 1 is the input" in refusal(text.replace("ANGLE", "60"))


def test_a_fixed_sun_may_have_a_letter_of_its_own_at_the_arm_s_pivot() -> None:
    text = planet().replace("{A: [0 mm, 0 mm]}", "{A: [0 mm, 0 mm], O: [0 mm, 0 mm]}").replace("about A", "about O")
    assert exact(loads(text), "omega_2") == pytest.approx(30)


@pytest.mark.parametrize(
    ("arm", "radius", "fixed", "how", "ratio"),
    [(60, 20, 40, "on", 3), (58, 32, 90, "inside", 1 - 90 / 32), (50, 50, 100, "inside", -1)],
)
def test_a_planet_obeys_willis(arm: float, radius: float, fixed: float, how: str, ratio: float) -> None:
    """(ω_2 - ω_1) / (0 - ω_1) = ∓ r_fixed / r_2."""
    problem = loads(planet(arm, radius, fixed, how))
    assert exact(problem, "omega_2") == pytest.approx(10 * ratio)
    assert exact(problem, "alpha_2") == pytest.approx(30 * ratio)


def test_a_driven_arm_obeys_willis() -> None:
    """ω_arm = ω_sun r_sun / (r_sun + r_ring)."""
    problem = load("planetary-sun-drives")
    assert exact(problem, "omega_3") == pytest.approx(20 * 40 / (40 + 90))
    assert exact(problem, "alpha_3") == pytest.approx(60 * 40 / (40 + 90))


def test_a_stepped_planet_obeys_willis() -> None:
    """i^H = -(r_2 r_ring) / (r_1 r_2'), ω_arm = ω_1 / (1 - i^H)."""
    problem = load("stepped-planet")
    assert exact(problem, "omega_3") == pytest.approx(20 / (1 + 25 * 80 / (40 * 15)))
    assert [datum.text for datum in problem.given.lengths if datum.symbol.startswith("r_2")] == ["25 mm", "15 mm"]
    assert "two pitch circles at most" in refusal(
        problem.text.replace("2 rolls on 1 at H", "2 of 25 mm rolls on 1 at H")
    )


def test_the_cardan_point_runs_along_a_diameter() -> None:
    problem = load("hypocycloid-drive")
    assert exact(problem, "v_P") == pytest.approx(-0.1 * 10 * sin(radians(40)), abs=1e-12)
    assert exact(problem, "a_P") == pytest.approx(-0.1 * 100 * cos(radians(40)), abs=1e-12)
    path = oracle.solve(problem.mechanism, np.linspace(0, 2 * pi, 37)).position("P")
    assert abs(path.imag).max() < 1e-12


def test_the_upper_rack_of_a_travel_doubler_goes_twice_as_fast() -> None:
    problem = load("travel-doubler")
    assert exact(problem, "v_E") == pytest.approx(2 * exact(problem, "v_C")) and exact(problem, "a_E") == pytest.approx(
        2 * exact(problem, "a_C")
    )


def test_arc_lengths_on_pinion_and_rack_are_equal() -> None:
    """Pure rolling: the pinion's turn times r is the rack's travel."""
    mech = load("rack-drives-pinion").mechanism
    motion = oracle.solve(mech, np.linspace(radians(60), radians(300), 25))
    assert (motion.angle("4") - motion.angle("4")[0]) * 0.04 == pytest.approx(
        (motion.position("C") - motion.position("C")[0]).real, abs=1e-12
    )


def test_the_accelerations_at_a_pitch_point_differ_along_the_line_of_centres() -> None:
    """a_H2H1 = (ω_2 - ω_1)² r_1 r_2 / (r_1 + r_2), towards the centre of gear 2."""
    text = load("planetary-sun-drives").text.replace("find: [v_B,", "find: [a_H2, a_H1, a_H2H1, a_K2, v_B,")
    answers = exactly(loads(text)).answers
    w2, w1 = (answers[f"omega_{n}"].exact if n == "2" else 20.0 for n in "21")
    size = (w2 - w1) ** 2 * 0.04 * 0.025 / 0.065
    towards = cmath.rect(1, radians(50))
    assert answers["a_H2H1"].exact_vector == pytest.approx(size * towards, rel=1e-9)
    for key in ("a_H2", "a_H1", "a_H2H1", "a_K2"):
        assert answers[key].drawn_vector == pytest.approx(answers[key].exact_vector, rel=1e-9), key


def test_the_acceleration_of_a_pitch_point_is_that_of_a_link() -> None:
    text = load("planet-drive").text
    assert "different accelerations" in refusal(text.replace("find: [v_B,", "find: [a_H, v_B,"))
    assert exact(loads(text.replace("find: [v_B,", "find: [a_H2, v_B,")), "a_H2") == pytest.approx(
        cmath.rect(30**2 * 0.02 * 0.04 / 0.06, radians(50))
    )


def test_an_arm_is_moved_through_a_planet_s_crank_pin() -> None:
    """One group of rod, planet and arm: the planet's angle is a datum, the arm's follows;
    the other way round as well."""
    text = """
id: through-planet
title: through the planet
frame: {A: [0 mm, 0 mm], D: [150 mm, 0 mm]}
links: {1: {DQ: 20 mm}, 2: {QE: 130 mm}, 3: {gear: B, radius: 20 mm, E: {BE: 14 mm, angle: 100 deg}}, 4: {AB: 60 mm}}
joints: [3 rolls on circle about A of 40 mm at H]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
branch: [E left of DA]
find: [v_E, a_E, v_B, a_B, omega_2, omega_3, omega_4, alpha_2, alpha_3, alpha_4]
"""
    for form in (text, text.replace("100 deg", "100 deg from AB"), text.replace("E left of DA", "E right of DA")):
        verdict = judge(form)
        assert (verdict.kind, verdict.why) == (Kind.RIGHT, "")


@pytest.mark.parametrize(
    ("letter", "said"),
    [("A", "A is already a pin; give the pitch point a letter of its own"), ("B", "B is already a pin")],
)
def test_a_pitch_point_has_a_letter_of_its_own(letter: str, said: str) -> None:
    assert said in refusal(planet(letter=letter))


def test_two_pitch_points_have_two_letters() -> None:
    text = load("planetary-sun-drives").text.replace("at K", "at H")
    assert "H already is another pitch point" in refusal(text)


def test_the_pitch_point_of_3_3_may_not_be_its_pin() -> None:
    assert "C is already a pin" in refusal(load("3-3").text.replace("3 rolls on 2 at F", "3 rolls on 2 at C"))


def test_a_planet_that_does_not_fit_its_ring_is_refused_with_both_numbers() -> None:
    text = refusal(planet(174, 32, 90, "inside"))
    assert "90 − 32 = 58 mm" in text and "174 mm" in text and "joints[0]" in text


def test_gears_that_do_not_fit_on_moving_arms_are_refused() -> None:
    text = load("3-3").text.replace("5: {CD: 150 mm}", "5: {CD: 151 mm}")
    assert "100 + 50 = 150 mm" in refusal(text) and "151 mm" in refusal(text)


def test_a_pinion_held_too_high_above_its_rack_is_refused() -> None:
    text = refusal(load("rack-drives-pinion").text.replace("D: [170 mm, 40 mm]", "D: [170 mm, 45 mm]"))
    assert "40 mm" in text and "45 mm" in text


def test_a_gear_does_not_roll_inside_a_smaller_one() -> None:
    assert "gear 2 of radius 90 mm cannot roll inside a ring of radius 40 mm" in refusal(planet(50, 90, 40, "inside"))
    assert "write '2 rolls inside 3'" in refusal(
        load("ring-output").text.replace("2 rolls inside 3", "3 rolls inside 2")
    )


def test_rounded_centres_give_working_pitch_circles_of_the_same_ratio() -> None:
    problem = loads(
        FIVE_BAR.format(gear="gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg}").replace(
            "[120 mm, 0 mm]", "[103.92 mm, 60 mm]"
        )
    )
    joint = next(j for j in problem.mechanism.joints if isinstance(j, Rolling))
    assert isinstance(joint.on, Circle)
    assert joint.gear.radius + joint.on.radius == pytest.approx(
        abs(103.92e-3 + 60e-3j), rel=1e-12
    ) and joint.gear.radius == pytest.approx(joint.on.radius)
    assert exact(problem, "omega_4") == pytest.approx(-10)


def test_a_rack_takes_the_side_on_which_the_pinion_is_held() -> None:
    text = load("rack-drives-pinion").text.replace("D: [170 mm, 40 mm]", "D: [170 mm, -40 mm]")
    joint = next(j for j in loads(text).mechanism.joints if isinstance(j, Rolling))
    assert joint.side is Side.RIGHT
    above, below = (exact(load("rack-drives-pinion"), "omega_4"), exact(loads(text), "omega_4"))
    assert above == pytest.approx(-below)
    assert "-40 mm" in refusal(text.replace("4 rolls on 3", "4 rolls above 3"))


@pytest.mark.parametrize(
    "form",
    [
        "3 rolls below y = 60 mm at D",
        "3 rolls on y = 60 mm below at D",
        "3 rolls on y = 60 mm at D below",
        "3 rolls on y = 60 mm at D, below",
    ],
)
def test_the_side_of_a_rack_may_be_said_before_or_after_it(form: str) -> None:
    text = (
        load("3-13")
        .text.split("find:")[0]
        .replace("3 rolls on y = 0 mm at D, 4 rolls on 3 at H", f'"{form}"')
        .replace("  4: {gear: E, radius: 30 mm}\n  5: {CE: 90 mm}\n  6: {EF: 85 mm}\n", "")
    )
    joint = next(
        j for j in loads(text.replace(", E left of CF", "") + "find: [v_C]").mechanism.joints if isinstance(j, Rolling)
    )
    assert joint.side is Side.RIGHT and joint.point == "D"


@pytest.mark.parametrize(
    ("form", "said"),
    [
        ("3 rolls below y = 60 mm above at D", "says both above and below"),
        ("3 rolls above x = 60 mm at D", "is upright"),
        ("3 rolls inside y = 0 mm at D", "not inside it"),
        ("3 rolls left of 4 at D", "'on' or 'inside'"),
        ("3 rolls on 3 at D", "cannot roll on itself"),
        ("3 rolls on 4", "is no rolling pair"),
    ],
)
def test_sentences_that_say_too_much_are_refused(form: str, said: str) -> None:
    assert said in refusal(load("3-13").text.replace("3 rolls on y = 0 mm at D", form))


def test_a_driven_rack_is_told_where_it_stands() -> None:
    text = load("pinion-drives-rack").text
    assert "nothing tells where rack 2 stands" in refusal(text.replace(", s: 40 mm", ""))
    assert "write s" in refusal(
        text.replace("{block: P, rack: P, s: 40 mm}", "{block: P, rack: P, Q: {along: P, at: 20 mm}, phi: 40 deg}")
    )


def test_a_driven_arm_is_told_where_it_stands() -> None:
    assert "the direction of link 3 is not told" in refusal(
        load("planetary-sun-drives").text.replace(", phi: 50 deg}", "}")
    )


def test_refusals_are_told_in_chinese_too() -> None:
    with pytest.raises(ProblemFileError) as found:
        loads(FIVE_BAR.format(gear="DE: 40 mm, gear: D, radius: 60 mm"))
    assert "相位" in found.value.words.of("zh")


def test_eccentric_gears_in_one_group_are_refused_with_the_way_out() -> None:
    text = """
id: eccentric
title: eccentric
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm]}
links: {1: {AB: 20 mm}, 2: {gear: E, radius: 30 mm, B: {EB: 5 mm, angle: 90 deg}}, 3: {gear: D, radius: 40 mm}}
joints: [3 rolls on 2 at H]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
guesses: {E: [30 mm, 5 mm]}
find: [omega_3]
"""
    with pytest.raises((NoMethodError, ProblemFileError)):
        loads(text).solve()


@pytest.mark.parametrize("name", few(MACHINES, 4))
def test_every_pitch_circle_is_drawn_once_and_touches_at_its_pitch_point(name: str) -> None:
    solution = load(name).solve(by="exact")
    marks = next(f for f in solution.construction.figures if f.view is View.MECHANISM).marks
    circles = [
        (round(m.centre.real, 6), round(m.centre.imag, 6), round(m.radius, 6)) for m in marks if isinstance(m, GearMark)
    ]
    joints = [j for j in solution.problem.mechanism.joints if isinstance(j, Rolling)]
    wheels = {
        (circle.link, circle.centre, circle.radius)
        for joint in joints
        for circle in (joint.gear, joint.on)
        if isinstance(circle, Circle)
    }
    assert len(circles) == len(set(circles)) == len(wheels)
    assert sum(isinstance(m, RackMark) for m in marks) == sum(not isinstance(joint.on, Circle) for joint in joints)
