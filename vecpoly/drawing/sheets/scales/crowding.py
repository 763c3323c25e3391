"""How much room a figure takes with its details at any scale, which tells what crowds."""

from __future__ import annotations

from dataclasses import fields
from functools import lru_cache

import numpy as np

from ....board.construction import Figure
from ....board.paper.extent import bounds
from ....board.paper.marks import Role, Segment, Vector
from ....board.paper.scales import Sketched
from ....foundation.slotted import dataclass
from ...details.knot import Knot
from ...details.knots import MOST, Crowd
from ...details.room import Grow, Room, Spots, filled, reach_of, spread
from ...rect import Rect
from ..lettering import SHORTEST, UNDER
from ..slicing import Size

LETTERS = 3.0  # mm that letters stand out from the lines of a figure, or from the ring of a detail
SLACK = 5.0  # mm by which a figure may turn out larger with its details, whose letters have no places yet
BEYOND = 9.0  # mm that the letters of a direction take beyond its line
NAMED = UNDER - 6.0  # mm: title below a detail, without a scale
FOOT = 0.85  # of what stands round a figure in height: title and scale below it


@dataclass(frozen=True, slots=True, kw_only=True)
class Crowded(Sketched):
    """A sketched figure with its details. crowd: what may be too near; lines: the ends of its lines; low: its lower
    left corner; grow: in which direction rather; most: how many."""

    crowd: Crowd
    lines: tuple[tuple[complex, complex], ...]
    low: complex
    grow: Grow = Grow.LEAST
    most: int = MOST

    def at(self, scale: float) -> Size:
        """Width and height at another scale, with the details that are drawn then."""
        return _sized(self, scale) if self.knots(scale) else Sketched.at(self, scale)

    def _sized(self, scale: float) -> Size:
        size, times, knots = Sketched.at(self, scale), self._times(scale), self.knots(scale)
        across, up = self.around
        corner = self.low * times - complex(across / 2, FOOT * up)
        box = Rect(corner.real, corner.imag, corner.real + size[0], corner.imag + size[1])
        details = [_box(knot) for knot in knots]
        room = Room.about(box, [_foot(box), *self._ink(times)], reach_of(details))
        for one, knot in zip(details, knots, strict=True):
            room.put(one, knot.centre, self.grow)
        return room.extents.width + SLACK, room.extents.height + SLACK

    def knots(self, scale: float) -> tuple[Knot, ...]:
        """What is drawn apart at this scale."""
        return _knots(self.crowd, self._times(scale))[: self.most]

    def _times(self, scale: float) -> float:
        return self.scale / scale if self.of is not None else 1.0

    def _ink(self, times: float) -> list[Spots]:
        """Where nothing else may stand: its lines, with their letters."""
        sides = (0j, LETTERS, -LETTERS, 1j * LETTERS, -1j * LETTERS)
        ends: Spots = np.multiply(times, np.array(self.lines, np.complex128).reshape(-1, 2), dtype=np.complex128)
        return [spread(ends + side) for side in sides]


def crowded(one: Sketched, figure: Figure) -> Crowded:
    """The sketched figure with its details."""
    lines = tuple((m.a, _end(m)) for m in figure.marks if isinstance(m, Segment | Vector))
    kept = {field.name: getattr(one, field.name) for field in fields(Sketched)}
    return Crowded(**kept, crowd=Crowd.of(figure), lines=lines, low=bounds(figure.marks)[0])


def _end(mark: Segment | Vector) -> complex:
    """Where a line ends with its letters, if they stand beyond it."""
    along = mark.b - mark.a
    return (
        mark.b + BEYOND * along / abs(along)
        if isinstance(mark, Segment) and mark.role is Role.DIRECTION and along
        else mark.b
    )


@lru_cache(maxsize=512)
def _sized(one: Crowded, scale: float) -> Size:
    return one._sized(scale)


@lru_cache(maxsize=512)
def _knots(crowd: Crowd, times: float) -> tuple[Knot, ...]:
    return crowd.times(times).knots


def _box(knot: Knot) -> Rect:
    """The room that a detail takes, about the place of its ring."""
    across = 2 * knot.radius * knot.factor
    return Rect(0.0, 0.0, max(across + 2 * LETTERS, SHORTEST), across + LETTERS + NAMED)


def _foot(box: Rect) -> Spots:
    """Title and scale."""
    middle = box.centre.real
    return filled(Rect(middle - SHORTEST / 2, box.y0, middle + SHORTEST / 2, box.y0 + UNDER))
