"""Loads that do no work, slides that pass on couples, efficiencies of 0/0: answered, not refused."""

from __future__ import annotations

import json
import math

import pytest

from tests.at_once import exactly
from tests.generators.equilibrium import in_equilibrium
from vecpoly import loads
from vecpoly.check.truths.analysis import Exact
from vecpoly.report.lines import lines_table
from vecpoly.report.values import value
from vecpoly.solution import Solution

CRANK = """
id: slider
title: slider-crank
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm, G: {along: AB, at: 80 mm, left: 30 mm}}, 2: {BC: 170 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
branch: [C right of B]
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
"""
YOKE = """
id: yoke
title: Scotch yoke
frame: {A: [0 mm, 0 mm], D: [0 mm, 40 mm]}
links: {1: {AB: 60 mm}, 2: {block: B}, 3: {slot: C, E: {along: C, at: 50 mm, left: 70 mm}}}
joints: [2 slides in 3, 3 slides on line through D at 0 deg turned 90 deg]
input: {link: 1, phi: 50 deg, omega: 6 rad/s ccw}
"""
ROCKER = """
id: rocker
title: slotted rocker
frame: {A: [0 mm, 0 mm], D: [0 mm, -200 mm]}
links: {1: {AB: 60 mm}, 2: {block: B}, 3: {slot: D, G: {along: D, at: 120 mm, left: 40 mm}}}
joints: [2 slides in 3]
input: {link: 1, phi: 20 deg, omega: 6 rad/s ccw}
"""
BALANCE = 'M_1: {on: 1, size: "?"}'


def solved(text: str, *acting: str, also: str = "") -> Solution:
    found = exactly(loads(text + "loads: {" + ", ".join(acting) + "}\n" + also))
    assert in_equilibrium(found) == ""
    assert not found.suspect
    return found


def test_a_force_square_to_the_guide_needs_no_moment_and_the_guide_answers_it() -> None:
    found = solved(CRANK, "F: {on: 3, at: C, size: 100 N, direction: -90 deg}", BALANCE)
    assert found.answers["M_1"].drawn == found.answers["M_1"].exact == 0
    assert found.answers["R_43"].drawn == pytest.approx(100)
    assert found.construction.forces["R_12"].scalar == 0


def test_a_couple_on_the_slider_is_borne_by_its_guide() -> None:
    found = solved(CRANK, "M_3: {on: 3, size: 7 N*m}", BALANCE)
    guide = found.as_json()["answers"]["R_43"]
    assert found.answers["M_1"].drawn == 0 and guide["drawn"] == guide["exact"] == 0
    assert guide["couple"] == pytest.approx(-7) and guide["exact_couple"] == pytest.approx(-7)


def test_a_couple_passes_from_the_block_through_the_yoke_to_the_frame() -> None:
    found = solved(YOKE, "M_2: {on: 2, size: 12 N*m}", BALANCE)
    passed = {key: found.construction.forces[key].acts for key in ("R_23", "R_34")}
    assert [acts.couple for acts in passed.values() if acts is not None] == pytest.approx([12, 12])
    remark = found.construction.forces["R_23"].remark
    assert remark is not None and "12 N·m" in remark.en and "力偶" in remark.zh


def test_the_table_of_lines_tells_a_couple_at_infinity_and_leaves_out_forces_of_zero() -> None:
    table = lines_table(solved(YOKE, "M_2: {on: 2, size: 12 N*m}", BALANCE), "en")
    assert table is not None
    rows = {row[0]: row for row in table.rows}
    assert set(rows) == {"$R_{32}$", "$R_{43}$"}
    assert "at infinity: a couple of 12 N·m, clockwise" in rows["$R_{32}$"][3]


def test_a_couple_through_the_yoke_beside_a_force_moves_the_force_aside() -> None:
    found = solved(YOKE, "M_2: {on: 2, size: 12 N*m}", "Q: {on: 3, at: E, size: 200 N, direction: 160 deg}", BALANCE)
    acts = found.construction.forces["R_23"].acts
    assert acts is not None and acts.couple is None
    assert found.answers["M_1"].drawn == pytest.approx(found.answers["M_1"].exact, rel=1e-9)


