"""Every reaction of random mechanisms with gears and racks, balanced on any link, with friction in bearings and guides.

The third party: Newton and Euler for each body, and the law of teeth: the force passes through the pitch point, leans
by α from the common tangent, and presses the gear away from its partner.
"""

from __future__ import annotations

import re

import numpy as np

from vecpoly import loads
from vecpoly.mechanism.groups.assur import hinges, is_held
from vecpoly.mechanism.model import Circle, Mechanism, Rack, Rolling
from vecpoly.solution import Solution

from .equilibrium import _vector, in_equilibrium
from .family import families, family
from .moving import Moving, reaction_key
from .powers import loaded, no_power_is_left


def teeth_press(solution: Solution) -> str:
    """Equilibrium of every body, and the line of action of every pair of teeth."""
    problem, forces = solution.problem, solution.as_json()["forces"]
    assert problem.loads is not None
    mech = problem.mechanism
    if not any(key.startswith("R_") for key in forces):  # planets in a row beside another train: by the powers alone
        return no_power_is_left(solution)
    wrong = in_equilibrium(solution)
    largest = max(abs(one["drawn"]) for one in forces.values() if one["unit"] == "N")
    for joint in mech.joints:
        if isinstance(joint, Rolling):
            for way in ["", "_0"] if problem.loads.friction else [""]:
                wrong = wrong or _pressed(mech, joint, forces, way, largest)
    return wrong


def _pressed(mech: Mechanism, joint: Rolling, forces: dict, way: str, largest: float) -> str:  # type: ignore[type-arg]
    key = f"{reaction_key(mech, joint.on.link, joint.gear.link)}{way}"
    found = forces.get(key)
    if found is None:
        return f"{key} is missing"
    if found["direction_deg"] is None or found["drawn"] < 1e-9 * largest:
        return ""
    moving = Moving.of(mech)
    centre = moving.place(joint.gear.link, mech.link(joint.gear.link).points[joint.gear.centre])
    out = _outwards(mech, joint, moving, centre)
    h, force = centre - joint.gear.radius * out, _vector(found)
    arm = ((complex(*found["point"]) - h).conjugate() * force).imag / found["drawn"]
    if not abs(arm) <= 1e-6 * mech.scale:
        return f"{key} passes {1e3 * arm:.6g} mm from the pitch point {joint.point}"
    lean = np.degrees(np.arctan2((out.conjugate() * force).real, abs((out.conjugate() * force).imag)))
    if is_held(mech, joint) and not abs(lean - np.degrees(joint.alpha)) <= 1e-5:
        return f"{key} leans by {lean:.6g}° from the common tangent, α = {np.degrees(joint.alpha):g}°"
    return ""


def _outwards(mech: Mechanism, joint: Rolling, moving: Moving, centre: complex) -> complex:
    """From the pitch point to the gear's centre: from the partner's centre, or towards it inside; square to a rack."""
    if isinstance(joint.on, Rack):
        turn = 0.0 if joint.on.link == "0" else float(moving.motion.angle(joint.on.link)[2])
        way = complex(np.exp(1j * (turn + joint.on.direction)))
        return 1j * way if joint.side.value == "left" else -1j * way
    assert isinstance(joint.on, Circle)
    ray = centre - moving.place(joint.on.link, mech.link(joint.on.link).points[joint.on.centre])
    return (-1 if joint.internal else 1) * ray / abs(ray)


def balanced(rng: np.random.Generator, text: str) -> str:
    """Loads anywhere, the balancing one on any link, perhaps another pressure angle, perhaps friction."""
    mech = loads(text).mechanism
    link = str(rng.choice(mech.numbered)) if rng.random() < 0.5 else mech.drive.link
    point = str(rng.choice(list(mech.link(link).points)))
    way = f", at: {point}, direction: {rng.integers(-179, 180)} deg"
    slides = link == mech.drive.link and mech.drive.slide
    free = f'  X_b: {{on: {link}{way if slides or rng.random() < 0.3 else ""}, size: "?"}}\n'
    text = loaded(rng, text, free, find="")
    if rng.random() < 0.3:
        alpha = rng.choice([0, 14.5, 25])
        text = re.sub(r"(gear: \w+|rack: (?:\{.*?\}|\w+))", rf"\1, alpha: {alpha} deg", text)
    return text


def rubbing(rng: np.random.Generator, text: str) -> str:
    """Friction circles of some bearings."""
    pins = [p for p in hinges(loads(text).mechanism) if rng.random() < 0.7]
    told = "".join(f"  {p}: {{rho: {rng.uniform(0.2, 2):.2f} mm}}\n" for p in pins)
    return f"friction:\n{told}" if told else ""


@family("forces-gears", also=teeth_press, first=4, often=2)
def of_gears(rng: np.random.Generator) -> str:
    """Any of the mechanisms with gears and racks."""
    made = [one for one in families() if one.name.startswith("gears-")]
    return balanced(rng, made[int(rng.integers(len(made)))].make(rng))


@family("forces-gears-friction", also=teeth_press, often=1)
def with_friction(rng: np.random.Generator) -> str:
    """The same with friction in the bearings."""
    made = [one for one in families() if one.name.startswith("gears-")]
    bare = made[int(rng.integers(len(made)))].make(rng)
    return balanced(rng, bare) + rubbing(rng, bare)
