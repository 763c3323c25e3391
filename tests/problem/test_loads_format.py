"""Loads, friction, masses and devices as written in a problem file:
what is read, what is printed after 已知, what is checked."""

from __future__ import annotations

import cmath
import json
from math import atan, degrees, pi, radians, sin
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.texts import SLIDER_CRANK
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.check.truth import exact_values
from vecpoly.devices.base import Device
from vecpoly.errors import EquilibriumError, ProblemFileError
from vecpoly.mechanism.asked.forces import given_value
from vecpoly.mechanism.loads import Force, Loads, Mass, Moment
from vecpoly.names import At
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.editors import json_schema
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem

CRANK = (
    SLIDER_CRANK
    + """\
input: {link: 1, phi: 52 deg, omega: ccw}
branch: [C right of B]
loads:
  F: {on: 3, at: C, size: 1000 N, direction: 180 deg, role: driving}
  M_1: {on: 1, size: "?", role: resisting}
"""
)
RUBBING = "friction: {A: {rho: 6 mm}, B: {f: 0.1, r: 50 mm}, 3-4: {phi: 8 deg}}\n"
MOVING = CRANK.replace("omega: ccw", "omega: 10 rad/s ccw")


def told(problem: Problem, lang: str = "zh") -> list[str]:
    """What is printed of the loads after 已知."""
    return [datum.of(lang) for datum in problem.given.loads]  # type: ignore[arg-type]


def acting(text: str) -> Loads:
    """The loads of this text."""
    found = loads(text).loads
    assert found is not None
    return found


def test_a_force_and_a_moment_are_read_with_their_role() -> None:
    found = acting(CRANK)
    assert found.forces == (Force(name="F", link="3", point="C", direction=pi, size=1000.0, role="driving"),)
    assert found.moments == (Moment(name="M_1", link="1", size=None, role="resisting"),)
    assert found.unknown is found.moments[0]


@pytest.mark.parametrize(
    ("size", "value"),
    [("20 N*m ccw", 20.0), ("20 N·m cw", -20.0), ("500 N*mm 逆时针", 0.5), ("-3 N*m", -3.0), ("0.02 kN*m", 20.0)],
)
def test_a_moment_has_a_sense(size: str, value: float) -> None:
    text = CRANK.replace(
        "F: {on: 3, at: C, size: 1000 N, direction: 180 deg, role: driving}", f"M_2: {{on: 2, size: {size}}}"
    )
    assert acting(text).moments[0].size == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    ("size", "en"),
    [
        ("20 N*m", "20 N·m (counter-clockwise)"),
        ("-3 N*m", "3 N·m (clockwise)"),
        ("20 N·m cw", "20 N·m (clockwise)"),
        ("500 N*mm 逆时针方向", "500 N·mm (counter-clockwise)"),
        ("2 kN*m anticlockwise", "2 kN·m (counter-clockwise)"),
    ],
)
def test_a_given_moment_is_told_with_its_sense_and_no_sign(size: str, en: str) -> None:
    text = CRANK.replace(
        "F: {on: 3, at: C, size: 1000 N, direction: 180 deg, role: driving}", f"M_2: {{on: 2, size: {size}}}"
    )
    assert f"moment $M_2$ = {en} on link 2" in told(loads(text), "en")


def test_an_unknown_load_with_point_and_direction_is_a_force() -> None:
    text = CRANK.replace(
        'M_1: {on: 1, size: "?", role: resisting}', 'F_b: {on: 1, at: B, size: "?", direction: 90 deg}'
    )
    assert acting(text).unknown == Force(name="F_b", link="1", point="B", direction=pi / 2, size=None)


def test_friction_is_read_by_pin_slide_and_groove() -> None:
    friction = acting(CRANK + RUBBING).friction
    assert dict(friction.pins) == pytest.approx({"A": 0.006, "B": 0.005})
    assert dict(friction.slides) == pytest.approx({("3", "0"): radians(8)})


@pytest.mark.parametrize("name", ["3-4", "4-3", "3 - 4"])
def test_the_links_of_a_slide_may_stand_in_either_order(name: str) -> None:
    friction = acting(CRANK + f"friction: {{{name}: {{f: 0.14}}}}\n").friction
    assert friction.slides["3", "0"] == pytest.approx(atan(0.14), rel=1e-15)