def test_the_resultant_of_a_pure_couple_rubs_on_nothing() -> None:
    found = solved(
        YOKE, "M_2: {on: 2, size: 12 N*m}", BALANCE, also="friction: {2-3: {phi: 8 deg}, 3-4: {phi: 8 deg}}\n"
    )
    assert found.answers["M_1"].drawn == 0
    assert found.answers["eta"].undefined


def test_no_load_but_the_unknown_one_reaches_the_crank() -> None:
    found = solved(
        CRANK, "F: {on: 3, at: C, size: 100 N, direction: -90 deg}", 'F_b: {on: 1, at: G, size: "?", direction: 0 deg}'
    )
    assert found.answers["F_b"].drawn == found.answers["F_b"].exact == 0


@pytest.mark.parametrize(
    ("acting", "said"),
    [
        ("M_q: {on: 1, size: 7 N*m}", "only couples"),
        ("F: {on: 1, at: B, size: 100 N, direction: 33 deg}", "are parallel"),
        ("F: {on: 1, at: B, size: 100 N, direction: 33.2 deg}", "off the sheet"),
        ("F: {on: 1, at: B, size: 100 N, direction: 100 deg}", "are concurrent"),
    ],
)
def test_a_balancing_force_on_the_crank_by_the_way_that_the_loads_allow(acting: str, said: str) -> None:
    found = solved(CRANK, acting, 'F_b: {on: 1, at: G, size: "?", direction: 33 deg}')
    assert found.answers["F_b"].drawn == pytest.approx(found.answers["F_b"].exact, rel=1e-9)
    assert found.answers["F_b"].exact != 0
    assert any(said in step.words.en for step in found.construction.steps)


def test_a_balancing_force_against_a_couple_touches_the_friction_circle() -> None:
    found = solved(
        CRANK,
        "M_q: {on: 1, size: 7 N*m}",
        'F_b: {on: 1, at: G, size: "?", direction: 33 deg}',
        also="friction: {A: {rho: 4 mm}}\n",
    )
    acts = found.answers["R_41"].reading.acts if "R_41" in found.answers else found.construction.forces["R_41"].acts
    assert acts is not None and acts.tangent == "cw"
    assert abs(acts.point) == pytest.approx(0.004)


@pytest.mark.parametrize("also", ["", "friction: {D: {rho: 4 mm}}\n"])
def test_a_load_parallel_to_the_block_s_push_is_balanced_by_moments(also: str) -> None:
    """The slot stands at the angle of DB; the block pushes square to it."""
    b = complex(60 * math.cos(math.radians(20)), 60 * math.sin(math.radians(20)))
    way = math.degrees(math.atan2(b.imag + 200, b.real)) + 90
    found = solved(ROCKER, f"F: {{on: 3, at: G, size: 100 N, direction: {way!r} deg}}", BALANCE, also=also)
    assert any("The two lines are parallel" in step.words.en for step in found.construction.steps)
    assert found.answers["M_1"].drawn == pytest.approx(found.answers["M_1"].exact, rel=1e-9)


def test_a_force_along_the_crank_leaves_no_moment_and_no_efficiency() -> None:
    found = solved(CRANK, "F: {on: 1, at: B, size: 100 N, direction: 70 deg}", BALANCE, also="find: [M_1, eta, R_14]\n")
    assert found.answers["M_1"].drawn == found.answers["M_1"].exact == 0
    eta = found.answers["eta"]
    assert eta.undefined and eta.suspect is None and eta.deviation != eta.deviation
    told = found.as_json()["answers"]["eta"]
    assert "η = 0/0 is undefined" in told.pop("remark")["en"]
    assert told == {"unit": "", "drawn": None, "exact": None, "undefined": True, "suspect": False}
    assert json.dumps(found.as_json(), allow_nan=False)
    assert (value(eta.drawn, "", "zh", "eta"), value(eta.drawn, "", "en", "eta")) == ("无意义", "undefined")


