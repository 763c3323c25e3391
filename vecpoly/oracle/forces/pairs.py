"""Joints and contacts as seen by statics: what one link can do to the other, and how friction adds to it.

The force of link a on link b is a sum of unit wrenches, of unknown sizes, at the pair's point `at`; that on a is the
opposite. Friction adds the wrench `rub`, opposed to the relative motion, times the size of the pressing force.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...mechanism.asked.forces import press_named
from ...mechanism.groups.assur import is_held
from ...mechanism.loads import Friction
from ...mechanism.model import Contact, Mechanism, Prismatic, Revolute, Rolling
from ...words import Words
from ..closed.contact import touching
from ..closed.pitch import pitch_point
from ..state import NONE, STILL, Bodies, Points, Reals, dot

ONE: Points = np.ones(1, np.complex128)


@dataclass(frozen=True, slots=True)
class Wrench:
    """A force (N) and a couple (N·m) about the point where it is thought."""

    force: Points
    couple: Reals


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Pair:
    """Links a and b in touch at `at`.

    units: wrenches on b of unknown size, of which the first `pressed` make the force that friction counts by.
    rub: friction's wrench on b for a pressing force of 1 N; grip: ρ (m) or tan φ; rate: rad/s or m/s of b against a.
    along: the line on which a point of the line of action is given (None: square to the force, as on a friction
    circle).
    """

    text: Words  # for messages
    who: tuple[str, str]  # a and b by their printed numbers
    keys: tuple[str, str]  # of the force of a on b, and of b on a
    a: str
    b: str
    at: Points
    units: tuple[Wrench, ...]
    pressed: int = 0
    rub: Wrench | None = None
    grip: float = 0.0
    rate: Reals | None = None
    turns: bool = False  # rate is an angular velocity
    along: Points | None = None
    pushes: bool = False  # the first unit can only press
    apart: Wrench | None = None  # of teeth: how they press b away for a first unit of 1 N, of either sign

    @property
    def rubs(self) -> bool:
        """Whether there is friction here."""
        return self.rub is not None


def pairs_of(mech: Mechanism, bodies: Bodies, rates: Bodies, friction: Friction) -> tuple[Pair, ...]:
    """Every pair of bodies that press on each other;
    `rates` holds the links' velocities (of a unit drive where it rests)."""
    thought, slots = mech.substitutes, mech.slot_pins
    found = [_pin(mech, bodies, rates, joint, friction.pins.get(joint.point, 0.0)) for joint in _pins(mech, thought)]
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and joint.block in slots:
            found.append(_slotted(mech, bodies, rates, joint, friction.slides.get((joint.block, joint.guide), 0.0)))
        elif isinstance(joint, Prismatic) and not {joint.guide, joint.block} & thought:
            found.append(_slide(mech, bodies, rates, joint, friction.slides.get((joint.block, joint.guide), 0.0)))
        elif isinstance(joint, Rolling):
            found.append(_rolling(mech, bodies, joint))
    for contact in mech.contacts:
        found.append(_contact(mech, bodies, rates, contact, friction.contacts.get(contact.point, 0.0)))
    return tuple(found)


def _pins(mech: Mechanism, thought: frozenset[str]) -> Iterator[Revolute]:
    """The hinges' pins; where a substitute link stands between two bodies at one hinge,
    they are pinned to each other."""
    for joint in mech.joints:
        if isinstance(joint, Revolute) and not {joint.a, joint.b} & {*thought, *mech.slot_pins}:
            yield joint
    for name in thought:
        chain = [j for j in mech.joints if isinstance(j, Revolute) and name in (j.a, j.b)]
        for point in dict.fromkeys(j.point for j in chain):
            held = [j.a if j.b == name else j.b for j in chain if j.point == point]
            yield from (Revolute(point=point, a=held[0], b=other) for other in held[1:])


def _who(mech: Mechanism, a: str, b: str) -> tuple[str, str]:
    return mech.number(a), mech.number(b)


def _keys(mech: Mechanism, a: str, b: str) -> tuple[str, str]:
    return press_named(mech, a, b).key, press_named(mech, b, a).key


def _against(rate: Reals) -> Reals:
    """The sense of friction on link b, which moves at this rate against a."""
    sense: Reals = -np.sign(rate)
    return sense


def _pin(mech: Mechanism, bodies: Bodies, rates: Bodies, joint: Revolute, radius: float) -> Pair:
    """Reaction of any direction; friction's couple is ρ R against the relative rotation."""
    rate = rates[joint.b].omega - rates[joint.a].omega
    rub = Wrench(STILL, radius * _against(rate)) if radius else None
    at = bodies[joint.a].point(mech.link(joint.a).points[joint.point])
    return Pair(
        text=Words(f"转动副 {joint.point}", f"pin {joint.point}"),
        who=_who(mech, joint.a, joint.b),
        keys=_keys(mech, joint.a, joint.b),
        a=joint.a,
        b=joint.b,
        at=at,
        units=(Wrench(ONE, NONE), Wrench(1j * ONE, NONE)),
        pressed=2,
        rub=rub,
        grip=radius,
        rate=rate,
        turns=True,
    )


