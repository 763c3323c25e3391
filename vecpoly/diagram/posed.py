"""A mechanism as it stands on a figure: which letters and links are found, and where. All that symbols need to know."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from ..board.paper.roles import Dot
from ..foundation.slotted import dataclass
from ..mechanism.groups.assur import hinges
from ..mechanism.model import FRAME, Circle, Contact, Link, Mechanism, Prismatic, Rack, Revolute, Rolling
from ..plane import Line
from ..problem.problem import Shape
from .lines import contact_of, face_line, guide_line, line_on, normal_of


@dataclass(frozen=True, slots=True)
class Way:
    """A straight line on paper: a point of it (mm), and its direction, a unit vector."""

    at: complex
    along: complex

    def travel(self, spot: complex) -> float:
        """How far along the line the foot of a place lies (mm)."""
        return float((self.along.conjugate() * (spot - self.at)).real)

    def off(self, spot: complex) -> float:
        """How far a place lies to the left of the line (mm)."""
        return float((self.along.conjugate() * (spot - self.at)).imag)

    def spot(self, travel: float) -> complex:
        """The place so far along the line."""
        return self.at + self.along * travel

    def foot(self, spot: complex) -> complex:
        """The foot of the perpendicular from a place."""
        return self.spot(self.travel(spot))


def _way(line: Line) -> Way:
    return Way(complex(line.at), complex(line.along))


@dataclass(frozen=True, slots=True, kw_only=True)
class Posed:
    """Links and letters where they stand on a figure.

    per_metre: mm of paper for one metre; at: the letters found so far (mm); located: of every link found so far the
    place of its origin (mm) and the direction of its x axis, a unit vector; loaded: whether forces follow, so that no
    pressure angle is marked; centres: the letters of centres of mass.
    """

    mech: Mechanism
    shapes: Mapping[str, Shape]
    per_metre: float
    at: Mapping[str, complex]
    located: Mapping[str, tuple[complex, complex]]
    loaded: bool = False
    centres: frozenset[str] = frozenset()
    names: Mapping[str, str] = field(default_factory=dict)  # of links that are not told by their own

    def shape(self, link: str, else_: Shape = Shape.BAR) -> Shape:
        """How the link looks."""
        return self.shapes.get(link, else_)

    def name(self, link: str) -> str:
        """The number of the link as printed."""
        return self.names.get(link, link)

    def body(self, link: str) -> Link:
        """The link as the mechanism has it."""
        return self.mech.link(link)

    def spots(self, link: str) -> list[complex]:
        """The places of the link's letters (mm)."""
        return [self.at[letter] for letter in self.body(link).points]

    def letters(self, link: str) -> tuple[str, ...]:
        """Letters of the link: its points and its rolling contacts."""
        rolls = (joint for joint in self.mech.joints if isinstance(joint, Rolling))
        return (*self.body(link).points, *(j.point for j in rolls if link in (j.gear.link, j.on.link)))

    def is_located(self, *links: str) -> bool:
        """Whether all of these have been found; the frame always is."""
        return set(links) <= {*self.located, FRAME}

    def mm(self, metres: float) -> float:
        """A length of the mechanism on paper."""
        return metres * self.per_metre

    def place(self, link: str, local: complex) -> complex:
        """A point given in link coordinates (m), on paper."""
        origin, along = (0j, 1 + 0j) if link == FRAME else self.located[link]
        return origin + along * self.mm(1.0) * local

    def axis(self, link: str) -> complex:
        """The direction of the link's x axis on paper."""
        return 1 + 0j if link == FRAME else self.located[link][1]

    def guide(self, joint: Prismatic) -> Way:
        """The guide of a sliding pair."""
        return _way(guide_line(self, joint))

    def face(self, contact: Contact) -> Way:
        """The flat face of a contact."""
        return _way(face_line(self, contact))

    def normal(self, contact: Contact) -> complex:
        """The common normal of a contact: from the disc's centre through the point of contact, into the other link."""
        return complex(normal_of(self, contact))

    def touching(self, contact: Contact) -> complex:
        """Where the links of a contact touch."""
        return complex(contact_of(self, contact))

    def pitch_point(self, joint: Rolling) -> complex:
        """The pitch point of a rack: the foot of the gear's centre on the pitch line."""
        assert isinstance(joint.on, Rack)
        line = _way(line_on(self, joint.on.link, joint.on.origin, joint.on.direction))
        return line.foot(self.at[joint.gear.centre])

    def slides(self) -> tuple[Prismatic, ...]:
        """All sliding pairs."""
        return tuple(joint for joint in self.mech.joints if isinstance(joint, Prismatic))

    def fixed_pivot(self, link: str) -> str:
        """The letter by which a link is pinned to the frame, if it is."""
        pins = (joint for joint in self.mech.joints if isinstance(joint, Revolute))
        return next((joint.point for joint in pins if {joint.a, joint.b} == {link, FRAME}), "")

    def fixed_guide(self, link: str) -> Prismatic | None:
        """The fixed guide of a translating link, if it has one."""
        return next((joint for joint in self.slides() if joint.guide == FRAME and joint.block == link), None)

    def pinned(self, letter: str) -> tuple[str, ...]:
        """The links that are seen to be hinged at a letter."""
        thought = {*self.mech.substitutes, *self.mech.slot_pins}
        return tuple(name for name in hinges(self.mech).get(letter, ()) if name not in thought)

    def dot(self, letter: str) -> Dot:
        """How a letter's place is drawn: a pin, a compound hinge, a centre of mass, a point of a link."""
        if letter in self.hinged():
            return Dot.MULTIPLE if len(self.pinned(letter)) > 2 else Dot.JOINT
        if letter in self.rollers():
            return Dot.JOINT
        return Dot.MASS if letter in self.centres else Dot.POINT

    def rollers(self) -> set[str]:
        """The centres of rollers: pinned to their links, though for the motion they count as parts of them."""
        hosts = set(dict(self.mech.welded).values())
        discs = (end for contact in self.mech.contacts for end in (contact.disc, contact.on) if isinstance(end, Circle))
        return {disc.centre for disc in discs if disc.link in hosts}

    def hinged(self) -> set[str]:
        """Letters of the pins that exist, without those of a contact's substitute."""
        thought = {contact.substitute for contact in self.mech.contacts}
        pins = (joint for joint in self.mech.joints if isinstance(joint, Revolute))
        return {joint.point for joint in pins if not {joint.a, joint.b} & thought}
