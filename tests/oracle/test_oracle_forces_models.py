"""Loaded mechanisms of chapter 4, set up by hand for the tests of the oracle of forces,
and a check that shares nothing with it."""

from __future__ import annotations

import json
from cmath import exp
from math import pi, radians
from pathlib import Path
from typing import Any

import numpy as np

from tests.oracle.test_oracle_models import guided, link, pins, says
from vecpoly.mechanism.asked.forces import pairs
from vecpoly.mechanism.loads import GRAVITY, Force, Friction, Load, Loads, Mass, Moment
from vecpoly.mechanism.model import FRAME, Circle, Contact, Drive, Mechanism, Rack, Side
from vecpoly.oracle import solve
from vecpoly.oracle.forces import Forces

CASES: dict[str, dict[str, Any]] = json.loads(
    (Path(__file__).resolve().parents[1] / "data" / "ch4.json").read_text(encoding="utf-8")
)

PUSH = Force(name="F", link="3", point="C", direction=np.pi, size=1000.0)
CRANK = Moment(name="M_1", link="1")
ROUGH = Friction(pins={"A": 0.006, "B": 0.005, "C": 0.004}, slides={("3", "0"): radians(8.0)})


def turned(angle: float) -> complex:
    return complex(exp(1j * angle))


def slider_crank(
    ab: float, bc: float, guide_y: float, phi: float, rate: float = 1.0, *, tilt: float = 0.0, **coupler: complex
) -> Mechanism:
    """A at the origin, crank at phi (rad) from the guide's direction, which is turned by `tilt` (rad);
    C ahead of U-V."""
    u = turned(tilt)
    joints = pins("A 0 1, B 1 2, C 2 3") + guided("0", "3", "C", origin=1j * guide_y * u, direction=tilt * 180 / pi)
    return Mechanism(
        frame={"A": 0j, "U": -1j * ab * u, "V": 1j * ab * u},
        links=(link("1", A=0, B=ab), link("2", B=0, C=bc, **coupler), link("3", C=0)),
        joints=joints,
        drives=(Drive(link="1", position=phi + tilt, rate=rate),),
        branches=says("C right U V"),
    )


def crank(degrees: float = 52.0, rate: float = 1.0) -> Mechanism:
    """The slider-crank of 4-3."""
    return slider_crank(0.08, 0.23, -0.015, radians(degrees), rate)


def four_bar(
    ab: float, bc: float, cd: float, d: complex, phi: float, rate: float = 1.0, *, tilt: float = 0.0, **coupler: complex
) -> Mechanism:
    """C on the left of B-D; everything turned by `tilt` (rad)."""
    return Mechanism(
        frame={"A": 0j, "D": d * turned(tilt)},
        links=(link("1", A=0, B=ab), link("2", B=0, C=bc, **coupler), link("3", D=0, C=cd)),
        joints=pins("A 0 1, B 1 2, C 2 3, D 3 0"),
        drives=(Drive(link="1", position=phi + tilt, rate=rate),),
        branches=says("C left B D"),
    )


def disc_cam(
    e: float,
    disc: float,
    pivot: complex,
    ce: float,
    tip: float,
    arm: float,
    phi: float,
    rate: float,
    side: str,
    *,
    tilt: float = 0.0,
    at: str = "K",
) -> Mechanism:
    """Eccentric disc 1 about A, round-tipped lever 2 about C with G on it;
    a bar between O and E stands for the contact."""
    contact = Contact(
        point=at,
        disc=Circle(link="1", centre="O", radius=disc),
        on=Circle(link="2", centre="E", radius=tip),
        substitute="OE",
    )
    return Mechanism(
        frame={"A": 0j, "P": pivot * turned(tilt)},
        links=(link("1", A=0, O=e), link("2", P=0, E=ce, G=arm), link("OE", O=0, E=disc + tip)),
        joints=pins("A 0 1, P 0 2, O 1 OE, E OE 2"),
        drives=(Drive(link="1", position=phi + tilt, rate=rate),),
        branches=says(f"E {side} O P"),
        contacts=(contact,),
    )


def flat_lever(e: float, disc: float, pivot: complex, face: float, arm: float, phi: float, rate: float) -> Mechanism:
    """Eccentric disc 1 about A under the flat face of lever 2,
    which lies `face` to the left of its own x axis through C."""
    line = Rack(link="2", origin=1j * face, direction=0.0)
    contact = Contact(
        point="B", disc=Circle(link="1", centre="O", radius=disc), on=line, substitute="block", side=Side.RIGHT
    )
    return Mechanism(
        frame={"A": 0j, "C": pivot},
        links=(link("1", A=0, O=e), link("2", C=0, G=arm), link("block", O=0)),
        joints=pins("A 0 1, C 0 2, O 1 block") + guided("2", "block", "O", origin=1j * (face - disc)),
        drives=(Drive(link="1", position=phi, rate=rate),),
        contacts=(contact,),
    )


