"""The one model of a planar mechanism, for the drawing and for the oracle alike.

Lengths in m, angles in rad, counter-clockwise positive. The frame is the link named FRAME. Every moving link
has coordinates of its own: origin at its first point, x axis towards its second point (or, where it has only
one point, along its guide line). A point of the plane, or of a link, is one complex number x + iy.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass
from .assembly.start import Start
from .assembly.statements import Shaped as Shaped
from .assembly.statements import SideOf as SideOf
from .assembly.statements import Statement as Statement
from .dimensions.placements import ByAngle as ByAngle
from .dimensions.placements import ByLengths as ByLengths
from .dimensions.placements import ByOffsets as ByOffsets
from .dimensions.placements import Placement as Placement
from .dimensions.placements import Side as Side
from .joints import FRAME as FRAME
from .joints import Circle as Circle
from .joints import Contact as Contact
from .joints import Joint as Joint
from .joints import Prismatic as Prismatic
from .joints import Rack as Rack
from .joints import Revolute as Revolute
from .joints import Rolling as Rolling
from .joints import SlotPin as SlotPin
from .profiles import CamProfile as CamProfile


@dataclass(frozen=True, slots=True, kw_only=True)
class Link:
    """A rigid link: its points in its own coordinates, and how the hand sets out the points beyond the first two."""

    name: str
    points: Mapping[str, complex]  # insertion order is the textbook's letter order
    placements: tuple[Placement, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", FrozenMap(dict(self.points)))

    @property
    def axis(self) -> tuple[str, ...]:
        """The letters of the line that is its x axis; fewer than two of a link that has no more."""
        return tuple(self.points)[:2]


@dataclass(frozen=True, slots=True, kw_only=True)
class ToldRay:
    """How the angle of a drive is told where that is not the direction of its link's x axis: as the angle of the ray
    from the pivot to the point `to`, which lies at `lean` to the link's x axis, from the line `line` of the frame (the
    x axis where it is empty), which lies at `zero` to the x axis (rad)."""

    to: str
    lean: float
    line: str
    zero: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Drive:
    """The input: link `link` turns about its pivot on the link `on`,
    or slides along their guide (`slide`); `on` is the frame as a rule.

    position: angle of the link's x axis from that of `on` (rad), or travel of the pin of their sliding pair along the
    guide from the guide's origin (m; between two moving links the length of a cylinder); rate: ω (rad/s) or v (m/s),
    relative to `on`; accel: α (rad/s²) or a (m/s²), likewise. ray: how the angle is told where that is another.
    in_turns: its rate is told as n (r/min).
    """

    link: str
    position: float
    rate: float
    accel: float = 0.0
    slide: bool = False
    on: str = FRAME
    ray: ToldRay | None = None
    in_turns: bool = False

    @property
    def zero(self) -> float:
        """The direction from which its angle is told to count (rad)."""
        return self.ray.zero if self.ray is not None else 0.0

    @property
    def lead(self) -> float:
        """By how much its position is ahead of what is told of it: its position where that is 0 (rad)."""
        return self.ray.zero - self.ray.lean if self.ray is not None else 0.0

    def told(self, position: float) -> float:
        """What the problem tells of this position (rad, or m)."""
        return position - self.lead

    @property
    def between(self) -> bool:
        """Whether it acts between two moving links, as a hydraulic cylinder does."""
        return self.on != FRAME

    @property
    def symbol(self) -> str:
        """Of its position: φ_1, s_1; of a drive between two moving links s_23."""
        return f"{'s' if self.slide else 'φ'}_{{{self.link}{self.on if self.between else ''}}}"

    @property
    def key(self) -> str:
        """Of its position on a sheet: phi_1, s_1."""
        return f"{'s' if self.slide else 'phi'}_{self.link}"

    @property
    def pair(self) -> frozenset[str]:
        """The two links between which it acts."""
        return frozenset((self.link, self.on))


@dataclasses.dataclass(frozen=True, kw_only=True)  # without slots: what follows from it is found once and kept
class Mechanism:
    """A planar mechanism: the frame's points (in m), moving links, joints,
    drives, branches, rough positions for Newton."""

    frame: Mapping[str, complex]
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    drives: tuple[Drive, ...]
    branches: tuple[Statement, ...] = ()
    contacts: tuple[Contact, ...] = ()
    starts: tuple[Start, ...] = ()
    guesses: Mapping[str, complex] = field(default_factory=dict)  # rough positions of points, where Newton needs them
    welded: tuple[tuple[str, str], ...] = ()  # rollers that turn idly, and the link of which each is taken as a part
    idle: tuple[Circle, ...] = ()  # gears that mesh with nothing: they are drawn, and lead nothing
    cams: tuple[CamProfile, ...] = ()  # contacts whose discs only stand for a profile, at one place after another
    instead_of: Drive | None = None  # the drive that is given, where another link is thought to drive

    def __post_init__(self) -> None:
        object.__setattr__(self, "frame", FrozenMap(dict(self.frame)))
        object.__setattr__(self, "guesses", FrozenMap(dict(self.guesses)))

    @property
    def drive(self) -> Drive:
        """The only drive (one degree of freedom)."""
        return self.drives[0]

    @cached_property
    def substitutes(self) -> frozenset[str]:
        """Names of the links that are only thought, in place of higher pairs."""
        return frozenset(contact.substitute for contact in self.contacts)

    @cached_property
    def slot_pins(self) -> Mapping[str, SlotPin]:
        """The pins that run in slots, by the name of the block that is only thought there."""
        led = (joint for joint in self.joints if isinstance(joint, Prismatic) and joint.pin_in_slot)
        return {
            joint.block: SlotPin(point=joint.pin, carrier=self._carrier(joint), guide=joint.guide, block=joint.block)
            for joint in led
            if joint.block not in self.substitutes
        }

    def _carrier(self, slide: Prismatic) -> str:
        """The link in which the pin is fixed that runs in this slot."""
        thought = {j.block for j in self.joints if isinstance(j, Prismatic) and j.pin_in_slot}
        beside = [
            j.a if j.b == slide.block else j.b
            for j in self.joints
            if isinstance(j, Revolute) and slide.block in (j.a, j.b)
        ]
        return next((name for name in (*beside, *self.links_at(slide.pin)) if name not in thought), slide.block)

    @cached_property
    def bodies(self) -> tuple[str, ...]:
        """Names of the moving links that exist, without the substitutes of higher pairs."""
        return tuple(link.name for link in self.links if link.name not in self.substitutes)

    @cached_property
    def numbered(self) -> tuple[str, ...]:
        """Names of the moving links that the problem names:
        the bodies, without the blocks that are thought about pins in slots."""
        return tuple(name for name in self.bodies if name not in self.slot_pins)

    @cached_property
    def frame_number(self) -> str:
        """The frame's number as printed: one more than the highest of the links."""
        return str(
            1
            + max(
                (
                    int("".join(filter(str.isdigit, name)))
                    for name in (*self.bodies, *dict(self.welded))
                    if name[0].isdigit()
                ),
                default=0,
            )
        )

    def number(self, link: str) -> str:
        """A link's number as printed, the frame's included;
        the block that is thought about a pin in a slot has that of the pin's link."""
        if link[:1].isalpha() and link in (pins := self.slot_pins):
            link = pins[link].carrier
        return self.frame_number if link == FRAME else link

    def disc_number(self, link: str) -> str:
        """The number by which the radius of a link's disc is called: that of the roller that was welded to it."""
        return next((roller for roller, host in self.welded if host == link), self.number(link))

    def named(self, number: str) -> str:
        """The link with this printed number."""
        return FRAME if number == self.frame_number else number

    def link(self, name: str) -> Link:
        """The moving link with this name; the frame as a link where name is FRAME."""
        return self._by_name[name]

    @cached_property
    def _by_name(self) -> Mapping[str, Link]:
        return {link.name: link for link in (*self.links[::-1], Link(name=FRAME, points=self.frame))}

    def links_at(self, point: str) -> tuple[str, ...]:
        """Names of all links (frame included, last) that carry the lettered point."""
        names = tuple(link.name for link in self.links if point in link.points)
        return (*names, FRAME) if point in self.frame else names

    def shared(self, one: str, other: str) -> tuple[str, ...]:
        """The letters that two links have in common, as that of the pin between them."""
        return tuple(point for point in self.link(one).points if point in self.link(other).points)

    @cached_property
    def scale(self) -> float:
        """Largest distance between two points of one link or of the frame (m): the scale of its errors."""
        spans = [
            abs(p - q)
            for pts in (self.frame, *(li.points for li in self.links))
            for p in pts.values()
            for q in pts.values()
        ]
        return max(spans, default=1.0) or 1.0
