"""The curved arrows with ω, and with α where one is given, about the driving link's pivot, where they touch nothing;
the arrow with v before a driving block."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ....board.construction import View
from ....board.paper.marks import AngleMark, Arc, FixedGuide, Role, Segment, Slot
from ....mechanism.model import FRAME, Drive, Prismatic, Revolute
from ....names import At, Kind, Rel
from ....plane import nominal
from ...desk import Desk
from ..position.drive import swept

Complexes = NDArray[np.complex128]
Reals = NDArray[np.float64]

ARROW_RADII = (10.0, 13.0, 16.0)  # mm: the first that keeps clear of circles about the pivot
FROM, LONG = 6.0, 9.0  # mm: the arrow before a block begins so far from its pin, and is so long
GROUND = 5.5  # mm from the pivot within which its ground is hatched
HALF = 0.9  # rad: of an arrow, to either side of its middle
APART = 4.0  # mm between the arrow and the arc of a reflex angle


def draw_drive_arrow(desk: Desk) -> None:
    """The curved arrows with ω and α at the pivot of each driving link, the arrow with v before its block; of a link
    that is only thought to drive none, but at the hinge in which the given drive acts."""
    given = (desk.mech.instead_of,) if desk.thought else desk.mech.drives
    for drive in (one for one in given if one is not None):
        (_before if drive.slide else _draw)(desk, drive)


def _before(desk: Desk, drive: Drive) -> None:
    """The way in which a driving block moves, with its velocity: no vector to scale."""
    slides = (j for j in desk.mech.joints if isinstance(j, Prismatic) and (j.block, j.guide) == (drive.link, FRAME))
    joint = next(slides, None)
    if not drive.rate or joint is None or joint.pin not in desk.at:
        return
    at, along = (complex(nominal(z)) for z in (desk.at[joint.pin], desk.guide_line(joint).along))
    way = along if drive.rate > 0 else -along
    start = at + FROM * way
    symbol = Rel(Kind.V, At(joint.pin)).symbol
    desk.board.arrow(View.MECHANISM, start, start + LONG * way, Role.GIVEN, key="drive", label=symbol)


def _draw(desk: Desk, drive: Drive) -> None:
    pivot = _hinge(desk, drive) if drive.between else desk.crank(drive.link)[0]
    pair = f"{{{drive.link}{drive.on}}}" if drive.between else drive.link
    at = complex(nominal(desk.at[pivot]))
    radius, taken = _arrow_radius(desk, at), _taken(desk, at, drive)
    for kind, rate in (("ω", drive.rate), ("α", drive.accel)):
        if kind == "ω" or rate:
            middle = _free_side(at, radius, taken)
            start = middle - HALF if rate > 0 else middle + HALF
            desk.board.curved_arrow(View.MECHANISM, at, radius, start, rate > 0, f"{kind}_{pair}")
            taken = np.append(taken, at + radius * np.exp(1j * (middle + np.linspace(-1.3, 1.3, 18))))


def _hinge(desk: Desk, drive: Drive) -> str:
    """The pin at which a drive acts between two moving links."""
    return next(j.point for j in desk.mech.joints if isinstance(j, Revolute) and {j.a, j.b} == drive.pair)


def _arrow_radius(desk: Desk, pivot: complex) -> float:
    """Its radius: not that of a base circle or an offset circle, nor near the arc of a reflex angle."""
    marks = desk.board.marks(View.MECHANISM)
    circles = [m.radius for m in marks if isinstance(m, Arc) and abs(m.centre - pivot) < 1e-6 and m.sweep > 6]
    reflex = [m.radius for m in marks if isinstance(m, AngleMark) and abs(m.at - pivot) < 1e-6 and abs(m.sweep) > np.pi]
    free = (
        r for r in ARROW_RADII if all(abs(r - c) > 1.5 for c in circles) and all(abs(r - c) > APART for c in reflex)
    )
    return next(free, ARROW_RADII[-1])


def _taken(desk: Desk, pivot: complex, drive: Drive) -> Complexes:
    """Points of all lines, of the angle mark and of the ground."""
    ground = pivot + np.array([-3 - 4j, -4j, 3 - 4j])  # within GROUND
    mark = pivot + _arrow_radius(desk, pivot) * np.exp(
        1j * (drive.zero + np.linspace(0.0, swept(drive.position - drive.lead), 18))
    )
    marks = [m for m in desk.board.marks(View.MECHANISM) if isinstance(m, Segment | FixedGuide | Slot)]
    a, b = np.array([m.a for m in marks])[:, None], np.array([m.b for m in marks])[:, None]
    lines = a + (b - a) * np.linspace(0.0, 1.0, 60)
    return np.concatenate([ground, mark, lines.ravel()])


def _free_side(pivot: complex, radius: float, taken: Complexes) -> float:
    """The direction from the pivot in which the arrow stands farthest from all that is taken."""
    taken = taken[
        np.abs(np.abs(taken - pivot) - radius) < radius + GROUND
    ]  # what lies beyond is farther than the ground
    middles, arcs = _arcs(radius)
    clear = _nearest(arcs.ravel(), taken - pivot).reshape(arcs.shape).min(axis=1)
    return float(middles[int(np.argmax(np.round(clear, 6)))])  # of sides as free as each other the first


@lru_cache(maxsize=len(ARROW_RADII))
def _arcs(radius: float) -> tuple[Reals, Complexes]:
    """The directions in which the arrow may stand, and points of it there."""
    middles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    return middles, radius * np.exp(1j * (middles[:, None] + np.linspace(-1.0, 1.0, 9)))


def _nearest(circle: Complexes, taken: Complexes) -> Reals:
    """The square of the distance from each point of a circle about 0 to the nearest of the others:
    |c|² + |t|² − 2 c·t."""
    square = np.column_stack([circle.real, circle.imag]) @ np.vstack([-2.0 * taken.real, -2.0 * taken.imag])
    square += np.abs(taken) ** 2  # in place: new tables of this size take longer than all else here
    nearest: Reals = abs(circle[0]) ** 2 + square.min(axis=1)
    return nearest
