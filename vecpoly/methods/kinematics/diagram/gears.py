"""Gears and racks in the kinematic diagram: pitch circles and pitch lines, each drawn once, when its link is placed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from ....board.construction import View
from ....board.paper.marks import FixedGuide, GearMark, LinkNumber, Mark, RackMark, Role, Segment
from ....mechanism.model import FRAME, Circle, Prismatic, Rack, Rolling
from ....mechanism.pitch_lines import PitchLine, is_along
from ....plane import nominal
from ....problem.problem import Shape
from ...desk import Desk

HALF = 1.3  # of the gear's radius: the rack to either side of the pitch point
HALF_HATCH = 15.0  # mm: the hatching of a fixed gear to either side
DEEP = 7.2  # mm from the pitch line to the underside of a rack
RIM = 2.0  # mm from a ring to its number
BESIDE = 0.3  # mm: a pin nearer to the pitch line stands on it


def draw_gears(desk: Desk, links: tuple[str, ...], shapes: Mapping[str, Shape]) -> None:
    """The gears among these links, those fixed to the frame with the first that rolls on them, and the racks that touch
    now."""
    for joint in (j for j in desk.mech.joints if isinstance(j, Rolling)):
        for circle in (joint.gear, joint.on):
            if isinstance(circle, Circle) and (
                circle.link in links or (circle.link == FRAME and joint.gear.link in links)
            ):
                desk.board.mark(View.MECHANISM, *_gear(desk, circle, joint, shapes), owner=f"link {circle.link}")
        both = {joint.gear.link, joint.on.link}
        if isinstance(joint.on, Rack) and both & set(links) and both <= {*desk.pose, FRAME}:
            desk.board.mark(View.MECHANISM, *_rack(desk, joint, joint.on), owner=f"link {joint.on.link}")


def _gear(desk: Desk, circle: Circle, joint: Rolling, shapes: Mapping[str, Shape]) -> Iterator[Mark]:
    """The pitch circle; arms to the pins of a gear that is no bar; its number; the hatching of a fixed one."""
    centre, radius = _spot(desk, circle.centre), desk.mm(circle.radius)
    drawn = desk.board.marks(View.MECHANISM)
    if any(
        isinstance(m, GearMark) and abs(m.centre - centre) < BESIDE and abs(m.radius - radius) < BESIDE for m in drawn
    ):
        return
    yield GearMark(centre=centre, radius=radius)
    if circle.link == FRAME:
        foot, along = centre - 1j * radius, 1.0 if joint.internal else -1.0
        yield FixedGuide(a=foot + along * -HALF_HATCH, b=foot + along * HALF_HATCH)
    elif shapes.get(circle.link, Shape.GEAR) is Shape.GEAR:
        pins = [_spot(desk, p) for p in desk.mech.link(circle.link).points if p != circle.centre]
        yield from (Segment(a=centre, b=pin, role=Role.LINK) for pin in pins if abs(pin - centre) > BESIDE)
        if not any(isinstance(m, LinkNumber) and m.number == circle.link for m in drawn):
            spot = pins[0] if pins else _beside_ring(centre, radius) if _is_ring(circle, joint) else centre
            yield LinkNumber(a=centre if pins else spot, b=spot, number=circle.link)


def _is_ring(circle: Circle, joint: Rolling) -> bool:
    """Whether the circle is the inner teeth of a ring, inside which others are drawn."""
    other = joint.on if circle is joint.gear else joint.gear
    return joint.internal and isinstance(other, Circle) and circle.radius > other.radius


def _beside_ring(centre: complex, radius: float) -> complex:
    """A place for a ring's number: just outside, below on the left."""
    return centre + (radius + RIM) * complex(np.exp(-0.75j * np.pi))


def _rack(desk: Desk, joint: Rolling, rack: Rack) -> Iterator[Mark]:
    """The pitch line about the pitch point, as far as the rack's own pins; arms to pins beside it."""
    along = complex(nominal(desk.axis(rack.link))) * complex(np.exp(1j * rack.direction))
    foot = complex(nominal(desk.contact(joint)))
    half = desk.mm(joint.gear.radius) * HALF
    pins = [] if rack.link == FRAME else [_spot(desk, p) for p in desk.mech.link(rack.link).points]
    travels = [float((along.conjugate() * (p - foot)).real) for p in pins]
    low, high = min(-half, *travels, 0.0), max(half, *travels, 0.0)
    a, b = foot + along * low, foot + along * high
    if joint.side != "left":
        a, b = b, a
    yield RackMark(a=a, b=b, fixed=rack.link == FRAME)
    if (slide := guided_rack(desk, rack.link)) is not None:
        middle = foot + along * float((along.conjugate() * (_spot(desk, slide.pin) - foot)).real)
        under = -1j * (b - a) / abs(b - a)
        ahead = (b - a) / abs(b - a) * HALF_HATCH
        yield FixedGuide(a=middle - ahead + DEEP * under, b=middle + ahead + DEEP * under)
    for pin, travel in zip(pins, travels, strict=True):
        if abs(pin - foot - along * travel) > BESIDE:
            yield Segment(a=foot + along * travel, b=pin, role=Role.LINK)


def guided_rack(desk: Desk, link: str) -> Prismatic | None:
    """The fixed guide along which this link, a rack, slides on its own pitch line: its body is drawn as the rack's."""
    racks = [j.on for j in desk.mech.joints if isinstance(j, Rolling) and isinstance(j.on, Rack) and j.on.link == link]
    slides = [j for j in desk.mech.joints if isinstance(j, Prismatic) and j.block == link and j.guide == FRAME]
    return (
        slides[0]
        if racks and slides and is_along(slides[0], link, PitchLine(racks[0].origin, racks[0].direction))
        else None
    )


def _spot(desk: Desk, name: str) -> complex:
    return complex(nominal(desk.at[name]))
