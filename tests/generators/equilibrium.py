"""A third party for forces: Newton and Euler for every free body, from the exported reactions and from positions alone.

The reactions are those that `solve --json` writes under `forces`; velocities and accelerations are central differences
of the oracle's positions. It knows neither the oracle's equations of equilibrium nor the construction. For each body ΣF
− m a = 0 and ΣM − J α = 0; at a pin with friction the reaction touches the friction circle on the side that opposes the
turning, in a slide or at a contact it leans by φ against the sliding;
without friction the powers of all loads and inertia forces sum to zero.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from math import radians
from typing import Any

import numpy as np

from vecpoly.errors import VecpolyError
from vecpoly.mechanism.loads import GRAVITY, Force, Load, Loads
from vecpoly.mechanism.model import FRAME, Mechanism, Prismatic, Revolute
from vecpoly.solution import Solution

from .moving import Moving, links_of, reaction_key, slack_of, told_by_differences

AGREE = 1e-7  # of the largest force, and of that times the mechanism's size
STILL = 1e-6  # of the largest rate: slower pairs tell no sense


@dataclass(frozen=True, slots=True, kw_only=True)
class Push:
    """A force (N) at a point (m), with a couple (N·m)."""

    force: complex = 0j
    at: complex = 0j
    couple: float = 0.0

    def moment(self) -> float:
        """About the origin."""
        return (self.at.conjugate() * self.force).imag + self.couple


def in_equilibrium(solution: Solution) -> str:
    """What is wrong with the exported forces, "" where nothing is."""
    problem = solution.problem
    mech, loads = problem.mechanism, problem.loads
    assert loads is not None
    try:
        moving, coarse = told_by_differences(mech, loads)
    except VecpolyError:
        return ""  # too near the end of the range for five positions
    if moving.leaps:
        return ""
    forces = solution.as_json()["forces"]
    ways = ["", "_0"] if loads.friction else [""]
    slack = slack_of(moving, coarse, loads)
    found = (
        wrong
        for way in ways
        for wrong in (*_bodies(moving, loads, forces, way, slack), *_laws(moving, loads, forces, way))
    )
    return next(found, "") or ("" if loads.friction else _power((moving, coarse), loads, forces, slack))


def _bodies(moving: Moving, loads: Loads, forces: dict[str, Any], way: str, slack: float) -> Iterator[str]:
    """Bodies that are in no equilibrium."""
    mech = moving.mech
    pushes = {
        name: [*_reactions(mech, forces, name, way), *_given(moving, loads, forces, name, way)]
        for name in links_of(mech)
    }
    largest = max((abs(p.force) for ps in pushes.values() for p in ps), default=0.0)
    largest = max([largest, *(abs(p.couple) / mech.scale for ps in pushes.values() for p in ps)])
    for name, ps in pushes.items():
        force, moment = sum(p.force for p in ps), sum(p.moment() for p in ps)
        far = max([mech.scale, *(abs(p.at) for p in ps if p.force)])
        if not abs(force) <= AGREE * largest + slack:
            yield f"link {name}{way}: the forces sum to {force:.6g} N"
        if not abs(moment) <= (AGREE * largest + slack) * far:
            yield f"link {name}{way}: the moments sum to {moment:.6g} N·m"


def _reactions(mech: Mechanism, forces: dict[str, Any], name: str, way: str) -> Iterator[Push]:
    letters = {
        "",
        *(joint.pin for joint in mech.joints if isinstance(joint, Prismatic) and joint.pin_in_slot),
    }  # of two pins of one link in slots of another
    for other, letter in product((*links_of(mech), FRAME), letters):
        found = forces.get(f"{reaction_key(mech, other, name)}{letter}{way}")
        if found is not None and "point" in found:
            yield Push(force=_vector(found), at=complex(*found["point"]), couple=found.get("couple") or 0.0)


def _vector(found: dict[str, Any]) -> complex:
    return 0j if found["direction_deg"] is None else cmath.rect(found["drawn"], radians(found["direction_deg"]))


def _given(moving: Moving, loads: Loads, forces: dict[str, Any], name: str, way: str) -> Iterator[Push]:
    """Loads, weight, inertia of one body."""
    points = moving.mech.link(name).points
    for load in loads.all:
        size = (
            0.0
            if name not in (load.link, getattr(load, "against", ""))
            else forces[f"{load.name}{way}"]["drawn"]
            if load.size is None
            else load.size
        )
        if isinstance(load, Force) and load.against and size:
            yield _thrust(moving, load, size if name == load.link else -size)
        elif load.link == name:
            yield _load(moving, load, size)
    mass = loads.mass(name)
    if mass is not None:
        at = moving.place(name, points[mass.centre])
        pull = -moving.acceleration(name, points[mass.centre]) if loads.inertia else 0j
        yield Push(
            force=mass.mass * (pull - (1j * GRAVITY if loads.weight else 0j)),
            at=at,
            couple=-mass.inertia * moving.alpha(name) if loads.inertia and mass.inertia else 0.0,
        )


def _thrust(moving: Moving, load: Force, size: float) -> Push:
    """On the rod away from the barrel's pin, on the barrel (negative) the other way;
    both in the line of the two pins."""
    foot, head = (
        moving.place(link, moving.mech.link(link).points[letter])
        for link, letter in ((load.against, load.foot), (load.link, load.point))
    )
    return Push(force=size * (head - foot) / abs(head - foot), at=head)


def _load(moving: Moving, load: Load, size: float) -> Push:
    if isinstance(load, Force):
        return Push(
            force=cmath.rect(size, load.direction),
            at=moving.place(load.link, moving.mech.link(load.link).points[load.point]),
        )
    return Push(couple=size)


def _laws(moving: Moving, loads: Loads, forces: dict[str, Any], way: str) -> Iterator[str]:
    """Pins whose reaction does not touch its friction circle as it should,
    slides in which it does not lean as it should."""
    mech = moving.mech
    for joint in mech.joints:
        if isinstance(joint, Revolute) and {joint.a, joint.b} <= {*links_of(mech), FRAME}:
            rho = 0.0 if way else loads.friction.pins.get(joint.point, 0.0)
            yield from _pin(moving, forces, joint, rho, way)
        elif isinstance(joint, Prismatic) and joint.pin_in_slot and joint.block not in mech.substitutes:
            phi = 0.0 if way else loads.friction.slides.get((joint.block, joint.guide), 0.0)
            yield from _slotted(moving, forces, joint, phi, way)
        elif isinstance(joint, Prismatic) and not {joint.guide, joint.block} & mech.substitutes:
            phi = 0.0 if way else loads.friction.slides.get((joint.block, joint.guide), 0.0)
            yield from _slide(moving, forces, joint, phi, way)


def _pin(moving: Moving, forces: dict[str, Any], joint: Revolute, rho: float, way: str) -> Iterator[str]:
    mech = moving.mech
    key = f"{reaction_key(mech, joint.a, joint.b)}{way}"
    found = forces.get(key)
    if found is None or not found["drawn"]:
        return
    centre = moving.place(joint.a, mech.link(joint.a).points[joint.point])
    arm = ((complex(*found["point"]) - centre).conjugate() * _vector(found)).imag / found["drawn"]
    rate = moving.omega(joint.b) - moving.omega(joint.a)
    if not abs(arm + rho * np.sign(rate)) <= 1e-6 * mech.scale:
        yield f"{key} passes {1e3 * arm:.6g} mm from {joint.point}, ρ = {1e3 * rho:g} mm, ω = {rate:.3g} rad/s"


def _slotted(moving: Moving, forces: dict[str, Any], joint: Prismatic, phi: float, way: str) -> Iterator[str]:
    """A pin in a slot: the force passes through the pin,
    which is fixed in the link beside the thought block, and leans like that of a slide."""
    mech = moving.mech
    carriers = [
        one
        for j in mech.joints
        if isinstance(j, Revolute) and joint.block in (j.a, j.b)
        for one in (j.a, j.b)
        if one != joint.block
    ]
    keys: dict[str, str] = {}
    for name in carriers:  # with its letter where a hinge, or another pin, joins the same two links
        spelt = (f"{reaction_key(mech, joint.guide, name)}{letter}{way}" for letter in (joint.pin, ""))
        keys |= dict.fromkeys([key for key in spelt if key in forces][:1], name)
    if len(keys) != 1:
        yield f"of pin {joint.pin} in its slot the forces have {', '.join(keys) or 'nothing'}"
        return
    ((key, carrier),) = keys.items()
    if "point" in forces[key] and forces[key]["drawn"]:
        place = moving.place(carrier, mech.link(carrier).points[joint.pin])
        arm = ((complex(*forces[key]["point"]) - place).conjugate() * _vector(forces[key])).imag / forces[key]["drawn"]
        if not abs(arm) <= 1e-6 * mech.scale:
            yield f"{key} passes {1e3 * arm:.6g} mm from {joint.pin}"
    yield from _slide(moving, forces, replace(joint, block=carrier), phi, way, key)


def _slide(
    moving: Moving, forces: dict[str, Any], joint: Prismatic, phi: float, way: str, key: str = ""
) -> Iterator[str]:
    mech = moving.mech
    key = key or f"{reaction_key(mech, joint.guide, joint.block)}{way}"
    found = forces.get(key)
    if (
        found is None
        or found["direction_deg"] is None
        or found["drawn"] < 1e-9 * max(abs(one["drawn"]) for one in forces.values() if one["unit"] == "N")
    ):
        return
    turn = 1.0 if joint.guide == FRAME else cmath.rect(1.0, float(moving.motion.angle(joint.guide)[2]))
    along = turn * cmath.rect(1.0, joint.direction)
    pin = mech.link(joint.block).points[joint.pin]
    place = moving.place(joint.block, pin)
    slip = (
        (moving.velocity(joint.block, pin) - moving.velocity(joint.guide, moving.local(joint.guide, place))) / along
    ).real
    force = _vector(found) / along
    if not abs(force.real + np.tan(phi) * abs(force.imag) * np.sign(slip)) <= 1e-6 * abs(force):
        yield (
            f"{key} leans by {np.degrees(np.arctan2(force.real, abs(force.imag))):.6g}°, φ = "
            f"{np.degrees(phi):g}°, slip {slip:.3g} m/s"
        )


def _power(both: tuple[Moving, Moving], loads: Loads, forces: dict[str, Any], slack: float) -> str:
    """Σ P = 0 of all that acts from outside."""
    (moving, coarse), parts, largest = both, [], 0.0
    mech = moving.mech
    for name in links_of(mech):
        for push in _given(moving, loads, forces, name, ""):
            largest = max(largest, abs(push.force), abs(push.couple) / mech.scale)
            parts.append(
                (push.force.conjugate() * moving.velocity(name, moving.local(name, push.at))).real
                if push.force
                else 0.0
            )
            parts.append(push.couple * moving.omega(name))
    points = [(name, at) for name in links_of(mech) for at in mech.link(name).points.values()]
    speed, off = (
        max(abs(moving.velocity(*one)) for one in points),
        max(abs(moving.velocity(*one) - coarse.velocity(*one)) for one in points),
    )
    if not abs(sum(parts)) <= ((AGREE * largest + slack) * speed + 4 * largest * off) * len(parts):
        return f"the powers sum to {sum(parts):.6g} W"
    return ""
