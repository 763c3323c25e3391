"""Every form of joint and drive under loads: any member of the families of motion, with loads on any links, masses,
friction in its joints, balanced on any link; and the same by instant centres.

The families of forces grow their own mechanisms; here those of motion are loaded as they come, so that each form of the
manual meets each kind of load.
"""

from __future__ import annotations

import re
from textwrap import dedent

import numpy as np

from vecpoly import loads
from vecpoly.mechanism.groups.assur import hinges
from vecpoly.mechanism.model import Contact, Mechanism, Prismatic
from vecpoly.problem.problem import Problem
from vecpoly.solution import Solution

from .equilibrium import in_equilibrium
from .family import families, family
from .powers import held, loaded, no_power_is_left

MOTION = ("linkage", "cylinder", "motor", "offset-slot", "pin-in", "roller", "class-iii", "gears", "change", "plate")


def told(solution: Solution) -> str:
    """Equilibrium of every body where its reactions are drawn; else the sum of all powers."""
    drawn = any(key.startswith("R_") for key in solution.as_json()["forces"])
    return in_equilibrium(solution) if drawn else no_power_is_left(solution)


def moving(rng: np.random.Generator) -> tuple[str, Mechanism]:
    """A random member of a random family of motion that the loader accepts, and its mechanism."""
    while True:
        made = [one for one in families() if one.name.startswith(MOTION)]
        text = dedent(made[int(rng.integers(len(made)))].make(rng))
        problem = loads(text)
        if isinstance(problem, Problem) and isinstance(problem.subject, Mechanism):
            return re.sub(r"^find:.*\n?( .*\n?)*", "", text, flags=re.MULTILINE).rstrip() + "\n", problem.subject


def balancing(rng: np.random.Generator, mech: Mechanism, *, piston: bool) -> str:
    """The load that is sought: of the cylinder that drives, else a moment or a force on the driving link or another."""
    drive = mech.drive
    if piston and rng.random() < 0.6:
        return f'  X_b: {{cylinder: {"-".join(sorted(map(mech.number, drive.pair)))}, size: "?"}}\n'
    names = [name for name in mech.numbered if mech.link(name).points]
    link = drive.link if not drive.between and rng.random() < 0.6 else str(rng.choice(names))
    point = str(rng.choice(held(mech, link)))
    force = rng.random() < 0.3 or (link == drive.link and drive.slide)
    way = f", at: {point}, direction: {rng.integers(-179, 180)} deg" if force else ""
    return f'  X_b: {{on: {mech.number(link)}{way}, size: "?"}}\n'


def masses(rng: np.random.Generator, mech: Mechanism) -> str:
    """Masses of some links, at one of their points, with weight or without."""
    names = [name for name in mech.numbered if mech.link(name).points and rng.random() < 0.5]
    told = "".join(
        f"  {mech.number(name)}: {{mass: {rng.uniform(0.2, 4):.2f} kg, inertia: {rng.uniform(0, 0.01):.4f} kg*m^2, "
        f"centre: {rng.choice(held(mech, name))}}}\n"
        for name in names
    )
    return f"masses:\n{told}weight: {rng.choice(['yes', 'no'])}\n" if told else ""


def rubbing(rng: np.random.Generator, mech: Mechanism) -> str:
    """Friction circles of some pins, friction angles of some slides and contacts."""
    sliding = {pin.point for pin in mech.slot_pins.values()}  # these turn in no bearing
    pins = [p for p in hinges(mech) if p not in sliding and p not in mech.substitutes and rng.random() < 0.6]
    told = "".join(f"  {p}: {{rho: {rng.uniform(0.2, 1):.2f} mm}}\n" for p in pins)
    for joint in mech.joints:
        if isinstance(joint, Contact) and rng.random() < 0.7:
            told += f"  {joint.point}: {{f: {rng.uniform(0.05, 0.2):.2f}}}\n"
        if isinstance(joint, Prismatic) and joint.block not in mech.slot_pins and rng.random() < 0.6:
            told += f"  {mech.number(joint.block)}-{mech.number(joint.guide)}: {{phi: {rng.integers(2, 9)} deg}}\n"
    return f"friction:\n{told}" if told else ""


@family("any-forces", also=told, often=1, first=2)
def under_loads(rng: np.random.Generator) -> str:
    """Loads on any links."""
    text, mech = moving(rng)
    return loaded(rng, text, balancing(rng, mech, piston="piston" in text), find="")


@family("any-masses", also=told, often=1, first=2)
def with_masses(rng: np.random.Generator) -> str:
    """Inertia forces and weights."""
    text, mech = moving(rng)
    return loaded(rng, text, balancing(rng, mech, piston="piston" in text), find="") + masses(rng, mech)


@family("any-friction", also=told, often=1, first=2)
def against_friction(rng: np.random.Generator) -> str:
    """Friction in all kinds of joints."""
    text, mech = moving(rng)
    return loaded(rng, text, balancing(rng, mech, piston="piston" in text), find="") + rubbing(rng, mech)


@family("any-centres", often=1, first=2)
def by_centres(rng: np.random.Generator) -> str:
    """Velocities by instant centres."""
    text, mech = moving(rng)
    asked = [f"omega_{mech.number(name)}" for name in mech.numbered]
    return f"{text}method: centres\nfind: [{', '.join(asked)}]\n"