@given(f=st.floats(0, 5), half=st.floats(1, 90))
def test_a_groove_rubs_like_its_equivalent_coefficient(f: float, half: float) -> None:
    groove = acting(CRANK + f"friction: {{3-4: {{f: {f!r}, V: {half!r} deg}}}}\n").friction.slides
    plain = acting(CRANK + f"friction: {{3-4: {{f_v: {f / sin(radians(half))!r}}}}}\n").friction.slides
    assert groove["3", "0"] == pytest.approx(plain["3", "0"], rel=1e-12)


def test_a_pin_in_a_slot_rubs_by_the_numbers_of_the_two_links() -> None:
    text = """\
id: t
title: test
frame: {A: [0 mm, 0 mm], D: [0 mm, -200 mm]}
links: {1: {AB: 60 mm}, 2: {slot: D}}
joints: [B runs in 2]
input: {link: 1, phi: 52 deg, omega: ccw}
loads: {M_2: {on: 2, size: 20 N*m cw}, M_1: {on: 1, size: "?"}}
friction: {1-2: {phi: 8 deg}}
find: [M_1]
"""
    assert list(acting(text).friction.slides) == [("pinB", "2")]


def test_a_contact_rubs_under_its_letter() -> None:
    problem = load("4-4")
    assert problem.loads
    (contact,) = problem.mechanism.contacts
    assert list(problem.loads.friction.contacts) == [contact.point]


MASSES = """\
masses:
  2: {mass: 3 kg, inertia: 0.02 kg*m^2, centre: {along: BC, at: 100 mm, left: 20 mm}}
  3: {mass: 2 kg}
"""


def test_a_centre_of_mass_is_a_lettered_point_that_the_hand_can_set_out() -> None:
    problem = loads(MOVING + MASSES + "find: [a_S2, v_S2, p_S2, F_I2]\n")
    link = problem.mechanism.link("2")
    assert link.points["S2"] == pytest.approx(0.1 + 0.02j)
    assert [placement.point for placement in link.placements] == ["S2"]
    assert [ask.rel.to for ask in problem.asks if not isinstance(ask, AskNamed)] == [At("S2")] * 3
    assert problem.loads and problem.loads.masses == (
        Mass(link="2", mass=3.0, inertia=0.02, centre="S2"),
        Mass(link="3", mass=2.0, inertia=0.0, centre="C"),
    )


def test_the_centre_of_mass_moves_as_its_link_does() -> None:
    values = exact_values(loads(MOVING + MASSES + "find: [p_B, p_C, p_S2, v_B, v_C, v_S2]\n"))
    p, v = ([complex(values[f"{kind}_{point}"]) for point in ("B", "C", "S2")] for kind in "pv")
    assert (p[2] - p[0]) / (p[1] - p[0]) == pytest.approx((0.1 + 0.02j) / 0.23, rel=1e-12)
    assert (v[2] - v[0]) / (v[1] - v[0]) == pytest.approx((0.1 + 0.02j) / 0.23, rel=1e-12)


def test_the_mass_of_a_round_bar_follows_from_its_section() -> None:
    found = acting(MOVING + "masses: {2: {rod: {diameter: 50 mm, density: 7800 kg/m^3}}}\n").mass("2")
    assert found is not None
    assert found.mass == pytest.approx(7800 * pi * 0.05**2 / 4 * 0.23, rel=1e-14)
    assert found.inertia == pytest.approx(found.mass * 0.23**2 / 12, rel=1e-14)
    assert loads(MOVING + "masses: {2: {rod: {diameter: 50 mm, density: 7800 kg/m^3}}}\n").mechanism.link("2").points[
        "S2"
    ] == pytest.approx(0.115)


@given(mass=st.floats(0.01, 100), length=st.floats(0.01, 2))
def test_a_bar_of_the_diameter_that_a_mass_needs_has_that_mass(mass: float, length: float) -> None:
    text = MOVING.replace("BC: 230 mm", f"BC: {length + 0.5!r} m")
    bar = acting(text + "masses: {2: {rod: {diameter: 50 mm, density: 7800 kg/m^3}}}\n").mass("2")
    assert bar and bar.rod
    again = bar.rod.diameter_of(mass)
    assert 7800 * pi * again**2 / 4 * bar.rod.length == pytest.approx(mass, rel=1e-12)


