"""What acts from outside: forces and moments, weights, inertia forces, each with its power."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...errors import EquilibriumError, UnknownNameError
from ...mechanism.laws.springs import Coil, Elastic
from ...mechanism.loads import GRAVITY, Force, Load, Loads, Mass
from ...mechanism.model import FRAME, Mechanism
from ...words import Words
from ..state import NONE, STILL, Bodies, Body, Points, Reals, dot
from .laws.stands import Stands, couple_here, pull_here, refuse_met, refuse_still, size_here
from .laws.wound import refuse_wound


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Acting:
    """A force (N) at a point (m) of a link, with a couple (N·m)."""

    name: str
    link: str
    at: Points
    force: Points
    couple: Reals
    opposite: Acting | None = None  # what acts on the other link of a cylinder or a spring

    def power(self, rates: Bodies) -> Reals:
        """F·v + M ω (W)."""
        body = rates[self.link]
        own = dot(self.force, body.velocity_at(self.at)) + self.couple * body.omega
        return own if self.opposite is None else own + self.opposite.power(rates)

    def could(self, rates: Bodies) -> Reals:
        """|F| |v| + |M ω| (W): what it would do if it lay along its point's velocity."""
        body = rates[self.link]
        return np.abs(self.force) * np.abs(body.velocity_at(self.at)) + np.abs(self.couple * body.omega)

    @property
    def parts(self) -> tuple[Acting, ...]:
        """This force, and the opposite one of a cylinder or a spring."""
        return (self,) if self.opposite is None else (self, self.opposite)


def checked(mech: Mechanism, loads: Loads) -> None:
    """Raise EquilibriumError or UnknownNameError for loads that no equilibrium can be written for."""
    free = [load.name for load in loads.all if load.size is None]
    if len(free) != 1:
        named = f" ({', '.join(free)})" if free else ""
        raise EquilibriumError(
            Words(
                f"有 {len(free)} 个载荷未给大小{named}；应恰有一个待求，以平衡其余载荷",
                f"{len(free)} loads have no size{named}; exactly one must be left to balance the others",
            )
        )
    refuse_still(mech, loads)
    for item in (*loads.all, *loads.masses):
        if item.link not in mech.bodies:
            name = f"the mass of {item.link}" if isinstance(item, Mass) else item.name
            raise EquilibriumError(
                Words(
                    f"{f'构件 {item.link} 的质量' if isinstance(item, Mass) else item.name} "
                    f"作用于“{item.link}”，它不是活动构件；已有：{', '.join(mech.bodies)}",
                    f"{name} acts on '{item.link}', which is no moving link; known: {', '.join(mech.bodies)}",
                )
            )
        letter = item.centre if isinstance(item, Mass) else item.point if isinstance(item, Force) else None
        if letter is not None and letter not in mech.link(item.link).points:
            known = ", ".join(mech.link(item.link).points)
            raise UnknownNameError(
                Words(
                    f"构件 {item.link} 上没有点 {letter}；已有：{known}",
                    f"link {item.link} has no point {letter}; known: {known}",
                )
            )
    friction = loads.friction
    for where, value in (*friction.pins.items(), *friction.slides.items(), *friction.contacts.items()):
        if not value >= 0:
            raise EquilibriumError(
                Words(
                    f"{where} 处的摩擦为 {value:g}；不得为负",
                    f"friction at {where} is {value:g}; it must not be negative",
                )
            )


def given(mech: Mechanism, loads: Loads, bodies: Bodies, q: Reals) -> tuple[Acting, ...]:
    """Everything whose size is known at the positions q of the drive: loads, springs, weights, inertia forces."""
    at = Stands(mech, bodies, q)
    sized = [_load(mech, load, size_here(load, at), bodies) for load in loads.all if load.size is not None]
    sized += [_elastic(spring, at) for spring in loads.springs]
    if loads.weight:
        sized += [weight(mech, mass, bodies) for mass in loads.masses]
    if loads.dynamic:
        sized += [inertia(mech, mass, bodies) for mass in loads.masses]
    return tuple(sized)


