"""The pitch line of a rack as other links see it: what slides along it keeps its distance from it."""

from __future__ import annotations

import cmath
from math import sin

from ..foundation.slotted import dataclass
from .model import Mechanism, Prismatic, Rack

PARALLEL = 1e-9  # sine between lines below which they are parallel


@dataclass(frozen=True, slots=True)
class PitchLine:
    """A point of the line and its direction (rad), in the coordinates of a link."""

    origin: complex
    direction: float

    def left(self, point: complex) -> float:
        """How far (m) a point of the link lies to the left of the line."""
        return (cmath.exp(-1j * self.direction) * (point - self.origin)).imag


def pitch_lines(mech: Mechanism, rack: Rack) -> dict[str, PitchLine]:
    """The rack's pitch line on the rack itself, and on every link that slides along it,
    or along what slides along it."""
    seen = {rack.link: PitchLine(rack.origin, rack.direction)}
    todo = [rack.link]
    while todo:
        here = todo.pop()
        for joint in mech.joints:
            if (
                isinstance(joint, Prismatic)
                and here in (joint.guide, joint.block)
                and is_along(joint, here, seen[here])
            ):
                other = joint.block if here == joint.guide else joint.guide
                if other not in seen:
                    seen[other] = _across(mech, joint, here, seen[here])
                    todo.append(other)
    return seen


def is_along(joint: Prismatic, link: str, line: PitchLine) -> bool:
    """Whether the link slides along this line of its own."""
    own = -joint.turn if link == joint.block else joint.direction
    return abs(sin(line.direction - own)) < PARALLEL


def _across(mech: Mechanism, joint: Prismatic, link: str, line: PitchLine) -> PitchLine:
    """The line on the other link of the slide."""
    pin = mech.link(joint.block).points[joint.pin]
    if link == joint.guide:
        off = (cmath.exp(-1j * joint.direction) * (line.origin - joint.origin)).imag - joint.offset
        return PitchLine(pin + 1j * off * cmath.exp(-1j * joint.turn), line.direction - joint.direction - joint.turn)
    off = joint.offset + (cmath.exp(1j * joint.turn) * (line.origin - pin)).imag
    return PitchLine(
        joint.origin + 1j * off * cmath.exp(1j * joint.direction), line.direction + joint.turn + joint.direction
    )