def test_weight_and_inertia_can_be_switched() -> None:
    found = acting(CRANK + MASSES + "weight: yes\ninertia: no\n")
    assert found.weight and not found.dynamic
    assert acting(MOVING + MASSES).dynamic and not acting(MOVING + MASSES).weight


@pytest.mark.parametrize(("sense", "rate"), [("ccw", 1.0), ("cw", -1.0), ("顺时针", -1.0)])
def test_a_sense_alone_is_one_radian_per_second_and_is_printed_without_a_number(sense: str, rate: float) -> None:
    problem = loads(CRANK.replace("omega: ccw", f"omega: {sense}"))
    assert problem.mechanism.drive.rate == rate
    assert [datum.of("zh") for datum in problem.given.motion] == [
        "$φ_1$ = 52°",
        f"$ω_1$ {'逆' if rate > 0 else '顺'}时针",
    ]
    assert problem.given.motion[1].of("en") == f"$ω_1$ {'counter-' if rate > 0 else ''}clockwise"


def test_an_unknown_load_of_which_nothing_is_asked_is_not_called_sought() -> None:
    """Of R_23 alone the data said that M_1 is sought."""
    asked = [" ".join(told(loads(f"{MOVING}find: [{find}]\n"))) for find in ("M_1, R_23", "R_23")]
    assert "待求的阻力矩 $M_1$" in asked[0] and "大小未知的阻力矩 $M_1$" in asked[1] and "待求" not in asked[1]


@pytest.mark.parametrize("key", ["F_I2", "M_I2", "h_2"])
def test_an_inertia_force_that_is_neglected_cannot_be_asked(key: str) -> None:
    """No method was said to be on file for it."""
    with pytest.raises(ProblemFileError, match=f"'inertia: no' neglects the inertia forces, so there is no {key}"):
        loads(f"{MOVING}{MASSES}inertia: no\nfind: [{key}]\n")
    assert loads(f"{MOVING}{MASSES}find: [{key}]\n").asks


def test_the_given_loads_are_printed_in_both_languages() -> None:
    problem = loads(MOVING + RUBBING.replace("}}\n", "}, C: {rho: 4 mm}}\n") + MASSES + "weight: yes\n")
    assert told(problem) == [
        "驱动力 $F$ = 1000 N，作用于构件 3 的 $C$ 点，水平向左",
        "待求的阻力矩 $M_1$ 作用于构件 1",
        "计各构件重力，$g$ = 9.81 m/s²",
        "$ρ_A$ = 6 mm",
        "$f_B$ = 0.1，$r_B$ = 50 mm，$ρ_B$ = $f_B r_B$ = 5 mm",
        "$φ_{34}$ = 8°",
        "$ρ_C$ = 4 mm",
        "$m_2$ = 3 kg",
        "$J_{S2}$ = 0.02 kg·m²",
        "$m_3$ = 2 kg",
        "构件 3 的质心在 $C$",
    ]
    assert told(problem, "en")[:2] == [
        "driving force $F$ = 1000 N on link 3 at $C$, directed horizontally to the left",
        "the unknown resisting moment $M_1$ acts on link 1",
    ]
    assert problem.given.lengths[2].of("en") == "$S_2$ lies 100 mm from $B$ along $BC$ and 20 mm to its left"


def test_a_coefficient_is_told_with_the_place_to_which_it_belongs() -> None:
    """f = 0.153 of a pin stood beside f_v = f/sin θ of a groove, whose f is another."""
    rubbing = "friction: {A: {f: 0.2, r: 20 mm}, B: {f_v: 0.1, r: 20 mm}, 3-4: {f: 0.1, V: 30 deg}}\n"
    text = [words for words in told(loads(CRANK + rubbing)) if "f_" in words]
    assert text == [
        "$f_A$ = 0.2，$r_A$ = 20 mm，$ρ_A$ = $f_A r_A$ = 4 mm",
        "$f_{vB}$ = 0.1，$r_B$ = 20 mm，$ρ_B$ = $f_{vB} r_B$ = 2 mm",
        "$f_{34}$ = 0.1，$θ_{34}$ = 30°，$f_{v34}$ = $f_{34}$/sin $θ_{34}$ = 0.2，$φ_{34}$ = arctan $f_{v34}$ = 11.31°",
    ]


