"""The claim that every key of the manual does something:
changed or left out, the solution differs, or the file is refused, or a note is told."""

from __future__ import annotations

from itertools import zip_longest

import pytest
from pydantic import BaseModel

from tests.lawful import CHANGED, EVERY
from tests.laws import few
from tests.problem.effects import effect, effects
from vecpoly.problem.load import load
from vecpoly.problem.schema.models import (
    DeviceSpec,
    FindSpec,
    FrictionSpec,
    GateSpec,
    InputSpec,
    LoadSpec,
    MassSpec,
    PrintedSpec,
    ProblemSpec,
    RodSpec,
    ScalesSpec,
    SheetSpec,
    TableSpec,
    TargetSpec,
)
from vecpoly.problem.schema.running import CounterweightSpec

HEART, ROCKER, TRAIN = (load(name).text for name in ("cam-heart", "cam-rocker", "train-ring"))
ENGINE, RUN, WEIGHED = (load(name).text for name in ("7-5", "motor-run-up", "balance-four-bar"))
DISC, DALBY, BOLTED = (load(name).text for name in ("6-2", "rotor-dalby", "rotor-bolt-circle"))
IN_PLACE, TWO_RUNS, SINGLE = (load(name).text for name in ("field-influence", "field-two-runs", "engine-single"))
BASE = """\
id: t
title: test
source: here
statement: a four-bar
explain: [which kind]
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 100 mm, E: {BE: 60 mm, CE: 70 mm, side: left of BC}}
  3: {CD: 80 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw, alpha: 3 rad/s^2}
branch: [C above AD]
loads: {M_1: {on: 1, size: "?"}, F: {on: 3, at: C, size: 100 N, direction: 180 deg}}
friction: {A: {rho: 2 mm}}
masses: {2: {mass: 3 kg, inertia: 0.02 kg*m^2, centre: E}, 3: {rod: {diameter: 20 mm, density: 7800 kg/m^3, along: CD}}}
weight: yes
inertia: no
scales: {mu_l: 0.002 m/mm, mu_v: 0.01 (m/s)/mm, mu_F: 10 N/mm}
find: [v_C, M_1, M_1_0]
printed: [{symbol: v_C, value: 20 mm, scale: 0.01 (m/s)/mm, direction: 150 deg, kind: graphical, note: read off}]
errata: [a misprint]
sheet: {orientation: landscape}
"""
TARGET = "target: {point: E, through: [[20 mm, 60 mm], [35 mm, 62 mm], [5 mm, 30 mm]], closed: yes}\n"
TRACED = BASE.replace("find:", f"{TARGET}find:")
SLIDE = (
    BASE.replace("  3: {CD: 80 mm}", "  3: {block: C}")
    .replace(", D: [120 mm, 0 mm]", "")
    .replace("branch: [C above AD]", "joints: [3 slides on y = 0 mm]\nbranch: [C right of B]")
    .replace("friction: {A: {rho: 2 mm}}", "friction: {A: {rho: 2 mm}, 3-4: {f: 0.1, V: 50 deg}}")
    .replace("3: {rod: {diameter: 20 mm, density: 7800 kg/m^3, along: CD}}", "3: {mass: 1 kg}")
)
CENTRES = BASE.partition("loads:")[0] + "method: centres\nfind: [omega_3, {point: E2, on: 2, slowest: BC}]\n"
CURVED = BASE.partition("loads:")[0].replace("phi: 60 deg", "phi: 25 deg") + (
    "method: curvature\nconstruction: hartmann\nfind: [rho_E, {centrodes: 2, positions: 8, over: [20 deg, 30 deg]}]\n"
)
DRIVEN = (
    SLIDE.replace(
        "input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw, alpha: 3 rad/s^2}",
        "input: {link: 3, s: 110 mm, v: 0.5 m/s, a: 1 m/s^2}",
    )
    .replace("C right of B", "B above AC")
    .replace("inertia: no", "inertia: yes")
)
CYLINDER = """\
id: t
title: test
frame: {A: [0 mm, 0 mm], D: [450 mm, -350 mm]}
links: {1: {AC: 1150 mm}, 2: {cylinder: D}, 3: {piston: C}}
joints: [3 slides in 2]
input: {cylinder: 2-3, length: 900 mm, v: 0.12 m/s, a: 0 m/s^2}
branch: [C left of AD]
loads: {F_c: {cylinder: 2-3, size: "?"}, Q: {on: 1, at: C, size: 100 N, direction: -90 deg}}
find: [omega_1, F_c]
"""
MOTOR = (
    BASE.partition("loads:")[0]
    .replace("{link: 1, phi: 60 deg", "{link: 3, on: 2, phi: 100 deg")
    .replace("[C above AD]", "[B above AD]")
    + "find: [omega_3]\n"
)

