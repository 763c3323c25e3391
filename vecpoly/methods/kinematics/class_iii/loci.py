"""Where the central link may lie in a given orientation: every leg leaves its origin a circle or a straight line.

The orientation is the unit vector u of the link's x axis; a point with the local coordinates b then lies at X + u b
(mm). A hinged leg keeps B on its circle, a guided one on its guide;
a slotted leg keeps Q at its distance from the slide.
"""

from __future__ import annotations

from typing import assert_never

import numpy as np

from ....foundation.slotted import dataclass
from ....mechanism.model import Prismatic
from ....plane import Line, Points, Reals, circles_meet, cross, line_circle_meet, lines_meet, unit
from ...desk import Desk
from ...diagram import Pose
from .star import Axial, Guided, Hinged, Parallel, Slotted, Star


@dataclass(frozen=True, slots=True)
class Ring:
    """A circle."""

    centre: Points
    radius: Reals


Locus = Ring | Line


def locus_of(desk: Desk, star: Star, leg: Axial, u: Points) -> Locus:
    """On what the origin of the central link lies, as far as this leg tells, in the orientation u."""
    body = desk.mech.link(star.plate).points
    match leg:
        case Hinged(link=link, outer=o, inner=b):
            held = desk.mech.link(link).points
            return Ring(desk.at[o] - u * desk.mm(1.0) * body[b], desk.mm(abs(held[b] - held[o])))
        case Guided(link=link, slide=slide, inner=b):
            path = desk.locus(slide, link, b)
            return Line(path.at - u * desk.mm(1.0) * body[b], path.along + 0 * u)
        case Slotted(link=link, slide=slide, outer=q):
            along = along_of(star, slide, u)
            return Line(
                desk.at[q] + 1j * along * desk.mm(_origin_left(desk, star, slide) - desk.offset(slide, link, q)), along
            )
        case _:
            assert_never(leg)


def along_of(star: Star, slide: Prismatic, u: Points) -> Points:
    """Direction of a slide of the central link in the orientation u."""
    along: Points = u * np.exp(1j * (slide.direction if slide.guide == star.plate else -slide.turn))
    return along


def _origin_left(desk: Desk, star: Star, slide: Prismatic) -> float:
    """How far (m) the central link's origin lies to the left of one of its slides."""
    if slide.guide == star.plate:
        return float((np.exp(-1j * slide.direction) * (0 - slide.origin)).imag)
    pin = desk.mech.link(star.plate).points[slide.pin]
    return slide.offset + float((np.exp(1j * slide.turn) * (0 - pin)).imag)


def meet(one: Locus, two: Locus) -> tuple[Points, Points]:
    """Both meeting points of two loci (two straight lines: one point twice); NaN where they do not meet."""
    match one, two:
        case Ring(), Ring():
            return circles_meet(one.centre, one.radius, two.centre, two.radius)
        case (Line() as line, Ring() as ring) | (Ring() as ring, Line() as line):
            return line_circle_meet(line, ring.centre, ring.radius)
        case Line(), Line():
            at = lines_meet(one, two)
            return at, at
    raise AssertionError


def normal_at(locus: Locus, at: Points) -> Points:
    """Unit vector across the locus at one of its points."""
    return unit(at - locus.centre) if isinstance(locus, Ring) else 1j * locus.along


def gap(locus: Locus, at: Points) -> Reals:
    """How far a point lies off the locus (mm), signed."""
    if isinstance(locus, Ring):
        off: Reals = np.abs(at - locus.centre) - locus.radius
        return off
    return cross(locus.along, at - locus.at)


def orientation(desk: Desk, star: Star, leg: Parallel) -> Points:
    """The direction of the central link's x axis, which a leg with two slides keeps."""
    axis = turned(leg.guide, leg.link, desk.guide_line(leg.guide).along)
    along = axis * np.exp(1j * (leg.slide.direction if leg.slide.guide == leg.link else -leg.slide.turn))
    return turned(leg.slide, star.plate, along)


def turned(slide: Prismatic, link: str, along: Points) -> Points:
    """Direction of the x axis of one of the two links of a sliding pair, from the direction of the slide."""
    axis: Points = along * np.exp(1j * (slide.turn if link == slide.block else -slide.direction))
    return axis


def put(desk: Desk, star: Star, at: Points, u: Points) -> None:
    """Draw the central link with its origin and orientation there, then its legs."""
    desk.pose[star.plate] = Pose(at, u)
    desk.settle_rest(star.plate)
    for leg in star.legs:
        match leg:
            case Hinged(link=link, outer=o, inner=b):
                desk.settle(link, (o, b))
            case Guided(link=link, slide=slide, inner=b):
                desk.settle_turned(link, b, turned(slide, link, desk.guide_line(slide).along))
            case Slotted(link=link, slide=slide, outer=q):
                desk.settle_turned(link, q, turned(slide, link, along_of(star, slide, u)))
            case Parallel(link=link, guide=guide, slide=slide):
                point = next(iter(desk.mech.link(link).points))
                desk.letter(point, lines_meet(desk.locus(guide, link, point), desk.locus(slide, link, point)))
                desk.settle_turned(link, point, turned(guide, link, desk.guide_line(guide).along))
            case _:
                assert_never(leg)
