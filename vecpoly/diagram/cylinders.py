"""The symbol of a hydraulic cylinder: a barrel on one pin, a piston with its rod on the other."""

from __future__ import annotations

from collections.abc import Iterator

from ..board.paper.marks import LinkNumber, Mark, Role, Segment
from ..mechanism.model import Prismatic
from ..problem.problem import Shape
from .posed import Posed

HALF = 2.4  # mm: half the width of the barrel
LUG = 3.0  # mm from the barrel's pin to its bottom
FRONT, PISTON = 0.62, 0.42  # of the distance of the pins: the barrel's front, the piston
GAP = 0.5  # mm between the piston and the barrel's wall


def is_cylinder(posed: Posed, joint: Prismatic) -> bool:
    """Whether the pair is drawn as cylinder and piston."""
    return posed.shapes.get(joint.guide) is Shape.CYLINDER


def cylinder_joint(posed: Posed, link: str) -> Prismatic | None:
    """The sliding pair in which the link is the barrel or the piston."""
    return next((j for j in posed.slides() if link in (j.guide, j.block) and is_cylinder(posed, j)), None)


def cylinder_part(posed: Posed, link: str, joint: Prismatic) -> Iterator[Mark]:
    """The barrel, or the piston with its rod, with the link's number; nothing until both links are located."""
    if not posed.is_located(joint.guide, joint.block):
        return
    foot, way, reach = _axis(posed, joint)
    yield from _barrel(foot, way, reach) if link == joint.guide else _piston(foot, way, reach)
    yield from _lugs(posed, link, joint)
    shares = (LUG / reach, FRONT) if link == joint.guide else (1.0, FRONT)  # from the link's own pin
    a, b = (foot + way * reach * share for share in shares)
    yield LinkNumber(a=a, b=b, number=posed.name(link))


def pressed(posed: Posed, joint: Prismatic) -> tuple[complex, complex]:
    """Where the oil presses (mm on the diagram): the bottom of the barrel, the piston."""
    foot, way, reach = _axis(posed, joint)
    return foot + way * min(LUG, 0.2 * reach), foot + way * PISTON * reach


def _axis(posed: Posed, joint: Prismatic) -> tuple[complex, complex, float]:
    """On the cylinder's line: the foot of the barrel's pin, the way to the piston's pin, their distance (mm)."""
    line, own = posed.guide(joint), next(iter(posed.body(joint.guide).points))
    start, end = line.foot(posed.at[own]), line.foot(posed.at[joint.pin])
    reach = max(abs(end - start), 1e-6)
    return start, (end - start) / reach, reach


def _barrel(foot: complex, way: complex, reach: float) -> Iterator[Mark]:
    """Open in front: bottom, two walls, two lips."""
    side = 1j * way * HALF
    back, front = foot + way * min(LUG, 0.2 * reach), foot + way * FRONT * reach
    yield Segment(a=foot, b=back, role=Role.LINK)
    yield Segment(a=back - side, b=back + side, role=Role.LINK)
    for wall in (side, -side):
        yield Segment(a=back + wall, b=front + wall, role=Role.LINK)
        yield Segment(a=front + wall, b=front + 0.35 * wall, role=Role.LINK)


def _piston(foot: complex, way: complex, reach: float) -> Iterator[Mark]:
    head, side = foot + way * PISTON * reach, 1j * way * (HALF - GAP)
    yield Segment(a=head - side, b=head + side, role=Role.LINK)
    yield Segment(a=head, b=foot + way * reach, role=Role.LINK)


def _lugs(posed: Posed, link: str, joint: Prismatic) -> Iterator[Mark]:
    """Points of the link beside the cylinder's line are joined to it."""
    line = posed.guide(joint)
    for spot in posed.spots(link):
        if abs(line.off(spot)) > HALF:
            yield Segment(a=line.foot(spot), b=spot, role=Role.LINK)