PRESS = (
    BASE.partition("loads:")[0].replace(", alpha: 3 rad/s^2", "")
    + "loads: {M_r: {on: 3, size: 9 N*m cw, during: [60 deg, 150 deg]}, M_d: {on: 1, size: constant}}\n"
    + "masses: {3: {mass: 2 kg, inertia: 0.01 kg*m^2, centre: C}}\n"
    + "machine: {n: 60 r/min, delta: 0.05}\nfind: [dW_max, J_F]\n"
)

CHANGES: dict[str, tuple[str, str, str]] = {  # key: the file, what stands there, what stands there instead
    "id": (BASE, "id: t\n", "id: u\n"),
    "title": (BASE, "title: test", "title: other"),
    "source": (BASE, "source: here", "source: there"),
    "statement": (BASE, "a four-bar", "another"),
    "explain": (BASE, "which kind", "which kinds"),
    "frame": (BASE, "[120 mm, 0 mm]", "[118 mm, 0 mm]"),
    "links": (BASE, "AB: 40 mm", "AB: 41 mm"),
    "joints": (SLIDE, "y = 0 mm", "y = 5 mm"),
    "input": (BASE, "60 deg", "61 deg"),
    "branch": (BASE, "C above AD", "C below AD"),
    "loads": (BASE, "size: 100 N", "size: 110 N"),
    "friction": (BASE, "rho: 2 mm", "rho: 3 mm"),
    "masses": (BASE, "mass: 3 kg", "mass: 4 kg"),
    "weight": (BASE, "weight: yes", "weight: no"),
    "inertia": (BASE, "inertia: no", "inertia: yes"),
    "counterweights": (WEIGHED, "1: {r: 60 mm}", "1: {r: 70 mm}"),
    "counterweight.r": (WEIGHED, "3: {r: 100 mm}", "3: {r: 80 mm}"),
    "machine": (PRESS, "n: 60 r/min", "n: 90 r/min"),
    "scales": (BASE, "0.002 m/mm", "0.0025 m/mm"),
    "find": (BASE, "[v_C, ", "[v_E, "),
    "printed": (BASE, "value: 20 mm", "value: 40 mm"),
    "errata": (BASE, "a misprint", "two misprints"),
    "sheet": (BASE, "landscape", "portrait"),
    "method": (CENTRES, "method: centres", "method: polygons"),
    "construction": (CURVED, "hartmann", "euler-savary"),
    "guesses": (BASE, "find:", "guesses: {C: [1 mm, 2 mm]}\nfind:"),
    "pins": (BASE, "find:", "pins: {C: 3}\nfind:"),
    "tables": (BASE, "find:", "tables: [none.csv]\nfind:"),
    "extends": (BASE, "id: t\n", "id: t\nextends: none\n"),
    "input.link": (BASE, "link: 1", "link: 3"),
    "input.phi": (BASE, "phi: 60 deg", "phi: 61 deg"),
    "input.omega": (BASE, "10 rad/s", "11 rad/s"),
    "input.alpha": (BASE, "3 rad/s^2", "4 rad/s^2"),
    "input.s": (DRIVEN, "110 mm", "111 mm"),
    "input.v": (DRIVEN, "0.5 m/s", "0.6 m/s"),
    "input.a": (DRIVEN, "1 m/s^2", "2 m/s^2"),
    "input.cylinder": (CYLINDER, "input: {cylinder: 2-3", "input: {cylinder: 1-3"),
    "input.length": (CYLINDER, "900 mm", "910 mm"),
    "input.on": (MOTOR, "on: 2", "on: 1"),
    "load.cylinder": (CYLINDER, "F_c: {cylinder: 2-3", "F_c: {cylinder: 1-3"),
    "load.on": (BASE, "on: 3, at: C", "on: 2, at: C"),
    "load.at": (BASE, "at: C", "at: D"),
    "load.size": (BASE, "100 N", "200 N"),
    "load.direction": (BASE, "180 deg", "170 deg"),
    **CHANGED,
    "load.role": (BASE, 'size: "?"', 'size: "?", role: resisting'),
    "friction.rho": (BASE, "rho: 2 mm", "rho: 4 mm"),
    "friction.f": (SLIDE, "f: 0.1", "f: 0.2"),
    "friction.f_v": (SLIDE, "f: 0.1", "f_v: 0.2"),
    "friction.V": (SLIDE, "V: 50 deg", "V: 60 deg"),
    "friction.r": (BASE, "rho: 2 mm", "f: 0.1, r: 30 mm"),
    "friction.phi": (SLIDE, "f: 0.1, V: 50 deg", "phi: 8 deg"),
    "mass.mass": (BASE, "mass: 3 kg", "mass: 5 kg"),
    "mass.inertia": (BASE.replace("inertia: no", "inertia: yes"), "0.02 kg", "0.05 kg"),
    "mass.centre": (BASE, "centre: E", "centre: B"),
    "mass.rod": (BASE, "rod: {diameter: 20 mm, density: 7800 kg/m^3, along: CD}", "mass: 1 kg, centre: C"),
    "rod.diameter": (BASE, "diameter: 20 mm", "diameter: 30 mm"),
    "rod.density": (BASE, "7800", "2700"),
    "rod.along": (BASE, "along: CD", "along: DD"),
    "scales.mu_l": (BASE, "0.002 m/mm", "0.003 m/mm"),
    "scales.mu_v": (BASE, "0.01 (m/s)/mm, mu_F", "0.02 (m/s)/mm, mu_F"),
    "scales.mu_F": (BASE, "10 N/mm", "20 N/mm"),
    "scales.mu_a": (BASE, "mu_F: 10", "mu_a: 1 (m/s^2)/mm, mu_F: 10"),
    "scales.mu_s": (HEART, "device:", "scales: {mu_s: 0.002 m/mm}\ndevice:"),
    "scales.mu_phi": (HEART, "device:", "scales: {mu_phi: 0.08 rad/mm}\ndevice:"),
    "scales.mu_psi": (ROCKER, "device:", "scales: {mu_psi: 0.02 rad/mm}\ndevice:"),
    "scales.mu_omega": (TRAIN, "device:", "scales: {mu_omega: 0.5 (rad/s)/mm}\ndevice:"),
    "scales.mu_M": (ENGINE, "device:", "scales: {mu_M: 4 N*m/mm}\ndevice:"),
    "scales.mu_J": (PRESS, "machine:", "scales: {mu_J: 0.01 kg*m^2/mm}\nmachine:"),
    "scales.mu_E": (ENGINE, "device:", "scales: {mu_E: 2 J/mm}\ndevice:"),
    "scales.mu_y": (RUN, "device:", "scales: {mu_y: 0.002 (1/(N*m))/mm}\ndevice:"),
    "scales.mu_t": (RUN, "device:", "scales: {mu_t: 0.1 s/mm}\ndevice:"),
    "scales.mu_r": (DISC, "device:", "scales: {mu_r: 0.01 m/mm}\ndevice:"),
    "scales.mu_W": (DISC, "device:", "scales: {mu_W: 0.05 kg*m/mm}\ndevice:"),
    "scales.mu_Wl": (DALBY, "device:", "scales: {mu_Wl: 0.05 kg*m^2/mm}\ndevice:"),
    "scales.mu_U": (BOLTED, "device:", "scales: {mu_U: 25 g*mm/mm}\ndevice:"),
    "scales.mu_A": (IN_PLACE, "device:", "scales: {mu_A: 0.2 um/mm}\ndevice:"),
    "scales.mu_V": (TWO_RUNS, "device:", "scales: {mu_V: 0.2 (mm/s)/mm}\ndevice:"),
    "scales.mu_P": (SINGLE, "device:", "scales: {mu_P: 80 N/mm}\ndevice:"),
    "find.point": (CENTRES, "point: E2", "point: G2"),
    "find.on": (CENTRES, "on: 2", "on: 3"),
    "find.slowest": (CENTRES, "slowest: BC", "slowest: CE"),
    "find.centrodes": (CURVED, ", {centrodes: 2, positions: 8, over: [20 deg, 30 deg]}", ""),
    "find.positions": (CURVED, "positions: 8", "positions: 9"),
    "find.over": (CURVED, "over: [20 deg", "over: [21 deg"),
    "find.velocity": (CENTRES, "slowest: BC", "velocity: 0"),
    "find.acceleration": (CENTRES, "slowest: BC", "acceleration: 0"),
    "find.coriolis": (BASE, "[v_C, ", "[{coriolis: C3C2}, "),
    "printed.symbol": (BASE, "symbol: v_C", "symbol: v_E"),
    "printed.value": (BASE, "20 mm, scale", "30 mm, scale"),
    "printed.scale": (BASE, "scale: 0.01", "scale: 0.02"),
    "printed.direction": (BASE, "direction: 150 deg", "direction: 10 deg"),
    "printed.kind": (BASE, "kind: graphical", "kind: calculated"),
    "printed.figures": (BASE, "kind: graphical", "kind: graphical, figures: 2"),
    "printed.lost": (BASE, "kind: graphical", "kind: graphical, lost: yes"),
    "printed.note": (BASE, "note: read off", "note: other"),
    "vary": (BASE, "find:", "vary: {AB: 40 mm .. 44 mm by 1 mm}\nfind:"),
    "gate": (BASE, "find:", "gate: {alike: no}\nfind:"),
    **{
        f"gate.{key}": (BASE, "find:", f"gate: {{{key}: {value}}}\nfind:")
        for key, value in {
            "vectors": "12 mm",
            "meetings": "15 deg",
            "dead_point": "5 deg",
            "deviation": "12 %",
            "slips": "0",
            "apart": "2",
            "alike": "no",
        }.items()
    },
    "target": (BASE, "find:", f"{TARGET}find:"),
    "target.point": (TRACED, "point: E", "point: C"),
    "target.through": (TRACED, "[20 mm, 60 mm]", "[20 mm, 80 mm]"),
    "target.closed": (TRACED, "closed: yes", "closed: no"),
    "sheet.orientation": (BASE, "orientation: landscape", "orientation: portrait"),
    "sheet.format": (BASE, "orientation: landscape", "orientation: landscape, format: letter"),
}
SPECS: dict[str, type[BaseModel]] = {
    "": ProblemSpec,
    "input": InputSpec,
    "load": LoadSpec,
    "table": TableSpec,
    "friction": FrictionSpec,
    "mass": MassSpec,
    "rod": RodSpec,
    "scales": ScalesSpec,
    "find": FindSpec,
    "printed": PrintedSpec,
    "sheet": SheetSpec,
    "gate": GateSpec,
    "target": TargetSpec,
    "counterweight": CounterweightSpec,
}


@pytest.mark.parametrize("key", few(tuple(CHANGES), 4))
def test_a_key_that_is_changed_changes_something(key: str) -> None:
    text, old, new = CHANGES[key]
    assert text.count(old) >= 1
    assert any(one != other for one, other in zip_longest(effects(text.replace(old, new, 1)), effect(text)))


def test_every_key_of_the_schema_is_tried() -> None:
    keys = {f"{name}.{field}".lstrip(".") for name, spec in SPECS.items() for field in spec.model_fields}
    assert keys == set(CHANGES)


@pytest.mark.parametrize("text", few([BASE, SLIDE, DRIVEN, CENTRES, CURVED, CYLINDER, MOTOR, EVERY, TRACED], 3))
def test_the_files_that_are_changed_are_good(text: str) -> None:
    assert len(found := [*effect(text)]) == 5, found


def test_the_keys_of_a_device_are_those_of_a_problem_and_its_data() -> None:
    assert set(DeviceSpec.model_fields) - set(ProblemSpec.model_fields) == {"device", "data"}
    assert load("5-1").device


@pytest.mark.parametrize("text", [BASE, CENTRES])
def test_a_comment_changes_nothing(text: str) -> None:
    assert [*effect(text)] == [*effect(text + "# nothing\n")]
