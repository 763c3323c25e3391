"""Drives between two moving links, pins in two slots, rollers as links: claims about what is read, drawn and said."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.at_once import exactly
from tests.laws import few
from vecpoly import load, loads, oracle
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Vector
from vecpoly.errors import AssemblyError, ProblemFileError
from vecpoly.mechanism.groups.assur import decompose
from vecpoly.mechanism.groups.mobility import mobility
from vecpoly.mechanism.model import Prismatic
from vecpoly.methods.exchange import exchange, trial
from vecpoly.methods.registry import Stage
from vecpoly.report.statement.structure import welded
from vecpoly.solution import Solution, solve

CYLINDERS = ("excavator-boom", "tipper", "lift-gate", "scissor-lift", "dump-hoist")
BOOM = """
id: boom
title: boom
frame: {A: [0 mm, 0 mm], D: [450 mm, -350 mm]}
links:
  1: {AC: 1150 mm, E: {along: AC, at: 2600 mm}}
  2: {cylinder: D}
  3: {piston: C}
joints: [3 slides in 2]
input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s}
branch: [C left of AD]
find: [omega_1, v_E, a_E, v_C3C2]
"""


def changed(old: str, new: str, text: str = BOOM) -> str:
    assert old in text
    return text.replace(old, new)


@pytest.mark.parametrize("name", few(CYLINDERS, 2))
def test_a_cylinder_has_one_degree_of_freedom_and_is_drawn_as_it_is_computed(name: str) -> None:
    problem = load(name)
    assert mobility(problem.mechanism).freedom == 1
    answers = exactly(problem).answers.values()
    assert answers and all(abs(one.deviation) < 1e-9 for one in answers if one.deviation is not None)


@pytest.mark.parametrize("name", CYLINDERS)
def test_the_relative_velocity_along_the_cylinder_is_the_one_given(name: str) -> None:
    drive = load(name).mechanism.drive
    motion = oracle.solve(load(name).mechanism)
    pair = next(
        joint
        for joint in motion.mech.joints
        if isinstance(joint, Prismatic) and {joint.guide, joint.block} == drive.pair
    )
    speeds = [motion.velocity(f"{pair.pin}{link}") for link in (pair.block, pair.guide)]
    assert abs(complex(speeds[0] - speeds[1])) == pytest.approx(abs(drive.rate), rel=1e-12)


def test_the_cylinder_counts_as_a_bar_of_its_length() -> None:
    (group,) = decompose(loads(BOOM).mechanism)
    assert (group.kind, group.links, group.ram is not None) == ("cylinder RR", ("1", "2", "3"), True)


def test_the_boom_stands_where_the_cosine_rule_puts_it() -> None:
    motion = oracle.solve(loads(BOOM).mechanism)
    base, reach, length = abs(450 - 350j), 1150.0, 900.0
    at_a = np.arccos((base**2 + reach**2 - length**2) / (2 * base * reach)) + np.angle(450 - 350j)
    assert float(motion.angle("1")) == pytest.approx(at_a, abs=1e-12)


def test_the_cylinder_turned_end_for_end_moves_the_boom_alike() -> None:
    turned = changed(
        "3 slides in 2",
        "2 slides in 3",
        changed("2: {cylinder: D}", "2: {piston: D}", changed("3: {piston: C}", "3: {cylinder: C}")),
    )
    one, other = (exactly(loads(text)).answers for text in (BOOM, turned))
    assert one["a_E"].drawn_vector == pytest.approx(other["a_E"].drawn_vector, rel=1e-9)


def test_where_no_dyad_holds_the_cylinder_another_link_is_thought_to_drive_and_said_so() -> None:
    steps = solve(load("scissor-lift")).construction.steps
    assert "假想原动件" in steps[0].words.zh and "let link 1 drive instead" in steps[0].words.en
    assert any("proportional to $ω_1$" in step.words.en for step in steps)


def test_both_polygons_of_a_cylinder_have_their_table() -> None:
    solution = solve(load("excavator-boom"))
    tables = [step for step in solution.construction.steps if step.equation is not None]
    assert len(tables) == 2


def test_a_slide_on_a_moving_link_alone_is_told_of_the_cylinder() -> None:
    with pytest.raises(ProblemFileError, match=r"cylinder: 2-3"):
        loads(changed("{cylinder: 2-3, length: 900 mm, v: 0.12 m/s}", "{link: 3, s: 900 mm, v: 0.12 m/s}"))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("length: 900 mm, ", "", "length between its pins"),
        ("length: 900 mm", "length: -900 mm", "greater than zero"),
        ("cylinder: 2-3", "cylinder: 2-9", "does not exist"),
        ("cylinder: 2-3", "cylinder: 1-2", "do not slide"),
        ("cylinder: 2-3,", "cylinder: 2-3, omega: 2 rad/s,", "not phi, omega"),
        ("{piston: C}", "{block: C}", "piston slides in a cylinder"),
    ],
)
def test_an_incomplete_cylinder_is_refused_in_both_languages(old: str, new: str, told: str) -> None:
    with pytest.raises(ProblemFileError, match=told):
        loads(changed(old, new))


def test_a_length_out_of_reach_is_refused_with_the_range() -> None:
    with pytest.raises(AssemblyError, match=r"579\.91\.\.1720\.09 mm|within"):
        solve(loads(changed("length: 900 mm", "length: 3 m")))


MOTOR = """
id: motor
title: motor
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 100 mm}, 3: {CD: 80 mm}}
input: {link: 3, on: 2, phi: 100 deg, omega: 10 rad/s ccw}
branch: [B above AD]
find: [omega_1, omega_3]
"""


@pytest.mark.parametrize("phi", few(["100 deg", "-100 deg"], 2))
def test_the_angle_of_a_motor_says_to_which_side_its_links_bend(phi: str) -> None:
    side, other = ("left", "right") if phi == "100 deg" else ("right", "left")
    text = MOTOR.replace("100 deg", phi)
    bent, said = (
        solve(loads(one), by="exact", repeats=0)
        for one in (text, text.replace("B above AD", f"B above AD, C {side} of BD"))
    )
    for key, one in bent.answers.items():
        assert one.drawn == pytest.approx(one.exact, rel=1e-9) == pytest.approx(said.answers[key].drawn, rel=1e-9)
    assert any("decides nothing" in words.en for words in said.warnings) and bent.warnings == ()
    with pytest.raises(AssemblyError, match="none of their"):
        solve(loads(text.replace("B above AD", f"B above AD, C {other} of BD")), repeats=0, precise=False)


def test_a_pin_in_two_slots_leaves_one_freedom() -> None:
    problem = load("pin-in-two-slots")
    assert mobility(problem.mechanism).freedom == 1
    assert all(abs(one.deviation) < 1e-9 for one in exactly(problem).answers.values() if one.deviation is not None)


def test_a_roller_is_welded_and_the_solution_says_so() -> None:
    problem = load("cam-roller")
    assert problem.mechanism.welded == (("3", "2"),) and "3" not in problem.mechanism.bodies
    assert any(
        "滚子 3 与构件 2 焊成一体" in step.words.zh and "roller 3 as welded to link 2" in step.words.en
        for step in solve(problem).construction.steps
    )
    assert "局部自由度" in welded(problem.mechanism).zh and "滚子 3 与构件 2" in welded(problem.mechanism).zh


def test_the_welded_roller_moves_the_lever_as_a_disc_of_the_lever_does() -> None:
    text = load("cam-roller").text or ""
    plain = text.replace(
        "  2: {DE: 145 mm}\n  3: {disc: E, radius: 14 mm}", "  2: {DE: 145 mm, disc: E, radius: 14 mm}"
    ).replace("1 touches 3", "1 touches 2")
    assert plain != text
    one, other = (oracle.solve(loads(source).mechanism) for source in (text, plain))
    assert float(one.alpha("2")) == float(other.alpha("2"))


def test_the_turning_of_an_idle_roller_is_not_answered() -> None:
    with pytest.raises(ProblemFileError, match="turns idly"):
        loads((load("cam-roller").text or "").replace("find: [v_E", "find: [omega_3, v_E"))


OFFSET = """
id: offset
title: offset
frame: {A: [0 mm, 0 mm], D: [40 mm, -60 mm]}
links:
  1: {slot: {through: A, left: 30 mm}, E: {AE: 50 mm, angle: 30 deg from line}}
  2: {DB: 120 mm}
