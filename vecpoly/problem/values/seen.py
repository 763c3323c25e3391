"""What a sketch can show of a given fact: a size, with the places between which it stands.

Words say the fact to a reader; these say it to whoever draws. Lengths in m, angles in rad.
"""

from __future__ import annotations

from ...foundation.slotted import dataclass
from ...mechanism.model import Prismatic
from ...mechanism.travel import upright


@dataclass(frozen=True, slots=True, kw_only=True)
class SetOff:
    """A point is so far along a line of its link, from start on (behind it: negative), and so far to its left."""

    point: str
    start: str
    along: float
    left: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Leaning:
    """The line or the guide through this letter is at this angle to the x axis."""

    at: str
    turn: float


@dataclass(frozen=True, slots=True, kw_only=True)
class OffItsGuide:
    """The line from one letter of a link to another is at this angle to the guide on which the link slides."""

    at: str
    end: str
    link: str
    turn: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Counted:
    """The coordinate s of a link counts along the y axis, upright, or along x."""

    link: str
    upright: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Round:
    """A circle has a radius of this name."""

    symbol: str
    radius: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Beside:
    """A guide passes this letter, of its block or of its own, at an offset."""

    letter: str
    block: str
    guide: str


def counted(link: str, joint: Prismatic) -> Counted | None:
    """From which axis the coordinate of a link on a guide counts; nothing where it counts from a letter."""
    return None if joint.through else Counted(link=link, upright=upright(joint))


Seen = SetOff | Leaning | OffItsGuide | Counted | Round | Beside
