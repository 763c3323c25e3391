"""Gears and racks: pitch circles and pitch lines, each drawn once, when its link is placed."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import ceil, pi

from ..board.paper.marks import FixedGuide, GearMark, LinkNumber, Mark, RackMark, Role, Segment, Weld
from ..mechanism.model import FRAME, Circle, Prismatic, Rack, Rolling
from ..mechanism.pitch_lines import PitchLine, is_along
from ..problem.problem import Shape
from .posed import Posed

HALF = 1.3  # of the gear's radius: the rack to either side of the pitch point
HALF_HATCH, WIDEST = 15.0, pi / 6  # mm, rad: the hatching of a fixed rack or gear to either side
CHORD = 4.0  # mm: of a hatched arc
FACE = 2.2  # mm from the pitch line to the body of a rack, to which its pins are joined
DEEP = 7.2  # mm from the pitch line to the underside of a rack
PAST, RUN = 5.0, 6.0  # mm by which a rack reaches past its pins; its guide past the rack, which slides along it
RIM = 2.0  # mm from a ring to its number
HUB, ARM = 1.3, 6.0  # mm: from the centre of a wheel to where its arms begin; a shorter arm has no room for a corner
BESIDE = 0.3  # mm: a pin nearer to the pitch line stands on it


def gear_marks(posed: Posed, circle: Circle, joint: Rolling | None, drawn: Sequence[Mark]) -> Iterator[Mark]:
    """The pitch circle, unless it is on the paper; arms to the pins of a gear that is no bar;
    its number; the hatching of a fixed one. joint: where it meshes, if it does."""
    centre, radius = posed.at[circle.centre], posed.mm(circle.radius)
    circles = (mark for mark in drawn if isinstance(mark, GearMark))
    if any(abs(mark.centre - centre) < BESIDE and abs(mark.radius - radius) < BESIDE for mark in circles):
        return
    yield GearMark(centre=centre, radius=radius)
    yield from _welded(posed, circle, centre)
    if circle.link == FRAME:
        half = min(HALF_HATCH / radius, WIDEST)
        yield from hatched_arc(centre, radius, -pi / 2, half, inner=_is_ring(circle, joint))
    elif posed.shape(circle.link, Shape.GEAR) is Shape.GEAR:
        pins = [posed.at[p] for p in posed.body(circle.link).points if p != circle.centre]
        yield from (Segment(a=centre, b=pin, role=Role.LINK) for pin in pins if abs(pin - centre) > BESIDE)
        if not any(isinstance(m, LinkNumber) and m.number == posed.name(circle.link) for m in drawn):
            spot = pins[0] if pins else _beside_ring(centre, radius) if _is_ring(circle, joint) else centre
            yield LinkNumber(a=centre if pins else spot, b=spot, number=posed.name(circle.link))


def hatched_arc(centre: complex, radius: float, middle: float, half: float, *, inner: bool) -> Iterator[FixedGuide]:
    """The rim of a fixed wheel hatched about a direction (rad), so far to either side: inside, where its body lies;
    outside where its teeth are inner ones. A straight line touching it would be a rail on which it rolls."""
    count = ceil(2 * half * radius / CHORD)
    cuts = [centre + cmath.rect(radius, middle + half * (2 * n / count - 1)) for n in range(count + 1)]
    for a, b in pairwise(cuts):
        yield FixedGuide(a=a, b=b) if inner else FixedGuide(a=b, b=a)


def _welded(posed: Posed, circle: Circle, centre: complex) -> Iterator[Weld]:
    """The filled corner where an arm of the wheel leaves its hub, towards the nearer of the lines of its cross: arm and
    wheel are one link (GB/T 4460)."""
    pins = () if circle.link == FRAME else posed.body(circle.link).points
    ways = (posed.at[pin] - centre for pin in pins if pin in posed.at)
    for way in ways:
        if abs(way) > HUB + ARM:
            u = way / abs(way)
            side = -1j if (u.real * u.imag) > 0 else 1j
            yield Weld(at=centre, off=HUB * u, u=u, v=side * u)


def rack_marks(posed: Posed, joint: Rolling, rack: Rack) -> Iterator[Mark]:
    """The pitch line about the pitch point, past the rack's own pins; arms to pins beside it; its fixed guide."""
    along = posed.axis(rack.link) * cmath.rect(1.0, rack.direction)
    foot = posed.pitch_point(joint)
    half = posed.mm(joint.gear.radius) * HALF
    pins = [] if rack.link == FRAME else posed.spots(rack.link)
    travels = [float((along.conjugate() * (p - foot)).real) for p in pins]
    grounds = [posed.at[letter] for letter in posed.mech.frame if letter in posed.at]
    free = [t for pin, t in zip(pins, travels, strict=True) if all(abs(pin - at) > BESIDE for at in grounds)]
    past = [*travels, *(t + PAST * (1 if t > 0 else -1) for t in free)]  # not over the symbol of a fixed pivot
    low, high = min(-half, *past, 0.0), max(half, *past, 0.0)
    a, b = foot + along * low, foot + along * high
    if joint.side != "left":
        a, b = b, a
    yield RackMark(a=a, b=b, fixed=rack.link == FRAME)
    if (slide := guided_rack(posed, rack.link)) is not None:
        middle = foot + along * float((along.conjugate() * (posed.at[slide.pin] - foot)).real)
        ahead = (b - a) / abs(b - a)
        under = -1j * ahead * DEEP
        yield FixedGuide(a=a - RUN * ahead + under, b=b + RUN * ahead + under, about=middle, to_scale=True)
    for pin, travel in zip(pins, travels, strict=True):
        on_line = foot + along * travel
        if abs(pin - on_line) > BESIDE:
            yield Segment(a=on_line, b=pin, role=Role.LINK)
        yield Segment(a=on_line, b=on_line - FACE * 1j * (b - a) / abs(b - a), role=Role.LINK)


def guided_rack(posed: Posed, link: str) -> Prismatic | None:
    """The fixed guide along which this link, a rack, slides on its own pitch line: its body is drawn as the rack's."""
    rolls = (joint for joint in posed.mech.joints if isinstance(joint, Rolling))
    rack = next((joint.on for joint in rolls if isinstance(joint.on, Rack) and joint.on.link == link), None)
    slide = posed.fixed_guide(link)
    if rack is None or slide is None or not is_along(slide, link, PitchLine(rack.origin, rack.direction)):
        return None
    return slide


def _is_ring(circle: Circle, joint: Rolling | None) -> bool:
    """Whether the circle is the inner teeth of a ring, inside which others are drawn."""
    if joint is None:
        return False
    other = joint.on if circle is joint.gear else joint.gear
    return joint.internal and isinstance(other, Circle) and circle.radius > other.radius


def _beside_ring(centre: complex, radius: float) -> complex:
    """A place for a ring's number: just outside, below on the left."""
    return centre + (radius + RIM) * cmath.rect(1.0, -0.75 * pi)
