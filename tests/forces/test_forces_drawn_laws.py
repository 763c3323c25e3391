"""Laws of the drawn force analysis on random slider-cranks, four-bars, slotted rockers and cams; and a third party's
sum of the exported reactions."""

from __future__ import annotations

import cmath
import json
from math import cos, radians, sin
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from ruamel.yaml import YAML
from typer.testing import CliRunner

from tests.at_once import scaled
from tests.laws import few, often
from vecpoly.board.construction import Construction, Reading
from vecpoly.board.hand import hand
from vecpoly.cli.app import app
from vecpoly.errors import AssemblyError, EquilibriumError, LockedError, NoSlipSenseError
from vecpoly.mechanism.asked.forces import quantities
from vecpoly.methods.plan import construct
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem

ROOT = Path(__file__).resolve().parents[2]
CASES = json.loads((ROOT / "tests" / "data" / "ch4.json").read_text(encoding="utf-8"))
LAW = settings(max_examples=often(4), suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])

FOUR_BAR = """
frame: {A: [0 mm, 0 mm], D: [220 mm, 10 mm]}
links: {1: {AB: %(a)s mm}, 2: {BC: 210 mm}, 3: {CD: 170 mm, G: {along: CD, at: 60 mm, left: 30 mm}}}
branch: [C left of BD]
input: {link: 1, phi: %(phi)s deg, omega: %(sense)s}
loads: {F: {on: 3, at: G, size: %(size)s N, direction: %(way)s deg}, M_1: {on: 1, size: "?"}}
"""
SLIDER = """
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: %(a)s mm}, 2: {BC: 220 mm}, 3: {block: C}}
joints: [3 slides on y = 12 mm]
branch: [C right of B]
input: {link: 1, phi: %(phi)s deg, omega: %(sense)s}
loads: {F: {on: 3, at: C, size: %(size)s N, direction: %(way)s deg}, M_1: {on: 1, size: "?"}}
"""
CAM = """
frame: {A: [0 mm, 0 mm], C: [118 mm, 26 mm]}
links: {1: {AO: %(e)s mm, disc: O, radius: 48 mm}, 2: {CE: 108 mm, disc: E, radius: 11 mm, G: {along: CE, at: 150 mm}}}
joints: [1 touches 2 at K]
branch: [E left of OC]
input: {link: 1, phi: %(phi)s deg, omega: %(sense)s}
loads: {F: {on: 2, at: G, size: %(size)s N, direction: -106 deg}, M_1: {on: 1, size: "?"}}
"""
ROCKER = """
frame: {A: [0 mm, 0 mm], D: [0 mm, -200 mm]}
links: {1: {AB: %(a)s mm}, 2: {block: B}, 3: {slot: D, G: {along: D, at: 260 mm}}}
joints: [2 slides in 3]
input: {link: 1, phi: %(phi)s deg, omega: %(sense)s}
loads: {F: {on: 3, at: G, size: %(size)s N, direction: %(way)s deg}, M_1: {on: 1, size: "?"}}
"""
FRICTION = {
    SLIDER: "friction: {A: {rho: %.6f mm}, B: {rho: %.6f mm}, C: {rho: %.6f mm}, 3-4: {f: %.8f}}\n",
    FOUR_BAR: "friction: {A: {rho: %.6f mm}, B: {rho: %.6f mm}, C: {rho: %.6f mm}, D: {f: %.8f, r: 10 mm}}\n",
    CAM: "friction: {A: {rho: %.6f mm}, C: {rho: %.6f mm}, K: {f: %.8f}}\n",
    ROCKER: "friction: {A: {rho: %.6f mm}, B: {rho: %.6f mm}, D: {rho: %.6f mm}, 2-3: {f: %.8f}}\n",
}
kinds = st.sampled_from([SLIDER, FOUR_BAR, CAM, ROCKER])
data = st.fixed_dictionaries(
    {
        "a": st.integers(30, 60),
        "e": st.integers(8, 24),
        "phi": st.integers(0, 359),
        "sense": st.sampled_from(["ccw", "cw"]),
        "size": st.integers(50, 900),
        "way": st.sampled_from([0, 180, 35, -70, 130]),
    }
)


def problem(kind: str, given: dict[str, object], share: float) -> Problem:
    """A random loaded mechanism; `share` of a full friction of ρ = 3 mm and f = 0.12."""
    rho, f = 3.0 * share, 0.12 * share
    values = (rho,) * (FRICTION[kind].count("%") - 1) + (f,)
    text = "id: r\ntitle: r\n" + kind % given + (FRICTION[kind] % values if share else "")
    return loads(text)