def slotted_rocker() -> tuple[Mechanism, Loads]:
    """4-6: lever 1 with F at G, block 2 pinned at B in the slot of rocker 3 about D, which M_r holds back."""
    mech = Mechanism(
        frame={"A": 0j, "D": 0.055 - 0.12j},
        links=(link("1", A=0, B=0.085, G=0.15), link("2", B=0), link("3", D=0)),
        joints=pins("A 0 1, B 1 2, D 3 0") + guided("3", "2", "B", through="D"),
        drives=(Drive(link="1", position=radians(76.0), rate=1.0),),
    )
    return mech, Loads(
        forces=(Force(name="F", link="1", point="G", direction=radians(158.0), size=400.0),),
        moments=(Moment(name="M_r", link="3"),),
        friction=Friction(pins={"A": 0.006, "B": 0.005, "D": 0.007}, slides={("2", "3"): radians(9.0)}),
    )


def case(name: str) -> tuple[Mechanism, Loads]:
    """Mechanism and loads of an exercise with answers."""
    given = CASES[name]["given"]
    rate = 1.0 if given["omega1_sense"] == "ccw" else -1.0
    phi = radians(given["phi_deg"])
    if name.startswith("4-3"):
        mech = slider_crank(given["AB"], given["BC"], given["guide_y"], radians(given["phi1_deg"]), rate)
        force = Force(name="F", link="3", point="C", direction=radians(given["F"]["deg"]), size=given["F"]["size"])
        rough = Friction(pins={p: given[f"rho_{p}"] for p in "ABC"}, slides={("3", "0"): phi})
        return mech, Loads(forces=(force,), moments=(Moment(name="M_1", link="1"),), friction=rough)
    letter = "C" if name == "4-4" else "B"  # the lever's pivot; here it is P
    pivot = complex(*given["C" if name == "4-4" else "B_lever_pivot"])
    side = given["assembly"].split()[1]
    mech = disc_cam(
        given["e"],
        given["R_disc"],
        pivot,
        given["CE_length"],
        given["tip_radius"],
        given["Q_arm"],
        radians(given["theta_deg"]),
        rate,
        side,
    )
    load = Force(name="Q", link="2", point="G", direction=radians(given["Q"]["deg"]), size=given["Q"]["size"])
    rough = Friction(pins={"A": given["rho_A"], "P": given[f"rho_{letter}"]}, contacts={"K": phi})
    return mech, Loads(
        forces=(load,), moments=(Moment(name="M_1" if name == "4-4" else "M_d", link="1"),), friction=rough
    )


def out_of_balance(result: Forces, mech: Mechanism, loads: Loads, position: float | None = None) -> float:
    """Largest resultant force and moment (over the scale) left on any link, as a share of the largest force: from
    `value` and `line` alone."""
    motion = solve(mech, position)
    force: dict[str, complex] = dict.fromkeys(mech.bodies, 0j)
    moment, sizes = dict.fromkeys(mech.bodies, 0.0), [1e-300]

    def put(link: str, f: complex, at: complex, couple: float = 0.0) -> None:
        if link != FRAME and (f or couple):
            force[link] += f
            moment[link] += couple + (at.conjugate() * f).imag
            sizes.append(max(abs(f), abs(couple) / mech.scale))

    for a, b in pairs(mech):
        for by, on in ((a, b), (b, a)):
            names = mech.number(by), mech.number(on)
            put(on, complex(result.value("R_{}{}".format(*names))), complex(result.line(*names)))
    for load in loads.all:
        size = float(result.value(load.name)) if load.size is None else load.size
        _apply(put, motion.position, load, size)
    for mass in loads.masses:
        at = complex(motion.position(mass.centre))
        put(mass.link, complex(result.value(f"F_I{mass.link}")), at, float(result.value(f"M_I{mass.link}")))
        put(mass.link, -1j * mass.mass * GRAVITY * loads.weight, at)
    return max(*(abs(f) for f in force.values()), *(abs(m) / mech.scale for m in moment.values())) / max(sizes)


def _apply(put: Any, position: Any, load: Load, size: float) -> None:
    if isinstance(load, Force):
        put(load.link, size * turned(load.direction), complex(position(load.point)))
    else:
        put(load.link, 0j, 0j, size)


def softened(loads: Loads, share: float) -> Loads:
    """The same loads with this share of the friction."""
    rough = loads.friction
    less = Friction(
        pins={k: share * v for k, v in rough.pins.items()},
        slides={k: float(np.arctan(share * np.tan(v))) for k, v in rough.slides.items()},
        contacts={k: float(np.arctan(share * np.tan(v))) for k, v in rough.contacts.items()},
    )
    return Loads(
        forces=loads.forces,
        moments=loads.moments,
        masses=loads.masses,
        friction=less,
        weight=loads.weight,
        inertia=loads.inertia,
    )


def heavy(ab: float) -> tuple[Mass, ...]:
    """Masses of a slider-crank whose coupler has a point S."""
    return (
        Mass(link="1", mass=0.8, inertia=0.8 * ab**2 / 12, centre="B"),
        Mass(link="2", mass=1.4, inertia=2e-3, centre="S"),
        Mass(link="3", mass=0.6, inertia=0.0, centre="C"),
    )