def sought(mech: Mechanism, loads: Loads, bodies: Bodies) -> Acting:
    """The balancing load, of size 1."""
    return _load(mech, loads.unknown, np.ones(1), bodies)


def inertia(mech: Mechanism, mass: Mass, bodies: Bodies) -> Acting:
    """-m a_S at the centre of mass, and the couple -J α."""
    body, local = bodies[mass.link], mech.link(mass.link).points[mass.centre]
    return Acting(
        name=f"F_I{mass.link}",
        link=mass.link,
        at=body.point(local),
        force=-mass.mass * body.acceleration_of(local),
        couple=-mass.inertia * body.alpha,
    )


def weight(mech: Mechanism, mass: Mass, bodies: Bodies) -> Acting:
    """m g downwards at the centre of mass."""
    at = bodies[mass.link].point(mech.link(mass.link).points[mass.centre])
    return Acting(
        name=f"G_{mass.link}", link=mass.link, at=at, force=np.full(1, -1j * GRAVITY * mass.mass), couple=NONE
    )


def _load(mech: Mechanism, load: Load, size: Reals, bodies: Bodies) -> Acting:
    body = bodies[load.link]
    if isinstance(load, Force) and load.against:
        return _thrust(mech, load, size, bodies)
    if isinstance(load, Force):
        force = (size * _way(mech, load, body)).astype(np.complex128)
        at = body.point(mech.link(load.link).points[load.point])
        return Acting(name=load.name, link=load.link, at=at, force=force, couple=NONE)
    return Acting(name=load.name, link=load.link, at=body.at, force=STILL, couple=size)


def _way(mech: Mechanism, load: Force, body: Body) -> Points:
    """The unit vector of a force: fixed, or along a ray of its link."""
    if load.along is None:
        return np.full(1, np.exp(1j * load.direction))
    start, end = (mech.link(load.link).points[letter] for letter in load.along)
    way: Points = body.unit * ((end - start) / abs(end - start))
    return way


def _thrust(mech: Mechanism, load: Force, size: Reals, bodies: Bodies) -> Acting:
    """The force of a cylinder on its two links, apart along the line of their pins."""
    places = [
        bodies[link].point(mech.link(link).points[letter])
        for link, letter in ((load.against, load.foot), (load.link, load.point))
    ]
    ray = places[1] - places[0]
    push: Points = size * ray / np.abs(ray)
    back = Acting(name=load.name, link=load.against, at=places[0], force=-push, couple=NONE)
    return Acting(name=load.name, link=load.link, at=places[1], force=push, couple=NONE, opposite=back)


def _elastic(spring: Elastic, at: Stands) -> Acting:
    """What a spring with its damper does to its two links; on the link alone where the other is the frame."""
    if isinstance(spring, Coil):
        refuse_wound(spring, at)
        turns = couple_here(spring, at)
        place = at.bodies[spring.link].at
        other = None
        if spring.against != FRAME:
            there = at.bodies[spring.against].at
            other = Acting(name=spring.name, link=spring.against, at=there, force=STILL, couple=-turns)
        return Acting(name=spring.name, link=spring.link, at=place, force=STILL, couple=turns, opposite=other)
    foot, point = at.ends(spring)
    refuse_met(spring, at)
    with np.errstate(invalid="ignore", divide="ignore"):  # ends at one place have no direction: NaN
        pull: Points = -pull_here(spring, at) * (point - foot) / np.abs(point - foot)
    back = Acting(name=spring.name, link=spring.against, at=foot, force=-pull, couple=NONE)
    held = spring.against == FRAME
    return Acting(
        name=spring.name, link=spring.link, at=point, force=pull, couple=NONE, opposite=None if held else back
    )
