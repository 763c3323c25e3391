"""Trains reduced to a shaft: drawn, exact, worked out elsewhere; the reduced machine moves as the whole one does."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.cam_cases import agree, device, drawn
from tests.flywheels import CASES
from tests.laws import often
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import TurnArrow
from vecpoly.devices.base import Device
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.problem.load import load
from vecpoly.solution import solve

SHAFTS: dict[str, Any] = {"1": {"J": "0.1 kg*m^2", "drives": "80 N*m"}, "2": {"J": "0.2 kg*m^2", "resists": "9 N*m"}}


def train(**data: Any) -> Device:
    return device("reduced-train", **{"shafts": SHAFTS, "pairs": ["1 to 2 by 20/30"]} | data)


def hoist() -> Device:
    """B01."""
    told = CASES["B01"]["inputs"]
    z = told["z"]
    shafts = {
        "1": {"J": f"{told['J_motor']} kg*m^2", "drives": f"{told['M_start_Nm']} N*m"},
        "2": {"J": f"{told['J_gear2']} kg*m^2"},
        "3": {"J": f"{told['J_drum']} kg*m^2", "drum": f"{told['drum_d_mm']} mm", "lifts": f"{told['load_kg']} kg"},
    }
    pairs = [f"1 to 2 by {z[0]}/{z[1]}", f"2 to 3 by {z[2]}/{z[3]}"]
    return train(shafts=shafts, pairs=pairs, until=f"{told['n_motor_rpm']} r/min")


def test_the_hoist_runs_up_as_it_was_worked_out() -> None:
    found, told = agree(hoist()), CASES["B01"]["results"]
    names = {
        "J_e": "J_e_kgm2",
        "M_r": "M_r_Nm",
        "alpha_1": "alpha_rad_s2",
        "t": "t_run_s",
        "N": "motor_turns",
        "lift": "lift_m",
        "F_rope": "rope_force_accelerating_N",
    }
    for key, name in names.items():
        assert found[key] == pytest.approx(told[name], rel=1e-8), key


def test_the_headstock_and_the_train_have_the_numbers_of_the_book() -> None:
    lathe, told = solve(load("7-2a"), by="exact").answers, CASES["7-2a"]["results"]
    assert (lathe["J_e"].drawn, lathe["M_r"].drawn) == pytest.approx((told["J_kgm2"], told["M_r_Nm"]))
    run, told = solve(load("7-3"), by="exact").answers, CASES["7-3"]["results"]
    assert (run["alpha_1"].drawn, run["omega_1"].drawn) == pytest.approx((told["alpha1_rad_s2"], told["omega1_rad_s"]))


def test_a_moment_that_resists_is_a_size_in_the_sum_and_negative_in_the_table_which_is_told() -> None:
    steps = solve(load("7-2a"), by="exact").construction.steps
    ((words, listing),) = [(step.words, step.listing) for step in steps if step.listing is not None]
    *shafts, total = listing.rows
    assert [row[-1] for row in shafts if row[-1] != "0"] == ["−15"]
    assert total == ("Σ", "", "", "0.2850", "", "−15"), "what the table is for: J_e and M_e"
    assert "阻力为负" in words.zh and "in the table driving ones are positive" in words.en


@st.composite
def chains(draw: st.DrawFn) -> dict[str, Any]:
    """Shafts in a row or side by side, as many pairs as join them."""
    names = ["A", "B", "C", "D"][: draw(st.integers(2, 4))]
    inertia = st.floats(0.01, 5).map(lambda value: f"{value} kg*m^2")
    moment = st.floats(1, 500).map(lambda value: f"{value} N*m")
    shafts = {name: {"J": draw(inertia), draw(st.sampled_from(["drives", "resists"])): draw(moment)} for name in names}
    pairs = []
    for n, name in enumerate(names[1:], 1):
        before = names[draw(st.integers(0, n - 1))]
        sizes = draw(st.tuples(st.integers(12, 90), st.integers(12, 90)))
        joined = (before, name) if draw(st.booleans()) else (name, before)
        pairs.append(f"{joined[0]} to {joined[1]} by {sizes[0]}/{sizes[1]}")
    return {"shafts": shafts, "pairs": draw(st.permutations(pairs)), "to": draw(st.sampled_from(names))}


@given(chains())
@settings(max_examples=often(6))
def test_the_energy_rises_by_the_power_whatever_shaft_is_taken(data: dict[str, Any]) -> None:
    found = agree(train(**data))
    if "M_e" not in found:
        return
    turns = {name: found.get(f"i_{name}_{data['to']}", 1.0) for name in data["shafts"]}
    inertia = {name: float(shaft["J"].split()[0]) for name, shaft in data["shafts"].items()}
    gained = sum(inertia[name] * turns[name] * found[f"alpha_{name}"] for name in turns)  # at ω = 1
    assert gained == pytest.approx(found["M_e"], rel=1e-9, abs=1e-9)
    other = device_answers(train(**(data | {"to": next(iter(data["shafts"]))})))
    for name in turns:
        assert found[f"alpha_{name}"] == pytest.approx(other[f"alpha_{name}"], rel=1e-9, abs=1e-9)


# J_e = 1 + 4/4 = 2 kg·m², M_e = 4 − 24/2 = −8 N·m, α = −4 rad/s²: at rest after 6/4 s
BRAKED: dict[str, Any] = {
    "shafts": {"1": {"J": "1 kg*m^2", "drives": "4 N*m"}, "2": {"J": "4 kg*m^2", "resists": "24 N*m"}},
    "pairs": ["1 to 2 by 20/40"],
    "start": "6 rad/s",
}


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"pairs": ["1 with 2"]}, "is no pair of wheels"),
        ({"pairs": ["1 to 3 by 20/30"]}, "shaft [23] is not joined"),
        ({"pairs": ["1 to 2 by 20/30", "2 to 1 by 20/40"]}, "train is closed"),
        ({"to": "9"}, "no shaft '9'"),
        ({"until": "90 r/min", "after": "1 s"}, "write one of"),
        ({"shafts": {"1": {"J": "1 kg*m^2"}, "2": {"resists": "9 N*m"}}, "after": "1 s"}, r"by -6 N·m\)"),
        ({"start": "50 rad/s", "until": "40 rad/s"}, r"never comes to 40 rad/s with M_e = 74 N·m"),
        ({**BRAKED, "after": "9 s"}, r"after 1\.5 s it stands still, and what resists drives nothing back"),
        ({**BRAKED, "until": "-10 r/min"}, r"after 1\.5 s it stands still"),
        ({**BRAKED, "start": "-9 rad/s", "after": "1 s"}, "what resists would drive"),
        ({"shafts": {"1": {"drum": "1 m"}, "2": {}}}, "a drum goes with"),
    ],
)
def test_what_is_no_train_or_does_not_move_is_refused_with_its_numbers(data: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        train(**data)


def test_a_moment_that_drives_and_one_that_resists_on_the_same_shaft_have_an_arrow_each() -> None:
    both = {"1": {"J": "0.1 kg*m^2", "drives": "80 N*m", "resists": "9 N*m"}, "2": {"J": "0.2 kg*m^2"}}
    for pairs in (["1 to 2 by 20/90"], ["1 to 2 by 90/20"]):
        figure = drawn(train(shafts=both, pairs=pairs)).figure(View.MECHANISM)
        assert figure is not None
        arrows = {mark.label: mark for mark in figure.marks if isinstance(mark, TurnArrow)}
        one, two = arrows["M_{d1}"], arrows["M_{r1}"]
        assert one.at == two.at and one.ccw is not two.ccw and abs(one.radius - two.radius) > 3  # mm: a row of letters