def drawn(kind: str, given: dict[str, object], share: float) -> Construction:
    """The construction by the exact hand; positions that cannot be assembled, and locked ones, are left out."""
    text = problem(kind, given, share)
    try:
        return construct(scaled(text), hand("exact"))[0]
    except (AssemblyError, LockedError, NoSlipSenseError, EquilibriumError):
        assume(False)
        raise


@LAW
@given(kind=kinds, given=data)
def test_action_and_reaction_are_equal_and_opposite_on_one_line(kind: str, given: dict[str, object]) -> None:
    every = problem(kind, given, 1.0)
    assert every.loads is not None
    names = [
        n
        for key, n in quantities(every.mechanism, every.loads).items()
        if key.startswith("R_") and not key.endswith("_0")
    ]
    everything = Problem(
        id="r",
        title=every.title,
        subject=every.subject,
        loads=every.loads,
        asks=tuple(AskNamed(rel=n) for n in names),
        given=every.given,
    )
    try:
        readings = construct(everything, hand("exact"))[0].readings
    except (AssemblyError, EquilibriumError):
        assume(False)
    for key, one in readings.items():
        two = readings[f"R_{key[3]}{key[2]}"]
        assert one.vector is not None and two.vector is not None
        assert abs(one.vector + two.vector) <= 1e-9 * abs(one.vector)
        if one.acts and two.acts and abs(one.vector):
            off = ((one.vector / abs(one.vector)).conjugate() * (two.acts.point - one.acts.point)).imag
            assert abs(off) < 1e-9


@LAW
@given(kind=kinds, given=data)
def test_vanishing_friction_tends_to_the_frictionless_polygon(kind: str, given: dict[str, object]) -> None:
    none, little, less = (drawn(kind, given, share) for share in (0.0, 1e-4, 1e-5))
    for key, ideal in none.readings.items():
        far, near = (abs(_value(c.readings[key]) - _value(ideal)) for c in (little, less))
        assert near <= 0.2 * far + 1e-6 * max(1.0, abs(_value(ideal))), key


@LAW
@given(kind=kinds, given=data)
def test_more_friction_never_raises_the_efficiency_which_lies_between_nothing_and_one(
    kind: str, given: dict[str, object]
) -> None:
    some, more = (drawn(kind, given, share).readings["eta"].scalar for share in (0.4, 0.8))
    assert 0.0 <= more <= some + 1e-12 <= 1.0 + 1e-12


@LAW
@given(given=data, turn=st.integers(-170, 170))
def test_turning_the_paper_turns_the_reactions_and_nothing_else(given: dict[str, object], turn: int) -> None:
    there = _turned(given, 0)
    here = _turned(given, turn)
    for key, one in there.items():
        other = here[key]
        expected = _value(one) * (cmath.exp(1j * radians(turn)) if one.vector is not None else 1.0)
        assert abs(_value(other) - expected) <= 1e-9 * max(1.0, abs(expected)), key


def _turned(given: dict[str, object], turn: int) -> dict[str, Reading]:
    """The slider-crank as drawn on a paper turned by `turn` degrees."""
    text = f"""
id: r
title: r
frame: {{A: [0 mm, 0 mm], P: [{300 * cos(radians(turn)):.12f} mm, {300 * sin(radians(turn)):.12f} mm]}}
links: {{1: {{AB: {given["a"]} mm}}, 2: {{BC: 220 mm}}, 3: {{block: C}}}}
joints: [3 slides on AP]
branch: [C left of AB]
input: {{link: 1, phi: {given["phi"]} deg from AP, omega: {given["sense"]}}}
loads: {{F: {{on: 3, at: C, size: {given["size"]} N, direction: {180 + turn} deg}}, M_1: {{on: 1, size: "?"}}}}
friction: {{A: {{rho: 3 mm}}, B: {{rho: 2 mm}}, C: {{rho: 2 mm}}, 3-4: {{phi: 6 deg}}}}
"""
    try:
        return dict(construct(scaled(loads(text)), hand("exact"))[0].readings)
    except (AssemblyError, EquilibriumError):
        assume(False)
        raise


@LAW
@given(kind=kinds, given=data)
def test_another_force_scale_changes_millimetres_and_no_answer(kind: str, given: dict[str, object]) -> None:
    one = drawn(kind, given, 1.0)
    text = (
        "id: r\ntitle: r\nscales: {mu_F: 7 N/mm}\n"
        + kind % given
        + FRICTION[kind] % ((3.0,) * (FRICTION[kind].count("%") - 1) + (0.12,))
    )
    two, *_ = construct(loads(text), hand("exact"))
    for key, reading in one.readings.items():
        assert abs(_value(two.readings[key]) - _value(reading)) <= 1e-9 * max(1.0, abs(_value(reading))), key


