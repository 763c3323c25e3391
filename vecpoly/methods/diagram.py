"""The mechanism as it is drawn: lettered points, links posed, guides and contacts. Lengths on paper are in mm."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..board.board import Board
from ..board.construction import View
from ..diagram.lines import contact_of, guide_line, line_on, normal_of
from ..diagram.posed import Posed
from ..mechanism.model import FRAME, Contact, Mechanism, Prismatic, Rack, Rolling
from ..plane import Line, Points, nominal, unit
from ..problem.problem import Shape


@dataclass(frozen=True, slots=True)
class Pose:
    """A link as drawn: the paper point of its origin and the paper direction of its x axis."""

    origin: Points
    along: Points


@dataclass(slots=True)
class Diagram:
    """The kinematic diagram so far: `at` the lettered points, `pose` the links; `shapes`: how links look."""

    board: Board
    mech: Mechanism
    shapes: Mapping[str, Shape] = field(default_factory=dict)
    loaded: bool = False  # whether forces follow: then friction angles are meant, and no pressure angle is marked
    mass_centres: frozenset[str] = frozenset()
    at: dict[str, Points] = field(default_factory=dict)
    pose: dict[str, Pose] = field(default_factory=dict)

    def mm(self, metres: float) -> float:
        """A length of the mechanism on paper."""
        return metres / self.board.scales[View.MECHANISM].value

    def is_located(self, *links: str) -> bool:
        """Whether all of these are drawn; the frame always is."""
        return set(links) <= {*self.pose, FRAME}

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
            per_metre=self.mm(1.0),
            at={letter: complex(nominal(at)) for letter, at in self.at.items()},
            located={
                link: (complex(nominal(pose.origin)), complex(nominal(pose.along))) for link, pose in self.pose.items()
            },
            loaded=self.loaded,
            centres=self.mass_centres,
        )

    def axis(self, link: str) -> Points:
        """Paper direction of the link's x axis."""
        return 1 + 0j if link == FRAME else self.pose[link].along

    def letter(self, name: str, at: Points) -> None:
        """A point of the diagram is found: it has its letter."""
        self.at[name] = self.board.locate(View.MECHANISM, name, at)

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
        return guide_line(self, joint)

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
            line = line_on(self, joint.on.link, joint.on.origin, joint.on.direction)
            off = (np.conj(line.along) * (centre - line.at)).imag
            return centre - 1j * line.along * off
        return centre + unit(self.at[joint.on.centre] - centre) * self.mm(joint.gear.radius) * (
            -1 if joint.internal and joint.gear.radius < joint.on.radius else 1
        )

    def normal_of(self, contact: Contact) -> Points:
        """The common normal of a contact as drawn, into the other link."""
        return normal_of(self, contact)

    def contact_of(self, contact: Contact) -> Points:
        """The point of contact as drawn."""
        return contact_of(self, contact)

    def letters(self, link: str) -> tuple[str, ...]:
        """Letters of the link: its points and its rolling contacts."""
        rolls = [j.point for j in self.mech.joints if isinstance(j, Rolling) and link in (j.gear.link, j.on.link)]
        return (*self.mech.link(link).points, *rolls)

    def bar(self, link: str, p: str, q: str) -> str:
        """Two letters of a link in the order in which the problem names them: EF, not FE; that of a pitch point last,
        which no link has for its own."""
        own = [name for name in self.mech.link(link).points if name in (p, q)]
        return "".join(own + [name for name in (p, q) if name not in own])

    def towards(self, p: str, q: str) -> Points:
        """Direction of the drawn line from P to Q."""
        return unit(self.at[q] - self.at[p])
