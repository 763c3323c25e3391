"""Wrong loads, friction, masses and device data: one clear error each, with file, line, path and remedy."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Any

import pytest
from pydantic import BaseModel

from tests.texts import SLIDER_CRANK
from vecpoly.devices.base import Angle, Device, Length, Ratio
from vecpoly.errors import ProblemFileError, UnknownNameError
from vecpoly.names import Named
from vecpoly.problem import by_data
from vecpoly.problem.load import loads
from vecpoly.words import Words

GOOD = (
    SLIDER_CRANK
    + """\
input: {link: 1, phi: 52 deg, omega: 10 rad/s ccw}
branch: [C right of B]
loads:
  F: {on: 3, at: C, size: 1000 N, direction: 180 deg}
  M_1: {on: 1, size: "?"}
friction:
  A: {rho: 6 mm}
  B: {f: 0.1, r: 20 mm}
  3-4: {phi: 8 deg}
masses:
  2: {mass: 3 kg, inertia: 0.02 kg*m^2, centre: {along: BC, at: 100 mm}}
  3: {mass: 2 kg}
find: [M_1, R_12]
"""
)


def refusal(text: str) -> str:
    """The message with which this text is refused."""
    with pytest.raises(ProblemFileError) as caught:
        loads(text, "p.yaml")
    return str(caught.value)


def test_the_good_file_is_good() -> None:
    loads(GOOD)


FORCE, FRICTION, MASSES = "F: {on: 3, at: C, size: 1000 N, direction: 180 deg}", "A: {rho: 6 mm}", "  3: {mass: 2 kg}"
CASES = {
    "no unknown load": (
        'size: "?"',
        "size: 20 N*m cw",
        "line 11",
        "loads",
        'no load is unknown, so nothing could balance the others; add e.g. M_1: {on: 1, size: "?"}',
    ),
    "two unknown loads": (
        "1000 N",
        '"?"',
        "line 11",
        "loads",
        "2 loads are unknown (F, M_1), but equilibrium finds one",
    ),
    "a load on no link": ("on: 3", "on: 33", "line 12", "loads.F.on", "link '33' does not exist; did you mean '3'?"),
    "a load on the frame": ("on: 3", "on: 4", "line 12", "loads.F.on", "link 4 is the frame"),
    "a point of another link": ("at: C", "at: B", "line 12", "loads.F.at", "point 'B' is not on link 3; known: C"),
    "a force without its point": (
        " at: C,",
        "",
        "line 12",
        "loads.F",
        "at which point of link 3 does the force act? write e.g. at: C",
    ),
    "a moment with a point": (
        'size: "?"}',
        'size: "?"}\n  M_2: {on: 2, at: B, size: 2 kg·m²/s² ccw}',
        "line 14",
        "loads.M_2.at",
        "acts on the whole link; leave out 'at'",
    ),
    "a force without direction": (
        ", direction: 180 deg",
        "",
        "line 12",
        "loads.F",
        "a force at C needs its direction, e.g. direction: 180 deg",
    ),
    "a force without point and direction": (
        FORCE,
        "F: {on: 3, size: 1000 N}",
        "line 12",
        "loads.F",
        "needs its point and direction",
    ),
    "a negative force": ("1000 N", "-1000 N", "line 12", "loads.F.size", "turn the direction by 180 deg instead"),
    "a force in kilograms": (
        "1000 N",
        "1000 kg",
        "line 12",
        "loads.F.size",
        "its unit 'kg' is a mass; write e.g. 1000 N",
    ),
    "a force that is no number": ("1000 N", "nan N", "line 12", "loads.F.size", "is not a finite number"),
    "a direction that is no number": ("180 deg", "nan deg", "line 12", "loads.F.direction", "is not a finite number"),
    "a load without size": (
        "size: 1000 N, ",
        "",
        "line 12",
        "loads.F",
        'the size is missing; write e.g. size: 1000 N, or size: "?"',
    ),
    "a load without link": ("on: 3, ", "", "line 12", "loads.F.on", "'on' is missing"),
    "a misspelt key of a load": (
        "direction:",
        "directoin:",
        "line 12",
        "loads.F.directoin",
        "did you mean 'direction'?",
    ),
    "a load of no list": (FORCE, "F: 1000 N", "line 12", "loads.F", "a mapping (key: value) is expected here"),
    "a strange role": (
        "180 deg}",
        "180 deg, role: pushing}",
        "line 12",
        "loads.F.role",
        "is not one of 'driving' or 'resisting'",
    ),
    "a strange name of a load": (
        "  F: {",
        "  force-1: {",
        "line 12",
        "loads.force-1",
        "is no name of a load; write F, Q, F_r or M_1",
    ),
    "a load that is called as a reaction": (
        "  F: {",
        "  R_12: {",
        "line 12",
        "loads.R_12",
        "is the name of a reaction",
    ),
    "negative f": (
        "f: 0.1",
        "f: -0.1",
        "line 16",
        "friction.B.f",
        "f = -0.1: a coefficient of friction is not negative",
    ),
    "f with a unit": (
        "f: 0.1",
        "f: 0.1 mm",
        "line 16",
        "friction.B.f",
        "'0.1 mm' is no pure number; write e.g. f: 0.1",
    ),
    "f that is no number": ("f: 0.1", "f: nan", "line 16", "friction.B.f", "is not a finite number"),
    "negative rho": (
        "rho: 6 mm",
        "rho: -6 mm",
        "line 15",
        "friction.A.rho",
        "'-6 mm' must not be negative; write e.g. 6 mm",
    ),
    "rho larger than the link": (
        "rho: 6 mm",
        "rho: 45 mm",
        "line 15",
        "friction.A.rho",
        "radius 45 mm is more than half of AB = 80 mm",
    ),
    "f r larger than the link": (
        "f: 0.1, r: 20 mm",
        "f: 0.9, r: 60 mm",
        "line 16",
        "friction.B.r",
        "radius 54 mm is more than half of BA = 80 mm",
    ),
    "f and rho": (
        "{rho: 6 mm}",
        "{rho: 6 mm, f: 0.1}",
        "line 15",
        "friction.A",
        "rho and f are both given, though rho = f r; leave out one",
    ),
    "f without the pin's radius": (", r: 20 mm", "", "line 16", "friction.B", "the radius of the pin is missing"),
    "an angle for a pin": (
        "{rho: 6 mm}",
        "{phi: 8 deg}",
        "line 15",
        "friction.A.phi",
        "'phi' is no datum of a pin, which takes rho, or f and r",
    ),
    "a radius for a slide": (
        "phi: 8 deg",
        "rho: 8 mm",
        "line 17",
        "friction.3-4.rho",
        "which takes phi, or f, or f and V",
    ),
    "a friction angle of 90 degrees": (
        "phi: 8 deg",
        "phi: 90 deg",
        "line 17",
        "friction.3-4.phi",
        "it must be less than 90 deg",
    ),
    "a negative friction angle": (
        "phi: 8 deg",
        "phi: -8 deg",
        "line 17",
        "friction.3-4.phi",
        "must not be negative; write e.g. 8 deg",
    ),
    "phi and f": ("phi: 8 deg", "phi: 8 deg, f: 0.1", "line 17", "friction.3-4", "phi and f are both given"),
    "a groove of more than 180 degrees": (
        "phi: 8 deg",
        "f: 0.1, V: 95 deg",
        "line 17",
        "friction.3-4.V",
        "V is half the angle of the groove",
    ),
    "friction of nothing": ("{phi: 8 deg}", "{}", "line 17", "friction.3-4", "how large is the friction?"),
    "friction on no pin": (
        "  A: {rho",
        "  D: {rho",
        "line 15",
        "friction.D",
        "'D' is neither a pin nor a contact nor a sliding pair such as 3-4; known: A, B, C",
    ),
    "friction at a point that is no pin": (
        "2: {BC: 230 mm}",
        "2: {BC: 230 mm, E: {along: BC, at: 9 mm}}\n",
        "line 16",
        "friction.E",
        "point E is no pin, since only link 2 carries it; pins: A, B, C",
    ),
    "friction on no slide": (
        "3-4:",
        "1-4:",
        "line 17",
        "friction.1-4",
        "links 1 and 4 form no sliding pair; did you mean '3-4'?",
    ),
    "a misspelt key of friction": ("{rho: 6 mm}", "{rhoo: 6 mm}", "line 15", "friction.A.rhoo", "did you mean 'rho'?"),
    "zero mass": ("mass: 3 kg", "mass: 0 kg", "line 19", "masses.2.mass", "must be greater than zero; write e.g. 3 kg"),
    "negative inertia": (
        "0.02 kg",
        "-0.02 kg",
        "line 19",
        "masses.2.inertia",
        "must not be negative; write e.g. 0.02 kg*m^2",
    ),
    "a mass in newtons": ("mass: 3 kg", "mass: 3 N", "line 19", "masses.2.mass", "its unit 'N' is a force"),
    "no mass": ("mass: 3 kg, ", "", "line 19", "masses.2", "the mass is missing"),
    "a centre on another link": (
        "centre: {along: BC, at: 100 mm}",
        "centre: A",
        "line 19",
        "masses.2.centre",
        "point 'A' is not on link 2; known: B, C",
    ),
    "a centre along another link": (
        "along: BC",
        "along: AB",
        "line 19",
        "masses.2.centre",
        "point 'A' is not on link 2",
    ),
    "a centre that is not told": (
        ", centre: {along: BC, at: 100 mm}",
        "",
        "line 19",
        "masses.2.centre",
        "where is the centre of mass of link 2? write e.g. centre: {along: BC, at: 100 mm}",
    ),
    "the mass of the frame": (
        MASSES,
        "  4: {mass: 2 kg}",
        "line 20",
        "masses.4",
        "link 4 is the frame: its mass has no effect",
    ),
    "the mass of no link": (MASSES, "  7: {mass: 2 kg}", "line 20", "masses.7", "link '7' does not exist"),
    "a bar of a block": (
        MASSES,
        "  3: {rod: {diameter: 9 mm, density: 7800 kg/m^3}}",
        "line 20",
        "masses.3.rod",
        "has only the point C and so no length",
    ),
    "a bar and a mass": (
        "mass: 3 kg,",
        "mass: 3 kg, rod: {diameter: 9 mm, density: 7800 kg/m^3},",
        "line 19",
        "masses.2",
        "leave out mass and inertia and centre, or rod",
    ),
    "a misspelt key of a bar": (
        MASSES,
        "  1: {rod: {diametre: 9 mm, density: 7800 kg/m^3}}",
        "line 20",
        "masses.1.rod.diametre",
        "did you mean 'diameter'?",
    ),
    "a density in kilograms": (
        MASSES,
        "  1: {rod: {diameter: 9 mm, density: 7800 kg}}",
        "line 20",
        "masses.1.rod.density",
        "write e.g. 7800 kg/m^3",
    ),
    "a bar of no length": (
        MASSES,
        "  1: {rod: {diameter: 9 mm, density: 7800 kg/m^3, along: BB}}",
        "line 20",
        "masses.1.rod.along",
        "a bar from B to itself",
    ),
    "neither yes nor no": ("find:", "weight: maybe\nfind:", "line 21", "weight", "'maybe' is neither yes nor no"),
    "a key of no load": (
        "find: [M_1",
        "find: [M_2",
        "line 21",
        "find[0]",
        "'M_2' is no quantity of these loads; did you mean",
    ),
    "a reaction of links that do not touch": (
        "R_12]",
        "R_13]",
        "line 21",
        "find[1]",
        "no joint joins links 1 and 3, which do not act on each other; on link 3 act",
    ),
    "a printed force in metres": (
        "find:",
        "printed: [{symbol: R_12, value: 3 m}]\nfind:",
        "line 21",
        "printed[0]",
        "is a length; write e.g. 1000 N",
    ),
    "a printed efficiency in newtons": (
        "find:",
        "printed: [{symbol: eta, value: 3 N}]\nfind:",
        "line 21",
        "printed[0].value",
        "write e.g. 0.85 (85 %)",
    ),
    "a bad force scale": ("find:", "scales: {mu_F: 3 mm}\nfind:", "line 21", "scales.mu_F", "write e.g. 10 N/mm"),
    "a sense alone, with masses": (
        "omega: 10 rad/s ccw",
        "omega: ccw",
        "line 9",
        "input",
        "inertia forces need the angular velocity as a number",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_each_fault_is_told_with_line_path_and_remedy(case: str) -> None:
    old, new, line, path, text = CASES[case]
    assert old in GOOD
    message = refusal(
        GOOD.replace(old, new).replace("A: {rho", "E: {rho")
        if case.startswith("friction at a point")
        else GOOD.replace(old, new)
    )
    assert message.count("\n") == 0, message
    assert message.startswith(f"p.yaml, {line}, column ")
    assert f": {path}: " in message
    assert text in message


BARE = GOOD[: GOOD.index("loads:")]


def test_a_motion_of_known_sense_only_has_no_velocities() -> None:
    message = refusal(BARE.replace("10 rad/s ccw", "cw") + "find: [p_C, v_C]\n")
    assert "find[1]: v_C needs the angular velocity as a number" in message


def test_forces_are_not_asked_for_without_loads() -> None:
    assert "find[0]: 'R_12' needs loads; say under 'loads' what acts" in refusal(BARE + "find: [R_12]\n")


def test_friction_without_loads_lacks_the_unknown() -> None:
    assert "line 11, column 1: friction: no load is unknown" in refusal(BARE + "friction: {A: {rho: 6 mm}}\n")


@pytest.mark.parametrize(
    "acting",
    [
        '{M_1: {on: 1, size: "?"}}',
        '{F: {on: 3, at: C, size: 0 N, direction: 0 deg}, M_1: {on: 1, size: "?"}}',
        '{M_1: {on: 1, size: "?"}}\nmasses: {3: {mass: 2 kg}}\ninertia: no',
    ],
)
def test_where_nothing_acts_everything_is_zero_and_that_is_told(acting: str) -> None:
    message = refusal(BARE + f"loads: {acting}\n")
    assert (
        "p.yaml, line 11, column 1: loads: nothing acts on the mechanism but the unknown load: it and all "
        "reactions are zero" in message
    )


ROLLING = """\
id: r
title: test
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {gear: B, radius: 20 mm}}
joints: [2 rolls on circle about A of 40 mm at H]
input: {link: 1, phi: 50 deg, omega: ccw}
loads: {Q: {on: 2, at: B, size: 10 N, direction: 0 deg}, M_1: {on: 1, size: "?"}}
"""


@pytest.mark.parametrize("entry", ["H: {f: 0.1}", "2-3: {f: 0.1}"])
def test_rolling_links_lose_nothing_to_friction(entry: str) -> None:
    loads(ROLLING)
    message = refusal(ROLLING + f"friction: {{{entry}}}\n")
    assert f"line 8, column 12: friction.{entry.split(':')[0]}: " in message
    assert "without sliding: no friction is lost there; leave the entry out" in message


def test_two_faults_are_told_together() -> None:
    message = refusal(GOOD.replace("on: 3", "on: 9").replace("mass: 3 kg", "mass: 0 kg"))
    assert [line.split(": ")[1] for line in message.splitlines()] == ["loads.F.on", "masses.2.mass"]


class Ramp(BaseModel):
    """What a device is, without being entered among the devices on file: a body on an incline."""

    model_config = Device.model_config
    alpha: Angle
    f: Ratio
    b: Length

    def quantities(self) -> tuple[Named, ...]:
        return (Named("phi", "φ", "deg"), Named("eta", "η", ""))

    def given(self) -> tuple[tuple[str, str], ...]:
        return (("α", self.alpha.text), ("f", self.f.text))

    def told(self) -> tuple[Words, ...]:
        return ()

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        return ()


RAMP = """\
id: r
title: test
device: test-ramp
data: {alpha: 24 deg, f: 0.2, b: 30 mm}
find: [eta]
"""


@pytest.fixture
def ramp(monkeypatch: pytest.MonkeyPatch) -> None:
    """The ramp is the one device on file."""
    changed: Any = {"kinds": lambda: {"test-ramp": Ramp}, "kind_of": base_kind_of}
    ramps = replace(by_data.SORTS[0], **changed)
    monkeypatch.setattr(by_data, "SORTS", (ramps,))


def base_kind_of(name: str) -> type[Ramp]:
    """As `devices.base.kind_of`, for the one device."""
    if name != "test-ramp":
        raise UnknownNameError(f"no device '{name}'")
    return Ramp


DEVICE = {
    "an unknown device": (
        "test-ramp",
        "test-rampe",
        "line 3",
        "device",
        "there is no device 'test-rampe'; did you mean 'test-ramp'?",
    ),
    "loads": (
        "find",
        "loads: {F: {on: 1, size: 3 N}}\nfind",
        "line 5",
        "loads",
        "'loads' belongs to a mechanism; all that is given of a device stands in 'data'",
    ),
    "links": ("find", "links: {1: {AB: 3 mm}}\nfind", "line 5", "links", "'links' belongs to a mechanism"),
    "an unknown datum": ("alpha:", "alfa:", "line 4", "data.alfa", "unknown key 'alfa'; did you mean 'alpha'?"),
    "a missing datum": (", f: 0.2", "", "line 4", "data.f", "'f' is missing"),
    "a datum without unit": (
        "24 deg",
        "24",
        "line 4",
        "data.alpha",
        "has no unit; an angle is needed: write e.g. 24 deg",
    ),
    "a datum of the wrong kind": ("24 deg", "24 mm", "line 4", "data.alpha", "is a length; write e.g. 60 deg"),
    "a datum below zero": ("30 mm", "-30 mm", "line 4", "data.b", "must be greater than zero"),
    "a negative ratio": ("f: 0.2", "f: -0.2", "line 4", "data.f", "must not be negative"),
    "not a number": ("f: 0.2", "f: nan", "line 4", "data.f", "is not a finite number"),
    "a value for the data": (
        "data: {alpha: 24 deg, f: 0.2, b: 30 mm}",
        "data: 3",
        "line 4",
        "data",
        "a mapping (key: value) is expected here",
    ),
    "an unknown question": (
        "[eta]",
        "[etta]",
        "line 5",
        "find[0]",
        "'etta' is nothing that this device is asked for; did you mean 'eta'?",
    ),
    "a misspelt key": ("find", "fidn", "line 5", "fidn", "unknown key 'fidn'; did you mean 'find'?"),
}


@pytest.mark.usefixtures("ramp")
@pytest.mark.parametrize("case", DEVICE)
def test_faults_of_a_device_are_told_in_the_same_way(case: str) -> None:
    loads(RAMP)
    old, new, line, path, text = DEVICE[case]
    message = refusal(RAMP.replace(old, new))
    assert message.count("\n") == 0, message
    assert message.startswith(f"p.yaml, {line}, column ")
    assert f": {path}: " in message
    assert text in message


SKETCH = """\
id: s
title: four bars
device: structure
data:
  joints:
    A: R(0, 1) at (0, 0)
    B: R(1, 2) at (0, 10)
    C: R(2, 3) at (40, 10)
    D: R(3, 0) at (40, 0)
  drivers: [1]
"""


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ("C: R(2, 3) at (40, 10)", "C: R(2, 3) at (1e300, 10)", "'(1e300, 10)' is no place on paper"),
        ("C: R(2, 3) at (40, 10)", "C: R(2, 3) at (40, nan)", "'(40, nan)' is no place on paper"),
        ("C: R(2, 3) at (40, 10)", "C: P(2, 3) at (40, 10) along inf deg", "'inf deg' is no direction"),
        ("C: R(2, 3) at (40, 10)", "C: P(2, 3) at (40, 10) along nan deg", "'nan deg' is no direction"),
    ],
)
def test_a_place_or_direction_beyond_all_paper_is_told(old: str, new: str, text: str) -> None:
    loads(SKETCH)
    assert old in SKETCH and text in refusal(SKETCH.replace(old, new))


def test_data_without_a_device_are_told() -> None:
    message = refusal(BARE + "data: {alpha: 24 deg}\n")
    assert "line 11, column 1: data: 'data' belongs to a device; write e.g. device: " in message