def test_where_nothing_is_asked_the_unknown_its_frictionless_value_and_all_reactions_are() -> None:
    asked = [ask.rel.key for ask in loads(CRANK + RUBBING).asks]
    assert [key for key in asked if not key.startswith("R_")] == ["M_1", "M_1_0", "eta"]
    assert [key for key in (ask.rel.key for ask in loads(CRANK).asks) if not key.startswith("R_")] == ["M_1"]


def test_one_reaction_of_each_pair_is_asked_for() -> None:
    for text in (CRANK, CRANK + RUBBING):
        reactions = [frozenset(ask.rel.key[2:]) for ask in loads(text).asks if ask.rel.key.startswith("R_")]
        assert sorted(map(sorted, reactions)) == [["1", "2"], ["1", "4"], ["2", "3"], ["3", "4"]]


def test_a_force_scale_may_be_given() -> None:
    assert loads(CRANK + "scales: {mu_F: 10 N/mm}\n").scales.given["mu_F"] == pytest.approx(10.0)


@pytest.mark.parametrize(
    ("symbol", "value", "si"),
    [
        ("R_12", "1.004 kN", 1004.0),
        ("M_1", "-64254 N*mm", -64.254),
        ("M_1", "64.3 N·m cw", -64.3),
        ("eta", "79.5 %", 0.795),
        ("eta", "0.795", 0.795),
        ("h", "64 mm", 0.064),
        ("m_2", "3000 g", 3.0),
        ("J_2", "0.02 kg·m²", 0.02),
    ],
)
def test_printed_values_are_read_by_their_unit(symbol: str, value: str, si: float) -> None:
    problem = loads(MOVING + MASSES + f"printed: [{{symbol: {symbol}, value: {value}}}]\n")
    assert problem.printed[0].value == pytest.approx(si, rel=1e-12)


def test_a_printed_force_may_be_a_length_on_paper() -> None:
    printed = loads(CRANK + "printed: [{symbol: R_12, value: 50.2 mm, scale: 20 N/mm}]\n").printed[0]
    assert printed.value == pytest.approx(1004.0)
    assert printed.paper_mm == pytest.approx(50.2)


def test_masses_and_inertias_are_data_that_need_no_equilibrium() -> None:
    found = acting(MOVING + MASSES)
    assert [given_value(found, key) for key in ("m_2", "J_2", "m_3", "J_3", "m_1", "M_1", "F_I2")] == [
        3.0,
        0.02,
        2.0,
        0.0,
        None,
        None,
        None,
    ]


@pytest.mark.parametrize(
    "name", ["4-3a", "4-3b", "4-3c", "4-3d", "4-6", "C-inertia", "slider-crank-dynamic", "six-bar-dynamic"]
)
def test_the_problems_on_file_load_and_balance(name: str) -> None:
    problem = load(name)
    values = exact_values(problem)
    assert set(values) == {ask.rel.key for ask in problem.asks}
    assert all(value == value for value in values.values())


# What the case file says of exercise 4-3 (N, mm, degrees); the drawing and the oracle are compared elsewhere.
EXERCISE = {
    "4-3a": (1004.31, 162.408, 306.525, 82.0, -64254.4, 0.795162, -80806.7),
    "4-3b": (1002.85, 162.914, 297.539, 82.0, -22765.4, 0.650934, -34973.5),
    "4-3c": (996.719, 14.522, 252.385, 98.0, -52277.5, 0.799369, -65398.4),
    "4-3d": (1016.55, -21.0577, 368.846, -98.0, 38821.5, 0.739411, 52503.3),
}


@pytest.mark.parametrize("name", EXERCISE)
def test_exercise_4_3_as_written_gives_the_values_of_the_case_file(name: str) -> None:
    values = exact_values(load(name))
    found = [x for key in ("R_32", "R_43") for x in (abs(values[key]), degrees(cmath.phase(values[key])))]
    found += [1e3 * float(values["M"].real), float(values["eta"].real), 1e3 * float(values["M_0"].real)]
    assert found == pytest.approx(EXERCISE[name], rel=5e-6)