joints: [B runs in 1]
input: {link: 1, phi: 20 deg, omega: 10 rad/s ccw}
find: [p_B, v_E, omega_2]
"""


@pytest.mark.parametrize("guess", [(-64.0, 9.0), (77.0, 60.0)])
def test_a_rough_place_chooses_the_assembly_in_an_offset_slot(guess: tuple[float, float]) -> None:
    solution: Solution = solve(
        loads(OFFSET + f"guesses: {{B: [{guess[0]} mm, {guess[1]} mm]}}\n"), by="exact", repeats=0
    )
    place = solution.answers["p_B"].drawn_vector
    assert place is not None and abs(1e3 * place - complex(*guess)) < 15
    assert all(abs(one.deviation) < 1e-9 for one in solution.answers.values() if one.deviation is not None)


def test_without_a_rough_place_or_a_side_the_offset_slot_is_refused() -> None:
    with pytest.raises(AssemblyError, match="two ways"):
        solve(loads(OFFSET))


def test_a_centre_of_mass_may_be_told_by_two_lengths() -> None:
    text = changed(
        "find: [omega_1, v_E, a_E, v_C3C2]",
        "masses: {1: {mass: 2 kg, centre: {AS1: 600 mm, CS1: 700 mm, side: left of AC}}}\n"
        'weight: yes\ninertia: no\nloads: {F: {cylinder: 2-3, size: "?"}}\nfind: [F]',
    )
    place = loads(text).mechanism.link("1").points["S1"]
    assert (abs(place), abs(place - 1.15)) == pytest.approx((0.6, 0.7))


def test_the_thrust_of_a_cylinder_balances_and_its_reactions_equal_it() -> None:
    answers = exactly(load("boom-thrust")).answers
    assert answers["F_c"].drawn == pytest.approx(answers["F_c"].exact, rel=1e-9)
    assert answers["F_c_power"].drawn == pytest.approx(answers["F_c"].exact, rel=1e-9)
    assert abs(answers["R_31"].drawn_vector or 0) == pytest.approx(answers["F_c"].exact, rel=1e-9)


@pytest.mark.parametrize(
    ("way", "friction"), [("270 deg", ""), ("90 deg", ""), ("270 deg", "friction: {A: {rho: 20 mm}}")]
)
@pytest.mark.parametrize(
    "thrust", ['F: {cylinder: 2-3, size: "?"}', 'F: {cylinder: 2-3, size: 60 kN}, M: {on: 1, size: "?"}']
)
def test_a_cylinder_s_free_bodies_are_in_equilibrium_and_its_reactions_act_at_its_pins(
    thrust: str, way: str, friction: str
) -> None:
    text = changed(
        "find: [omega_1, v_E, a_E, v_C3C2]",
        f"loads: {{Q: {{on: 1, at: E, size: 9 kN, direction: {way}}}, {thrust}}}\n{friction}\nfind: [R_31, R_42]",
    )
    solution = solve(loads(text), by="exact", repeats=0, precise=False)
    for answer in solution.answers.values():
        assert (
            answer.drawn_vector == pytest.approx(answer.exact_vector)
            and answer.reading.acts is not None
            and answer.exact_acts is not None
        )
        assert answer.reading.acts.point == pytest.approx(answer.exact_acts.point)
    bodies = {
        f.name: {m.label: m for m in f.marks if isinstance(m, Vector)}
        for f in solution.construction.figures
        if f.view is View.BODY
    }
    assert (
        (set(bodies["2"]), set(bodies["3"])) == ({"R_{42}", "F"}, {"R_{13}", "F"})
        and "F" not in bodies["1"]
        and "R_{31}" in bodies["1"]
    )
    for one, two in (bodies["2"].values(), bodies["3"].values()):
        assert (
            one.b - one.a == pytest.approx(two.a - two.b)
            and abs(((one.b - one.a).conjugate() * (two.a - one.a)).imag) < 1e-6
        )


def test_the_thrust_lifts_what_its_lever_says() -> None:
    motion, boom = oracle.solve(load("boom-thrust").mechanism), load("boom-thrust")
    a, c, d, e, s = (complex(motion.position(letter)) for letter in ("A", "C", "D", "E", "S1"))
    line = (c - d) / abs(c - d)
    arm = (np.conj(c - a) * line).imag
    thrust = (9000 * (e - a).real + 1800 * 9.81 * (s - a).real) / arm
    assert exactly(boom).answers["F_c"].exact == pytest.approx(thrust, rel=1e-9)


def test_a_thrust_between_two_moving_links_is_found_by_virtual_power() -> None:
    text = (load("scissor-lift").text or "").split("find:")[
        0
    ] + 'loads:\n  F: {cylinder: 4-5, size: "?"}\n  Q: {on: 1, at: B, size: 5000 N, direction: 270 deg}\nfind: [F]\n'
    found = exactly(loads(text)).answers["F"]
    assert found.drawn == pytest.approx(found.exact, rel=1e-9) and abs(found.exact) > 1


def test_trials_of_another_driver_are_drawn_once_for_all_places_of_the_drive(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[float] = []
    draw = trial.Trial._drawn

    def counted(trial: Any, at: float) -> Any:
        drawn.append(at)
        return draw(trial, at)

    monkeypatch.setattr(trial.Trial, "_drawn", counted)
    trial._structure.cache_clear()
    exchange.exchanged.cache_clear()
    mech = load("scissor-lift").mechanism
    places: dict[float, int] = {}
    for length in (0.62, 0.64, 0.66):
        before = len(drawn)
        exchange.exchanged(replace(mech, drives=(replace(mech.drive, position=length),)), (Stage.POSITION,))
        places[length] = len(drawn) - before
    assert places[0.62] > exchange.TRIALS and 0 < places[0.64] < 120 and 0 < places[0.66] < 120
