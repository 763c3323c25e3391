"""The scales of a cam's figures: the cam as large as a page allows, the diagram in proportion to it."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, degrees, hypot, radians, sqrt, tan

from ....board.construction import Scale, View
from ....board.paper.scales import finer, round_up
from ....board.place import view_named
from ....devices.cams.cam import Cam
from ....problem.problem import Scales

DISPLACEMENT, ANGULAR, LOOP = (view_named(name) for name in ("displacement", "swing", "loop"))
CAM, WIDE, HIGH = 142.0, 160.0, 42.0  # mm: across the cam; along the diagram, up to its highest point
NARROW = 140.0  # mm: along the diagram of an arm, whose semicircle would make it wider than an upright sheet
LOOP_ROOMS = (145.0, 205.0), (225.0, 120.0)  # mm: the loop and its bounds on a page, upright or across, without axes
EQUAL = (19.0, 55.0)  # mm: a stroke of this size on the cam's own scale is drawn so


def cam_scales(cam: Cam, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    length = given.of(View.MECHANISM.mu) or fitting(2 * reach(cam) / CAM)
    across = None if DISPLACEMENT.across is None else given.of(DISPLACEMENT.across)
    turned = across or radians(fitting(360.0 / (NARROW if cam.arm else WIDE)))
    stroke = given.of(DISPLACEMENT.mu) or (
        length if EQUAL[0] <= cam.lift / length <= EQUAL[1] else fitting(cam.lift / HIGH)
    )
    loop = given.of(LOOP.mu) or fitting(max(cam.lift / (2 * HIGH), _loop_in_its_room(cam)))
    swing = given.of(ANGULAR.mu) or radians(fitting(degrees(cam.lift) / HIGH))
    return {
        View.MECHANISM: Scale.of(View.MECHANISM, length),
        DISPLACEMENT: Scale.of(DISPLACEMENT, stroke, turned),
        ANGULAR: Scale.of(ANGULAR, swing, turned),
        LOOP: Scale.of(LOOP, loop),
    }


def steepest(cam: Cam, way: int) -> float:
    """A length (m) that ds/dφ of the rises (way = 1), or of the returns, does not exceed: twice their mean."""
    return 2 * max((piece.lift / piece.angle for piece in cam.pieces if piece.rises == way), default=0.0)


def _loop_in_its_room(cam: Cam) -> float:
    """The finest scale (m/mm) at which the loop of s over ds/dφ, with the bounds below it, has room on a page."""
    if cam.alpha is None:
        return 0.0
    sides = [steepest(cam, way) for way in (1, -1)]
    leans = [tan(angle.si) for angle in (cam.alpha.rise, cam.alpha.back)]
    below = max(sum(sides) / sum(leans), *(side / lean for side, lean in zip(sides, leans, strict=True)))
    size = sum(sides), cam.lift + below
    return min(max(part / room for part, room in zip(size, rooms, strict=True)) for rooms in LOOP_ROOMS)


def fitting(least: float) -> float:
    """The finest round scale that is not below this."""
    scale = round_up(least)
    while finer(scale) >= least:
        scale = finer(scale)
    return scale


def reach(cam: Cam) -> float:
    """How far from O something is drawn (m)."""
    if cam.r0 is None:
        return cam.lift
    if cam.arm:
        oa, ab = cam.arm
        far = sqrt(oa**2 + ab**2 - 2 * oa * ab * cos(cam.psi0 + cam.lift))
        return max(oa, far + cam.follower.radius)
    if cam.follower.flat:
        return cam.r0.si + cam.lift
    e = cam.follower.e
    return hypot(sqrt(cam.r0.si**2 - e**2) + cam.lift, e) + cam.follower.radius