def _slide(mech: Mechanism, bodies: Bodies, rates: Bodies, joint: Prismatic, angle: float) -> Pair:
    """Force square to the guide and couple, that is a normal force anywhere along the guide;
    friction tan φ N along it."""
    guide, pin = bodies[joint.guide], mech.link(joint.block).points[joint.pin]
    along = guide.unit * complex(np.exp(1j * joint.direction))
    origin, place = guide.point(joint.origin), bodies[joint.block].point(pin)
    foot = origin + along * dot(along, place - origin)
    slip = rates[joint.block].velocity_of(pin) - rates[joint.guide].velocity_at(place)
    rate, grip = dot(along, slip), float(np.tan(angle))
    rub = Wrench(along * (grip * _against(rate)), NONE) if grip else None
    units = (Wrench(1j * along, NONE), Wrench(STILL, np.full(1, mech.scale)))
    who = _who(mech, joint.guide, joint.block)
    return Pair(
        text=Words(f"构件 {who[1]} 与 {who[0]} 的移动副", f"slide of {who[1]} on {who[0]}"),
        who=who,
        keys=_keys(mech, joint.guide, joint.block),
        a=joint.guide,
        b=joint.block,
        at=foot,
        units=units,
        pressed=1,
        rub=rub,
        grip=grip,
        rate=rate,
        along=along,
    )


def _slotted(mech: Mechanism, bodies: Bodies, rates: Bodies, joint: Prismatic, angle: float) -> Pair:
    """The side of a slot on a pin: a force square to the slot, through the pin; friction tan φ N along the slot."""
    pin = mech.slot_pins[joint.block]
    local = mech.link(pin.carrier).points[pin.point]
    along, place = bodies[pin.guide].unit * complex(np.exp(1j * joint.direction)), bodies[pin.carrier].point(local)
    rate, grip = (
        dot(along, rates[pin.carrier].velocity_of(local) - rates[pin.guide].velocity_at(place)),
        float(np.tan(angle)),
    )
    rub, who = Wrench(along * (grip * _against(rate)), NONE) if grip else None, _who(mech, pin.guide, pin.carrier)
    return Pair(
        text=Words(f"销 {pin.point} 与构件 {who[0]} 的槽之间", f"pin {pin.point} in the slot of {who[0]}"),
        who=who,
        keys=_keys(mech, pin.guide, pin.block),
        a=pin.guide,
        b=pin.carrier,
        at=place,
        units=(Wrench(1j * along, NONE),),
        pressed=1,
        rub=rub,
        grip=grip,
        rate=rate,
        along=along,
    )


def _rolling(mech: Mechanism, bodies: Bodies, joint: Rolling) -> Pair:
    """Pitch-point force without loss: of any direction where nothing else holds the gear's centre; else along the line
    of action of the flank that works, F_t across the line of centres and |F_t| tan α that presses the gears apart."""
    at, (a, b) = pitch_point(joint, mech, bodies), (joint.on.link, joint.gear.link)
    units: tuple[Wrench, ...] = (Wrench(ONE, NONE), Wrench(1j * ONE, NONE))
    apart: Wrench | None = None
    if is_held(mech, joint):
        ray = bodies[b].point(mech.link(b).points[joint.gear.centre]) - at
        out = ray / np.abs(ray)
        units, apart = (Wrench(1j * out, NONE),), Wrench(out * float(np.tan(joint.alpha)), NONE)
    return Pair(
        text=Words(f"节点 {joint.point}", f"pitch point {joint.point}"),
        who=_who(mech, a, b),
        keys=_keys(mech, a, b),
        a=a,
        b=b,
        at=at,
        units=units,
        along=ONE,
        apart=apart,
    )


def _contact(mech: Mechanism, bodies: Bodies, rates: Bodies, contact: Contact, angle: float) -> Pair:
    """The other link presses on the disc along the common normal; friction tan φ N against the sliding."""
    disc, on = contact.links
    place, normal = touching(mech, bodies, contact)
    across = 1j * normal
    rate = dot(across, rates[disc].velocity_at(place) - rates[on].velocity_at(place))
    grip = float(np.tan(angle))
    rub = Wrench(across * (grip * _against(rate)), NONE) if grip else None
    return Pair(
        text=Words(f"接触点 {contact.point}", f"contact {contact.point}"),
        who=_who(mech, on, disc),
        keys=_keys(mech, on, disc),
        a=on,
        b=disc,
        at=place,
        units=(Wrench(normal, NONE),),
        pressed=1,
        rub=rub,
        grip=grip,
        rate=rate,
        along=across,
        pushes=True,
    )
