"""Names along lines; and the numbers of links: along a bar clear of its joints, beside the outline of a block."""

from __future__ import annotations

import cmath
from itertools import pairwise
from math import tau

from ...board.paper.marks import Block, Disc, Dot, GearMark, LinkNumber, Mark, Passing, Plate, Point
from ...foundation.slotted import replace
from ..style import RESULT
from ..symbols.bodies import block_corners
from ..symbols.shapes import NEAR
from .want import Piece, Thing, Want

FRACTIONS = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82)
RINGS, AROUND = (0.6, 1.0), 12  # of the radius of a disc at which its number may stand, and where about its centre
FIRST, CHORDS, SMALL = 0.625, 36, 5.0  # of a turn: where the number of a wheel stands first; points of its rim; mm
_ROOM, _ASIDE = 5.0, 0.35  # mm from the middle of a plate to its sides, for a number; of the way to a corner
REACH = 4.0  # mm from a bar to the middle of its number
OFF_BAR = 0.55  # mm of white that a number keeps of its bar beyond what letters keep of lines: 1.5 as a rule
ON = 0.3  # mm: a joint so near to a bar, as an unsteady hand finds it, lies on it


def along_line(a: complex, b: complex, radius: float, pieces: tuple[Piece, ...], thing: Thing) -> Want:
    """A name on either side of a line, first of all beside its middle."""
    if abs(b - a) < NEAR:
        return Want(pieces, (a,), (0j,), radius, (a, a), thing=thing)
    n = 1j * (b - a) / abs(b - a)
    feet = tuple(a + (b - a) * f for f in FRACTIONS)
    return Want(pieces, feet, (n,) * len(feet), radius, (a, b), thing=thing)


def under(a: complex, b: complex, deep: float, piece: Piece) -> Want:
    """A number beside the hatching of a fixed guide, which is so deep to the right of it."""
    want = along_line(a, b, deep, (piece,), Thing.LINK)
    return replace(want, normals=tuple(-way for way in want.normals), one_sided=True)


def number_of_link(mark: LinkNumber, piece: Piece, marks: tuple[Mark, ...], keep: float) -> Want:
    """The number of a link: of a block beside its outline, of a disc in it, of a roller beside it, of a plate in it, of
    a bar beside its longest piece between two joints, not where that runs over the plate of another link."""
    a, b = mark.a, mark.b
    plates = [m for m in marks if isinstance(m, Plate)]
    if (own := next((m for m in plates if m.owner == mark.owner and _is_roomy(m)), None)) is not None:
        return _in_plate(own, piece)
    if abs(b - a) < NEAR:
        discs = (m for m in marks if isinstance(m, Disc) and m.owner == mark.owner)
        if (disc := min(discs, key=lambda one: abs(one.centre - a), default=None)) is not None:
            pinned = abs(disc.centre - a) < NEAR
            return _outside_bodies(_at_roller(disc, piece), mark.owner, marks) if pinned else _in_disc(disc, a, piece)
        wheels = (m for m in marks if isinstance(m, GearMark) and m.owner == mark.owner and m.radius > SMALL)
        if (wheel := next(wheels, None)) is not None:
            return _at_rim(wheel, a, piece)
        blocks = (m for m in marks if isinstance(m, Block) and m.owner == mark.owner and abs(m.at - a) < NEAR)
        block = next(blocks, None)
        return along_line(a, b, keep, (piece,), Thing.LINK) if block is None else _beside_block(block, piece)
    ends = sorted({0.0, 1.0, *_joints_between(a, b, marks)})
    start, end = max(pairwise(ends), key=lambda part: part[1] - part[0])
    want = along_line(a + (b - a) * start, a + (b - a) * end, keep, (piece,), Thing.LINK)
    return _outside_bodies(replace(want, own=(a, b), clear=OFF_BAR), mark.owner, marks)


def _outside_bodies(want: Want, owner: str, marks: tuple[Mark, ...]) -> Want:
    """Where the bar runs over the body of another link, its number stands beside a piece that does not, if any."""
    bodies = [mark.points for mark in marks if isinstance(mark, Plate) and mark.owner != owner]
    spots = zip(want.feet, want.normals, strict=True)
    sides = (-REACH, 0.0, REACH)
    free = [(z, n) for z, n in spots if not any(_holds(body, z + by * n) for body in bodies for by in sides)]
    if not free or len(free) == len(want.feet):
        return want
    feet, normals = zip(*free, strict=True)
    return replace(want, feet=feet, normals=normals)