def test_the_report_is_caught_with_the_masses_of_other_bars_and_the_inertia_of_another_link() -> None:
    slips = {
        c.printed.symbol: (c.verdict, c.slip.en if c.slip else "") for c in check_problem(load("C-inertia")).answers
    }
    assert {verdict for verdict, _ in slips.values()} == {Verdict.WRONG}
    assert slips["m_1"][1] == "the mass of a bar 87.7 mm thick, though $d$ = 100 mm"
    assert slips["m_2"][1] == "the mass of a bar 56.9 mm thick, though $d$ = 50 mm"
    assert slips["m_3"][1] == "the mass of a bar 81 mm thick, though $d$ = 80 mm"
    for link in "123":
        assert slips[f"J_{link}"][1].startswith(f"follows from the values printed before: $m_{{{link}}} l^2/12$")
    assert slips["M_I2"][1].startswith(
        "the moment of inertia of link 1 was taken for that of link 2: $J_{1} α_{2}$ gives 0.000925"
    )
    assert slips["h_2"][1].startswith("follows from the values printed before: $M_{I2} / F_{I2}$ gives 0.00409")


@pytest.mark.parametrize(
    ("printed", "verdict", "slip"),
    [
        ("{symbol: M_I2, value: right}", Verdict.REPRODUCED, None),
        ("{symbol: M_I2, value: other}", Verdict.WRONG, "the moment of inertia of link 1 was taken for that of link 2"),
        ("{symbol: M_I2, value: stray}", Verdict.WRONG, None),
    ],
)
def test_the_value_of_another_link_is_recognised_and_a_stray_one_is_not(
    printed: str, verdict: Verdict, slip: str | None
) -> None:
    text = MOVING + MASSES + "  1: {mass: 1 kg, inertia: 0.0047 kg*m^2, centre: A}\n"
    right = abs(exact_values(loads(text + "find: [M_I2]\n"))["M_I2"])
    values = {"right": right, "other": right * 0.0047 / 0.02, "stray": right * 0.61}
    for name, value in values.items():
        printed = printed.replace(name, f"{value:.4f} N*m")
    (found,) = check_problem(loads(text + f"printed: [{printed}]\n")).answers
    assert found.verdict is verdict
    assert (found.slip.en if found.slip else "").startswith(slip or "") and (found.slip is not None) is (
        slip is not None
    )


def test_a_right_print_of_inertia_is_reproduced() -> None:
    text = (load("C-inertia").text).split("printed:")[
        0
    ] + "printed: [{symbol: m_1, value: 7.045 kg}, {symbol: J_2, value: 0.07283 kg·m²}]\n"
    assert [c.verdict for c in check_problem(loads(text)).answers] == [Verdict.REPRODUCED] * 2


def test_a_load_that_does_not_what_its_role_says_is_refused() -> None:
    values = exact_values(loads(CRANK + "find: [M_1]\n"))
    assert values["M_1"].real < 0  # against ω_1: it resists, as the file says
    turned = CRANK.replace("direction: 180 deg", "direction: 0 deg") + "find: [M_1]\n"
    with pytest.raises(
        EquilibriumError, match="load F is called driving, but in this position it takes power from the mechanism"
    ):
        exact_values(loads(turned))
    swapped = (
        turned.replace("role: driving", "role: role")
        .replace("role: resisting", "role: driving")
        .replace("role: role", "role: resisting")
    )
    assert exact_values(loads(swapped))["M_1"].real == pytest.approx(-values["M_1"].real)


DEVICE = """\
id: d
title: test
device: screw-jack
data: {d: 24 mm, d1: 20 mm, p: 4 mm, D: 30 mm, d0: 15 mm, l: 300 mm, f: 0.1, F: 100 N}
"""


def test_a_device_stands_in_the_place_of_a_mechanism() -> None:
    problem = loads(DEVICE)
    assert isinstance(problem.subject, Device) and problem.loads is None
    assert [ask.rel for ask in problem.asks] == list(problem.device.quantities())
    assert told(problem)[1:4] == ["$d$ = 24 mm", "$d_1$ = 20 mm", "$p$ = 4 mm"]  # behind the trial load


