"""The pairs of a mechanism: hinges, slides, gears, contacts (higher pairs) and pins that run in slots."""

from __future__ import annotations

from math import radians

from ..foundation.slotted import dataclass
from .dimensions.placements import Side

FRAME = "0"  # the name of the fixed link
STANDARD = radians(20.0)  # the pressure angle of standard teeth (GB/T 1356)


@dataclass(frozen=True, slots=True, kw_only=True)
class Revolute:
    """Links pinned at a point. A multiple joint of k links appears as k - 1 of these, with one letter."""

    point: str
    a: str
    b: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Prismatic:
    """Link `block` slides along a line that is fixed on link `guide`.

    The line passes through `origin` in direction `direction`, both in the guide link's coordinates. The point `pin`
    of the block stays `offset` to the left of the line; the block's x axis makes the angle `turn` with the line's
    direction. `pin_in_slot` marks a pin that runs in the slot with no block drawn (a higher pair, replaced by R + P).
    """

    guide: str
    block: str
    origin: complex
    direction: float
    pin: str
    offset: float = 0.0
    turn: float = 0.0
    through: str = ""  # letter of the point of the guide link from which the line is set out, if any
    towards: str = ""  # where two letters give it: the second
    aside: str = ""  # letter of the block or of the guide that is said to lie beside the line, if any
    pin_in_slot: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Circle:
    """Pitch circle of a gear: a link, the letter of its centre, its radius;
    the second one of a stepped gear is marked ′."""

    link: str
    centre: str
    radius: float
    mark: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rack:
    """Pitch line of a rack: a link, a point of the line and its direction, in the link's coordinates."""

    link: str
    origin: complex
    direction: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Rolling:
    """Pure rolling of a gear on a gear or a rack; the pitch point has a letter. Two constraints: contact and no slip.

    The gear's centre stays on the side of a rack on which it is at the given position (`side` of the rack's direction).
    alpha (rad) is the pressure angle of the teeth at the pitch point: to forces alone it matters.
    """

    point: str
    gear: Circle
    on: Circle | Rack
    internal: bool = False
    side: Side = Side.LEFT
    alpha: float = STANDARD


Joint = Revolute | Prismatic | Rolling


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """A sliding-rolling pair (higher pair) of a disc on link `disc.link` with a disc or a flat face of link `on.link`.

    It is replaced by a link (高副低代): the mechanism's `links` and `joints` hold the massless link `substitute`,
    pinned at the disc's centre and pinned at the other disc's centre, or sliding along the face. Kinematics uses the
    substitute; counts of links and pairs, and forces, use the contact itself.
    `side` (of the face's direction) is where the disc lies.
    """

    point: str
    disc: Circle
    on: Circle | Rack  # Rack: here the line of a flat face
    substitute: str
    internal: bool = False
    side: Side = Side.LEFT

    @property
    def links(self) -> tuple[str, str]:
        """The two links that touch, the disc's first."""
        return self.disc.link, self.on.link


@dataclass(frozen=True, slots=True, kw_only=True)
class SlotPin:
    """A pin, fixed in link `carrier`, that runs in the slot of link `guide` and presses on its side.

    Kinematics puts the massless block `block` between the two; to forces there is no such link.
    """

    point: str
    carrier: str
    guide: str
    block: str