def _holds(body: tuple[complex, ...], at: complex) -> bool:
    """Whether a point lies within a polygon: whether its corners go round it."""
    seen = [corner - at for corner in body]
    if any(abs(z) < NEAR for z in seen):
        return True
    turned = sum(cmath.phase(after / before) for before, after in pairwise((*seen, seen[0])))
    return abs(turned) > 1.0


def _joints_between(a: complex, b: complex, marks: tuple[Mark, ...]) -> list[float]:
    """Where along a -> b joints and points are drawn on it, as shares of its length."""
    found = []
    for mark in marks:
        if isinstance(mark, Passing | Block) or (isinstance(mark, Point) and mark.dot is not Dot.NONE):
            along = (mark.at - a) / (b - a)
            if abs(along.imag * (b - a)) < ON and ON < along.real * abs(b - a) < abs(b - a) - ON:
                found.append(along.real)
    return found


def _in_plate(plate: Plate, piece: Piece) -> Want:
    """First of all in its middle."""
    feet = _feet_in(plate)
    rim = (*plate.points, plate.points[0])
    return Want((piece,), feet, (0j,) * len(feet), 0.0, (feet[0], feet[0]), thing=Thing.LINK, bow=rim)


def _in_disc(disc: Disc, at: complex, piece: Piece) -> Want:
    """First of all where it was put, as far from the pin as the disc is large."""
    ring = [cmath.rect(disc.radius, cmath.phase(at - disc.centre) + tau * k / AROUND) for k in range(AROUND + 1)]
    feet = (at, *(disc.centre + share * out for share in RINGS for out in ring[:-1]))
    rim = tuple(disc.centre + out for out in ring)
    return Want((piece,), feet, (0j,) * len(feet), RESULT / 2, (at, at), thing=Thing.LINK, bow=rim)


def _at_roller(roller: Disc, piece: Piece) -> Want:
    """Outside a disc that is pinned in its middle, where its pin has its letter."""
    out = tuple(cmath.rect(1.0, tau * (FIRST + k / AROUND)) for k in _both_ways(AROUND))
    feet = tuple(roller.centre + roller.radius * u for u in out)
    rim = tuple(roller.centre + cmath.rect(roller.radius, tau * k / CHORDS) for k in range(CHORDS + 1))
    return Want((piece,), feet, out, RESULT / 2, (feet[0], feet[0]), thing=Thing.LINK, bow=rim, one_sided=True)


def _at_rim(wheel: GearMark, at: complex, piece: Piece) -> Want:
    """On either side of the pitch circle: about the shaft wheels of one axis could not be told apart, nor the frame."""
    start = cmath.phase(at - wheel.centre) if abs(at - wheel.centre) > NEAR else tau * FIRST
    out = tuple(cmath.rect(1.0, start + tau * k / AROUND) for k in _both_ways(AROUND))
    feet = tuple(wheel.centre + wheel.radius * u for u in out)
    rim = tuple(wheel.centre + cmath.rect(wheel.radius, tau * k / CHORDS) for k in range(CHORDS + 1))
    return Want((piece,), feet, out, RESULT / 2, (feet[0], feet[0]), thing=Thing.LINK, bow=rim)


def _both_ways(count: int) -> list[int]:
    """0, 1, -1, 2, -2 ..."""
    return sorted(range(1 - count // 2, count // 2 + 1), key=abs)


def _beside_block(block: Block, piece: Piece) -> Want:
    corners = block_corners(block)
    outline = (*corners, corners[0])
    return Want((piece,), corners, (0j,) * 4, RESULT / 2, (corners[0], corners[1]), thing=Thing.LINK, bow=outline)


def _is_roomy(plate: Plate) -> bool:
    """Whether a number has room in its middle."""
    middle = _middle(plate)
    return len(plate.points) > 2 and all(_gap(middle, a, b) >= _ROOM for a, b in _sides(plate))


def _feet_in(plate: Plate) -> tuple[complex, ...]:
    """The places for a number in a plate: its middle, then towards its corners."""
    middle = _middle(plate)
    return middle, *(middle + _ASIDE * (corner - middle) for corner in plate.points)


def _middle(plate: Plate) -> complex:
    return sum(plate.points) / len(plate.points)


def _sides(plate: Plate) -> list[tuple[complex, complex]]:
    return [*zip(plate.points, (*plate.points[1:], plate.points[0]), strict=True)]


def _gap(at: complex, a: complex, b: complex) -> float:
    """From a place to the line through two corners."""
    return abs(((at - a) * (b - a).conjugate()).imag) / (abs(b - a) or 1.0)