def test_of_a_device_some_quantities_may_be_asked_and_checked() -> None:
    problem = loads(
        DEVICE + "find: [eta, M_over_Q]\nprinted: [{symbol: eta, value: 21.85 %}, {symbol: M_over_Q, value: 2.9133 "
        "mm}]\n"
    )
    assert [ask.rel.key for ask in problem.asks] == ["eta", "M_over_Q"]
    assert [printed.value for printed in problem.printed] == pytest.approx([0.2185, 2.9133])


def test_the_schema_knows_loads_friction_masses_and_devices() -> None:
    schema = json_schema()
    json.dumps(schema)
    assert {"loads", "friction", "masses", "weight", "inertia", "device", "data"} <= set(schema["properties"])
    devices = {
        branch["if"]["properties"]["device"]["const"]: branch["then"]["properties"]["data"]
        for branch in schema["allOf"]
        if "device" in branch["if"]["properties"]
    }
    assert set(devices) == set(schema["properties"]["device"]["enum"]) - {None}
    assert {"d", "p", "f", "Q"} <= set(devices["screw-jack"]["properties"])
    assert {"on", "cylinder", "at", "size", "while", "spring", "motor"} < set(schema["$defs"]["LoadSpec"]["properties"])


def references(node: object) -> list[str]:
    """Every $ref in a schema."""
    if isinstance(node, dict):
        own = [node["$ref"]] if isinstance(node.get("$ref"), str) else []
        return own + [ref for value in node.values() for ref in references(value)]
    return [ref for value in node for ref in references(value)] if isinstance(node, list) else []


def test_every_reference_of_the_schema_leads_somewhere() -> None:
    schema = json_schema()
    assert {ref.removeprefix("#/$defs/") for ref in references(schema)} <= set(schema["$defs"])


def test_an_assignment_may_hold_a_device_and_change_a_load(tmp_path: Path) -> None:
    (tmp_path / "jack.yaml").write_text(DEVICE, encoding="utf-8")
    sheet = tmp_path / "sheet.yaml"
    sheet.write_text(
        "title: t\nproblems:\n  - jack.yaml\n  - {problem: 4-3a, id: half, loads: {F: {size: 500 N}}}\n",
        encoding="utf-8",
    )
    jack, half = load_assignment(sheet).problems
    assert isinstance(jack.subject, Device)
    assert half.loads and half.loads.forces[0].size == 500.0
    assert exact_values(half)["M"].real == pytest.approx(exact_values(load("4-3a"))["M"].real / 2, rel=1e-9)


def test_a_load_may_be_called_like_the_power_of_another_and_no_centre_is_meant() -> None:
    text = """
id: named-P
title: a load called P_r
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 150 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
branch: [C right of B]
loads: {P_r: {on: 3, at: C, size: "?", direction: 180 deg}, M_1: {on: 1, size: 10 N*m}}
find: [P_r, P_13, omega_ratio_12, R_43]
"""
    from vecpoly import loads, solve

    solution = solve(loads(text), by="exact", repeats=0)
    assert [answer.is_place for answer in solution.answers.values()] == [False, True, False, False]
    assert all(abs(answer.deviation) < 1e-9 * max(1, abs(answer.exact)) for answer in solution.answers.values())
    with pytest.raises(ProblemFileError, match="instant centre"):
        loads(text.replace("P_r", "P_12"))


@pytest.mark.parametrize(
    ("written", "zh", "en"),
    [
        ("0 deg", "水平向右", "directed horizontally to the right"),
        ("30 deg", "指向右上方，与水平线成 30°", "directed upwards to the right at 30° to the horizontal"),
        ("158 deg", "指向左上方，与水平线成 22°", "directed upwards to the left at 22° to the horizontal"),
        ("-75 deg", "指向右下方，与水平线成 75°", "directed downwards to the right at 75° to the horizontal"),
        ("200.5 deg", "指向左下方，与水平线成 20.5°", "directed downwards to the left at 20.5° to the horizontal"),
    ],
)
def test_the_direction_of_a_force_is_told_from_the_horizontal(written: str, zh: str, en: str) -> None:
    problem = loads((MOVING + MASSES).replace("direction: 180 deg", f"direction: {written}"))
    assert zh in told(problem)[0] and told(problem, "en")[0].endswith(en)