def _value(reading: Reading) -> complex:
    return reading.vector if reading.vector is not None else complex(reading.scalar)


# -- the printed cases
# ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "case"),
    [("4-3a", "4-3a"), ("4-3b", "4-3b"), ("4-3c", "4-3c"), ("4-3d", "4-3d_cw"), ("4-4", "4-4"), ("4-7", "4-7")],
)
def test_the_exact_hand_draws_the_numbers_of_the_case(name: str, case: str) -> None:
    readings = construct(load(name), hand("exact"))[0].readings
    values = {
        key: complex(*value) if isinstance(value, list) else value for key, value in CASES[case]["values"].items()
    }
    shared = set(values) & set(readings)
    assert len(shared) >= 6
    for key in shared:
        assert abs(_value(readings[key]) - values[key]) <= 1e-9 * abs(values[key]), key


# -- a third party
# ----------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", few(["4-3a", "4-3b", "4-3c", "4-3d", "4-4", "4-5", "4-5-circles", "4-6", "4-7"], 4))
def test_the_exported_reactions_balance_every_link(name: str, tmp_path: Path) -> None:
    """Forces and moments of `solve --json`, and the loads as the YAML file writes them, summed here link by link."""
    source = _read(name)
    links = [str(n) for n in source["links"]]
    numbers = [*links, str(1 + max(map(int, links)))]
    letters = sorted({str(load["at"]) for load in source["loads"].values() if "at" in load})
    source["find"] = (
        [f"R_{i}{j}" for i in numbers for j in numbers if i != j and _touch(name, {i, j})]
        + list(source["loads"])
        + [f"p_{p}" for p in letters]
    )
    source["find"] = [key for key in source["find"] if source["loads"].get(key, {"size": "?"})["size"] == "?"]
    file = tmp_path / "all.yaml"
    with file.open("w", encoding="utf-8") as out:
        YAML(typ="safe").dump(source, out)
    answers = json.loads(CliRunner().invoke(app, ["solve", str(file), "--hand", "exact", "--json", "-"]).stdout)[
        "answers"
    ]

    def place(letter: str) -> complex:
        return _fixed(source, letter) if letter in source["frame"] else complex(*answers[f"p_{letter}"]["drawn_xy"])

    for link in links:
        total, moment, size = 0j, 0.0, 0.0
        for key, answer in answers.items():
            if key.startswith("R_") and key[3] == link:
                force, at = (
                    cmath.rect(answer["drawn"], radians(answer["direction_deg"] or 0.0)),
                    complex(*answer["point"]),
                )
                total, moment, size = total + force, moment + (at.conjugate() * force).imag, max(size, abs(force))
        for key, written in source["loads"].items():
            if str(written["on"]) != link:
                continue
            value = answers[key]["drawn"] if key in answers else float(str(written["size"]).split()[0])
            if "direction" in written:
                way, at = str(written["direction"]), place(written["at"])
                told = (
                    radians(float(way.split()[0]))
                    if "along" not in way
                    else cmath.phase(place(way[-1]) - place(way[-2]))
                )
                force = cmath.rect(value, told)
                total, moment = total + force, moment + (at.conjugate() * force).imag
            else:
                moment += value
        assert abs(total) <= 1e-9 * size, (link, total)
        assert abs(moment) <= 1e-9 * size * 0.1, (link, moment)


def _read(name: str) -> dict[str, Any]:
    """The problem file, laid on the one that it extends."""
    own = YAML(typ="safe").load((ROOT / "problems" / "ch4" / f"{name}.yaml").read_text(encoding="utf-8"))
    return _laid_on(_read(own.pop("extends")), own) if "extends" in own else own


def _laid_on(below: dict[str, Any], own: dict[str, Any]) -> dict[str, Any]:
    merged = dict(below)
    for key, value in own.items():
        merged[key] = (
            _laid_on(merged[key], value) if isinstance(value, dict) and isinstance(merged.get(key), dict) else value
        )
    return {key: value for key, value in merged.items() if value is not None}


def _fixed(source: dict[str, Any], letter: str) -> complex:
    x, y = (float(str(part).split()[0]) / 1000 for part in source["frame"][letter])
    return complex(x, y)


def _touch(name: str, pair: set[str]) -> bool:
    """Which links touch: a chain, closed by the frame; a cam touches its follower."""
    chains = {"4-3": "12 23 34 14", "4-6": "12 23 34 14"}
    chain = chains.get(name[:3], "12 23 13")
    return "".join(sorted(pair)) in chain.split()
