"""What acts on the links of a mechanism: forces, moments, masses, friction.
SI; angles in rad; counter-clockwise positive.

One load has no size: it is the one that balances the others. A load may have a law, by which it acts at some places
only, or with a size that changes: `size` is then its size where it acts, or the greatest one. Friction is Coulomb's:
a pin's reaction touches the friction circle of radius ρ, the reaction of a slide or a contact leans by φ = arctan f
from the normal, against the relative motion.
"""

from __future__ import annotations

from cmath import phase
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import field
from math import pi, sqrt
from typing import Literal

from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass, replace
from .laws.sizes import Law, Table
from .laws.springs import Elastic
from .model import Mechanism

Role = Literal["", "driving", "resisting"]  # what the problem says of a load; its power must agree


@dataclass(frozen=True, slots=True, kw_only=True)
class Force:
    """A force on a link through one of its lettered points, in a fixed direction (rad from the x axis), or in one that
    turns with the driving link: `along` a ray between two of its points; `direction` is then that of this position.

    size: N, positive along `direction`; None: it balances. A cylinder's thrust acts `against` another link as well:
    from that link's point `foot` to `point`, and with the opposite force on `foot`; it has no direction of its own.
    """

    name: str  # ASCII: F, Q, F_r
    link: str
    point: str
    direction: float
    size: float | None = None
    role: Role = ""
    against: str = ""
    foot: str = ""
    law: Law | None = None
    along: tuple[str, str] | None = None

    def at(self, mech: Mechanism) -> Force:
        """The force with its direction where the drive stands now."""
        if self.along is None:
            return self
        start, end = (mech.link(self.link).points[letter] for letter in self.along)
        return replace(self, direction=mech.drive.position + phase(end - start))


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """A couple on a link (N·m, counter-clockwise positive); size None: it balances."""

    name: str  # M_1, M_d
    link: str
    size: float | None = None
    role: Role = ""
    law: Law | None = None


Load = Force | Moment


@dataclass(frozen=True, slots=True, kw_only=True)
class Constant:
    """The unknown moment on the driving link that is the same over the whole period, and does the work of all others.

    At one position it does not balance: `Loads.unknown` is then all that the driving link needs there for even motion.
    """

    name: str  # M_d
    link: str
    role: Role = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rod:
    """A round bar of constant section, thin beside its length: m = ρ π d² l / 4, J = m l² / 12 (m, kg/m³)."""

    diameter: float
    density: float
    length: float

    @property
    def mass(self) -> float:
        """m = ρ π d² l / 4 (kg)."""
        return self.density * pi * self.diameter**2 / 4 * self.length

    def inertia(self, mass: float) -> float:
        """J = m l² / 12 about the middle (kg·m²)."""
        return mass * self.length**2 / 12

    @property
    def thickness(self) -> float:
        """By what share of m l² / 12 the moment of inertia of the cylinder, m (3 r² + l²) / 12, is larger."""
        return 0.75 * (self.diameter / self.length) ** 2

    def diameter_of(self, mass: float) -> float:
        """The diameter that a bar of this mass would have (m)."""
        return sqrt(4 * mass / (pi * self.density * self.length))


@dataclass(frozen=True, slots=True, kw_only=True)
class Mass:
    """Mass (kg), moment of inertia about the centre of mass (kg·m²), and the centre's letter:
    a point of the link, S2."""

    link: str
    mass: float
    inertia: float
    centre: str
    rod: Rod | None = None  # the round bar from which they were computed, if they were
    shared: bool = False  # whether another link has its centre at this letter too: a pin that joins both

    @property
    def inertia_symbol(self) -> str:
        """J_{S2}; where two links have their centres at one pin C, J_{C3} of link 3 and J_{C4} of link 4."""
        return f"J_{{{self.centre}{self.link if self.shared else ''}}}"


def told_apart(masses: Iterable[Mass]) -> tuple[Mass, ...]:
    """The masses, each of which knows whether another has its centre at the same letter."""
    found = tuple(masses)
    at = Counter(mass.centre for mass in found if mass.inertia)
    return tuple(replace(mass, shared=at[mass.centre] > 1) for mass in found)


