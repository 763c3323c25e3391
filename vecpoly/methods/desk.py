"""What lies on the desk while a mechanism is solved: the board, the links as drawn, the velocities found so far.

Every number here was laid off, met, measured or computed on the board. Lengths on paper are in mm.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..algebra.quantity import Quantity, magnitude
from ..board.board import Board
from ..board.construction import View
from ..diagram.posed import Posed
from ..mechanism.model import FRAME, Contact, Link, Mechanism, Prismatic, Rack, Rolling, Side
from ..names import At, Kind, Rel, subscripted
from ..plane import Line, Points, Reals, foot, nominal, unit
from ..problem.problem import Shape
from ..words import Words

POLE = {View.VELOCITY: "p", View.ACCELERATION: "p′"}
VECTOR = {View.VELOCITY: Kind.V, View.ACCELERATION: Kind.A}  # what a polygon is made of
QUANTITY = {View.VELOCITY: Words("速度", "velocity"), View.ACCELERATION: Words("加速度", "acceleration")}


@dataclass(frozen=True, slots=True)
class Pose:
    """A link as drawn: the paper point of its origin and the paper direction of its x axis."""

    origin: Points
    along: Points


@dataclass(frozen=True, slots=True)
class Turn:
    """ω or α of a link, signed; `never` where the link cannot turn at all (it only translates)."""

    value: Reals
    never: bool = False


@dataclass(slots=True)
class Desk:
    """The state of one solution."""

    board: Board
    mech: Mechanism
    coincident: Mapping[str, str] = field(
        default_factory=dict
    )  # letter under which links slide over each other -> the block
    shapes: Mapping[str, Shape] = field(default_factory=dict)  # how links look
    at: dict[str, Points] = field(default_factory=dict)
    pose: dict[str, Pose] = field(default_factory=dict)
    tips: dict[tuple[View, At], Points] = field(default_factory=dict)
    turns: dict[Rel, Turn] = field(default_factory=dict)
    ends: dict[str, tuple[View, Points, Points]] = field(default_factory=dict)
    sizes: dict[str, Quantity] = field(
        default_factory=dict
    )  # of vectors that were computed, then laid off: they are not read again
    lengths: dict[frozenset[str], Quantity] = field(default_factory=dict)
    known_as: dict[tuple[View, At], tuple[Words, str]] = field(default_factory=dict)  # direction and magnitude in words
    forces: tuple[str, ...] = ()  # keys of what a force analysis found
    thought: bool = (
        False  # whether the driving link is only thought to drive, the input acting between two moving links
    )
    loaded: bool = False  # whether forces follow: then friction angles are meant, and no pressure angle is marked
    slides: dict[tuple[str, str], Rel] = field(
        default_factory=dict
    )  # links of a sliding pair → the vector along the guide that was drawn, of the first against the second
    centres: set[str] = field(default_factory=set)  # contacts with a fixed rack: no velocity, but an acceleration

    # -- names ------------------------------------------------------------------------------------------------

    def canonical(self, at: At) -> At:
        """B2 is plain B where link 2 itself carries B, S2 the letter S2 where it does; B3 stays B3 where link 3 is only
        passed over."""
        if at.link and str(at) in self.mech.link(at.link).points:
            return At(str(at))
        carried = at.link and at.point in self.mech.link(at.link).points
        return At(at.point) if carried else at

    def show(self, at: At) -> str:
        """The letter as printed: with a link's number where several links' points coincide here."""
        if at.link and at == self.canonical(at):
            return at.point + at.link
        return at.point + self.coincident.get(at.point, "")

    def name(self, at: At) -> str:
        """The letter in a sentence: C_2."""
        return subscripted(self.show(at))

    def tip_label(self, view: View, at: At) -> str:
        """The letter of a tip on a polygon: b, b_3, b′_3."""
        letter, _, digits = self.name(at).lower().partition("_")
        prime = "′" if view is View.ACCELERATION else ""
        return letter + (f"_{digits}" if digits else "") + (f"^{prime}" if prime else "")

    def start_label(self, view: View, at: At | None) -> str:
        """The letter at which a vector starts on a polygon: the pole for absolute ones and for points at rest."""
        return POLE[view] if at is None or self.at_rest(view, at) else self.tip_label(view, at)

    def k_tip(self, rel: Rel) -> str:
        """The letter at the tip of a Coriolis acceleration: k′; where several sliding pairs turn with the number of the
        point's link, or both numbers."""
        turning = [joint for joint in self.mech.joints if isinstance(joint, Prismatic) and joint.guide != FRAME]
        number = rel.to.link or self.coincident.get(rel.to.point, "")
        if len(turning) < 2 or not number:
            return "k′"
        alike = sum(number in (joint.guide, joint.block) for joint in turning) > 1
        other = self.show(rel.ref).removeprefix(rel.ref.point) if alike and rel.ref is not None else ""
        return f"k_{number}{other}^′"

    # -- the mechanism as drawn ---------------------------------------------------------------------------------

    def mm(self, metres: float) -> float:
        """A length of the mechanism on paper."""
        return metres / self.board.scales[View.MECHANISM].value

    def place(self, link: str, local: complex) -> Points:
        """Paper point of a point given in link coordinates (m)."""
        if link == FRAME:
            return self.mm(1.0) * local
        pose = self.pose[link]
        return pose.origin + pose.along * self.mm(1.0) * local

    def crank(self, link: str) -> tuple[str, list[str]]:
        """The fixed pivot of a driving link, and its other points."""
        points = self.mech.link(link).points
        pivot = next(p for p in points if p in self.mech.frame)
        return pivot, [p for p in points if p != pivot]

    def posed(self) -> Posed:
        """What has been found so far, as symbols need to know it."""
        return Posed(
            mech=self.mech,
            shapes=self.shapes,
            mm=self.mm(1.0),
            at={letter: complex(nominal(at)) for letter, at in self.at.items()},
            located={
                link: (complex(nominal(pose.origin)), complex(nominal(pose.along))) for link, pose in self.pose.items()
            },
            loaded=self.loaded,
        )

    def axis(self, link: str) -> Points:
        """Paper direction of the link's x axis."""
        return 1 + 0j if link == FRAME else self.pose[link].along

    def letter(self, name: str, at: Points) -> None:
        """A point of the diagram is found: it has its letter."""
        self.at[name] = self.board.locate(View.MECHANISM, name, at)

    def put_tip(self, view: View, at: At, tip: Points) -> Points:
        """A point's vector ends here on its polygon, at the point's letter."""
        own = self.canonical(at)
        self.tips[view, own] = self.board.locate(view, self.tip_label(view, own), tip)
        return self.tips[view, own]

    def settle(self, link: str, points: tuple[str, str]) -> None:
        """Take the link's pose from two of its points, already drawn."""
        body = self.mech.link(link)
        p, q = (body.points[name] for name in points)
        along = unit(self.at[points[1]] - self.at[points[0]]) * np.conj(unit(q - p))
        self.pose[link] = Pose(self.at[points[0]] - along * self.mm(1.0) * p, along)
        self.settle_rest(link)

    def settle_turned(self, link: str, point: str, along: Points) -> None:
        """Take the link's pose from one of its points and the direction of its x axis."""
        local = self.mech.link(link).points[point]
        self.pose[link] = Pose(self.at[point] - along * self.mm(1.0) * local, along)
        self.settle_rest(link)

    def settle_rest(self, link: str) -> None:
        """Letter the link's further points."""
        for name, local in self.mech.link(link).points.items():
            if name not in self.at:
                self.letter(name, self.place(link, local))

    def guide_line(self, joint: Prismatic) -> Line:
        """The guide of a sliding pair as drawn, found from whichever of its two links is drawn."""
        if joint.guide == FRAME or joint.guide in self.pose:
            return Line(self.place(joint.guide, joint.origin), self.axis(joint.guide) * np.exp(1j * joint.direction))
        along = self.axis(joint.block) * np.exp(-1j * joint.turn)
        pin = self.mech.link(joint.block).points[joint.pin]
        return Line(self.place(joint.block, pin) - 1j * along * self.mm(joint.offset), along)

    def offset(self, joint: Prismatic, link: str, point: str) -> float:
        """How far (m) a point of either link lies to the left of the guide."""
        local = self.mech.link(link).points[point]
        if link == joint.guide:
            return float((np.exp(-1j * joint.direction) * (local - joint.origin)).imag)
        pin = self.mech.link(joint.block).points[joint.pin]
        return joint.offset + float((np.exp(1j * joint.turn) * (local - pin)).imag)

    def locus(self, joint: Prismatic, link: str, point: str) -> Line:
        """The line on which a point of the still undrawn link of a sliding pair must lie."""
        line = self.guide_line(joint)
        return Line(line.at + 1j * line.along * self.mm(self.offset(joint, link, point)), line.along)

    def contact(self, joint: Rolling) -> Points:
        """Pitch point of a rolling pair as drawn: foot on the rack, or on the line of centres."""
        centre = self.at[joint.gear.centre]
        if isinstance(joint.on, Rack):
            line = Line(
                self.place(joint.on.link, joint.on.origin), self.axis(joint.on.link) * np.exp(1j * joint.on.direction)
            )
            off = (np.conj(line.along) * (centre - line.at)).imag
            return centre - 1j * line.along * off
        return centre + unit(self.at[joint.on.centre] - centre) * self.mm(joint.gear.radius) * (
            -1 if joint.internal and joint.gear.radius < joint.on.radius else 1
        )

    def normal_of(self, contact: Contact) -> Points:
        """Common normal of a contact as drawn: unit vector from the disc's centre through the point of contact, into
        the other link."""
        if isinstance(contact.on, Rack):
            return self.face_line(contact).along * (-1j if contact.side is Side.LEFT else 1j)
        way = self.towards(contact.disc.centre, contact.on.centre)
        return -way if contact.internal else way

    def contact_of(self, contact: Contact) -> Points:
        """Point of contact as drawn: foot of the disc's centre on the face, or on the line of centres at the disc's
        radius."""
        centre = self.at[contact.disc.centre]
        if isinstance(contact.on, Rack):
            return foot(self.face_line(contact), centre)
        return centre + self.normal_of(contact) * self.mm(contact.disc.radius)

    def face_line(self, contact: Contact) -> Line:
        """The flat face of a contact as drawn."""
        assert isinstance(contact.on, Rack)
        return Line(
            self.place(contact.on.link, contact.on.origin),
            self.axis(contact.on.link) * np.exp(1j * contact.on.direction),
        )

    # -- what is known of the motion ------------------------------------------------------------------------------

    def tip(self, view: View, at: At) -> Points:
        """End of a point's vector on a polygon; points of the frame are at the pole."""
        at = self.canonical(at)
        return 0j if self.at_rest(view, at) else self.tips[view, at]

    def at_rest(self, view: View, at: At) -> bool:
        """Whether the point's vector is zero for good: a point of the frame, or a contact with a fixed rack (velocity
        only)."""
        at = self.canonical(at)
        return not at.link and (at.point in self.mech.frame or (view is View.VELOCITY and at.point in self.centres))

    def where(self, at: At) -> Points:
        """Place of a point on the diagram; M2, found as a point of link 2, has a place of its own."""
        return self.at[str(at)] if str(at) in self.at else self.at[at.point]

    def has_tip(self, view: View, at: At) -> bool:
        """Whether the point's vector is already drawn."""
        at = self.canonical(at)
        return (view, at) in self.tips or self.at_rest(view, at)

    def letters(self, link: str) -> tuple[str, ...]:
        """Letters of the link: its points and its rolling contacts."""
        rolls = [j.point for j in self.mech.joints if isinstance(j, Rolling) and link in (j.gear.link, j.on.link)]
        return (*self.mech.link(link).points, *rolls)

    def bar(self, link: str, p: str, q: str) -> str:
        """Two letters of a link in the order in which the problem names them: EF, not FE."""
        return "".join(name for name in self.mech.link(link).points if name in (p, q))

    def length(self, p: str, q: str) -> Quantity:
        """l_PQ: given by the problem where one link carries both points; else measured once on the diagram, × μ_l."""
        pair = frozenset((p, q))
        for link in (*self.mech.links, Link(name=FRAME, points=self.mech.frame)):
            if pair <= set(link.points):
                return magnitude(f"l_{self.bar(link.name, p, q)}", abs(link.points[p] - link.points[q]), "m")
        if pair not in self.lengths:
            on_paper = self.board.measure(self.at[p], self.at[q], f"{p} {q}")
            mu = self.board.mu(View.MECHANISM)
            self.lengths[pair] = self.board.compute(f"l_{p}{q}", mu * on_paper, "m")
        return self.lengths[pair]

    def towards(self, p: str, q: str) -> Points:
        """Direction of the drawn line from P to Q."""
        return unit(self.at[q] - self.at[p])