def test_a_force_along_the_crank_with_friction_drives_nothing() -> None:
    found = solved(
        CRANK,
        "F: {on: 1, at: B, size: 100 N, direction: 70 deg}",
        BALANCE,
        also="friction: {A: {rho: 3 mm}}\nfind: [M_1, M_1_0, eta]\n",
    )
    assert found.answers["M_1"].drawn == pytest.approx(0.3)
    assert found.answers["M_1_0"].drawn == found.answers["M_1_0"].exact == 0
    assert found.answers["eta"].drawn == found.answers["eta"].exact == 0


@pytest.mark.parametrize("phi", [0.0, 1e-7, 37.0, 90.0, 180.0])
def test_an_efficiency_is_never_above_one(phi: float) -> None:
    text = CRANK.replace("phi: 70 deg", f"phi: {phi!r} deg")
    problem = loads(
        text + f"loads: {{F: {{on: 1, at: B, size: 100 N, direction: {phi!r} deg}}, {BALANCE}}}\nfriction: {{A: {{rho: "
        "2 mm}, B: {rho: 2 mm}}\nfind: [eta]\n"
    )
    eta = Exact(problem).values["eta"]
    assert isinstance(eta, float) and (math.isnan(eta) or 0 <= eta <= 1)


@pytest.mark.parametrize("at", ["0.0003 mm", "0.0000001 mm", "0 mm"])
def test_a_mass_centre_beside_a_pin_breaks_nothing(at: str) -> None:
    masses = (
        f"masses: {{2: {{mass: 3 kg, inertia: 0.02 kg*m^2, centre: {{along: BC, at: {at}}}}}, 1: {{mass: 2 kg, "
        f"inertia: 0.01 kg*m^2, centre: {{along: AB, at: {at}}}}}}}\n"
    )
    found = solved(CRANK, BALANCE, also=masses + "weight: yes\n")
    assert found.answers["M_1"].drawn == pytest.approx(found.answers["M_1"].exact, rel=1e-9)


@pytest.mark.parametrize("free", ['X: {on: 2, size: "?"}', 'X: {on: 2, at: B, size: "?", direction: 10 deg}'])
def test_a_balancing_load_on_the_connecting_rod_is_found_before_the_reactions(free: str) -> None:
    found = solved(CRANK, "F: {on: 3, at: C, size: 300 N, direction: 180 deg}", "M_1: {on: 1, size: 4 N*m}", free)
    assert found.answers["X"].drawn == pytest.approx(found.answers["X"].exact, rel=1e-9)
    assert any("virtual power" in step.words.en for step in found.construction.steps)


def test_inertia_that_drives_and_is_eaten_by_friction_gives_an_efficiency_of_nothing() -> None:
    text = (
        ROCKER.replace("phi: 20 deg", "phi: -43.7601 deg")
        .replace("D: [0 mm, -200 mm]", "D: [45.92 mm, 187.59 mm]")
        .replace("AB: 60 mm", "AB: 66.9586 mm")
    )
    masses = (
        "masses: {2: {mass: 3.41 kg}, 3: {mass: 1.55 kg, centre: G}}\nfriction: {A: {rho: 1.73 mm}, D: {rho: "
        "1.69 mm}}\nfind: [eta, M_1, M_1_0]\n"
    )
    found = solved(
        text.replace("at: 120 mm, left: 40 mm", "at: 135 mm, left: 27 mm"),
        "F: {on: 1, at: A, size: 297 N, direction: -130 deg}",
        BALANCE,
        also=masses,
    )
    assert found.answers["M_1"].exact * found.answers["M_1_0"].exact < 0
    assert found.answers["eta"].drawn == found.answers["eta"].exact == 0


def test_where_nothing_rubs_a_quantity_without_friction_is_the_quantity() -> None:
    answers = solved(
        CRANK, "F: {on: 3, at: C, size: 500 N, direction: 180 deg}", BALANCE, also="find: [M_1, M_1_0, R_23, R_23_0]"
    ).answers
    assert answers["M_1_0"].drawn == answers["M_1"].drawn != 0.0 and answers["M_1_0"].exact == pytest.approx(
        answers["M_1"].exact
    )
    assert answers["R_23_0"].drawn_vector == answers["R_23"].drawn_vector != 0j