def slide_name(one: str, other: str) -> str:
    """A sliding pair by the numbers of its links, the lower before the higher: 23."""
    return "".join(sorted((one, other), key=lambda number: (len(number), number)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Friction:
    """Radius ρ (m) of the friction circle by pin letter;
    friction angle φ (rad) by (link, link) of a slide or by contact letter.

    A slide's key is (block, guide) as in its joint.
    """

    pins: Mapping[str, float] = field(default_factory=dict)
    slides: Mapping[tuple[str, str], float] = field(default_factory=dict)
    contacts: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("pins", "slides", "contacts"):
            object.__setattr__(self, name, FrozenMap(dict(getattr(self, name))))

    def __bool__(self) -> bool:
        return any((*self.pins.values(), *self.slides.values(), *self.contacts.values()))


@dataclass(frozen=True, slots=True, kw_only=True)
class Loads:
    """Everything that acts; exactly one force or moment has no size. `weight`:
    whether gravity (9.81 m/s², −y) acts on the masses."""

    forces: tuple[Force, ...] = ()
    moments: tuple[Moment, ...] = ()
    masses: tuple[Mass, ...] = ()
    friction: Friction = field(default_factory=Friction)
    weight: bool = False
    inertia: bool = True  # whether the inertia forces of the masses act
    springs: tuple[Elastic, ...] = ()
    constant: Constant | None = None  # then `unknown` is M_b, which nobody wrote

    def __post_init__(self) -> None:
        object.__setattr__(self, "masses", told_apart(self.masses))

    @property
    def all(self) -> tuple[Load, ...]:
        """Forces, then moments."""
        return (*self.forces, *self.moments)

    @property
    def unknown(self) -> Load:
        """The balancing load."""
        return next(load for load in self.all if load.size is None)

    @property
    def balancing(self) -> bool:
        """Whether there is a load without size, which balances the others; a machine need have none."""
        return any(load.size is None for load in self.all)

    @property
    def turns(self) -> int:
        """After how many turns of the drive all loads are what they were: 2 of a four-stroke engine."""
        tables = (load.law.size for load in self.all if load.law is not None and isinstance(load.law.size, Table))
        return max((round(table.period / (2 * pi)) for table in tables), default=1) or 1

    @property
    def dynamic(self) -> bool:
        """Whether accelerations are needed."""
        return self.inertia and bool(self.masses)

    @property
    def helps(self) -> bool:
        """Whether the balancing load may turn round and drive with the others where friction takes more than they
        give: against inertia, or because it is called driving."""
        return self.dynamic or self.unknown.role == "driving"

    def on(self, link: str) -> tuple[Load, ...]:
        """The forces and moments on a link, the balancing one included."""
        return tuple(load for load in self.all if load.link == link)

    def mass(self, link: str) -> Mass | None:
        """The link's mass, if it has one."""
        return next((m for m in self.masses if m.link == link), None)

    def burdens(self, thrust: Force) -> bool:
        """Whether more than its thrust acts on the links of a cylinder: then it is no two-force member."""
        pair = (thrust.link, thrust.against)
        return any(self.mass(link) or any(load != thrust for load in self.on(link)) for link in pair)

    def at(self, mech: Mechanism) -> Loads:
        """The loads where the drive stands now: forces that turn with it have their directions there."""
        return replace(self, forces=tuple(force.at(mech) for force in self.forces))

    def without_roles(self) -> Loads:
        """The loads, none called driving or resisting: over a cycle a load may be both in turn."""
        return replace(
            self,
            forces=tuple(replace(one, role="") for one in self.forces),
            moments=tuple(replace(one, role="") for one in self.moments),
        )

    def driven(self) -> Loads:
        """The same with a balancing load that drives."""
        return replace(
            self,
            forces=tuple(replace(one, role=one.role if one.size is not None else "driving") for one in self.forces),
            moments=tuple(replace(one, role=one.role if one.size is not None else "driving") for one in self.moments),
        )


GRAVITY = 9.81  # m/s²
