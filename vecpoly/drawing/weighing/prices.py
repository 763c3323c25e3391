"""What the places of a label cost by themselves, by what they stand on."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...foundation.slotted import dataclass
from ..labels.about.bounds import Complexes, Floats, Indices
from ..labels.about.obstacles import Obstacles
from ..labels.leading import alongside
from ..labels.rivals import Named, misled
from ..labels.spots import Spots, ends
from ..labels.want import BREAKING, Line, Spot, Want
from ..scene import Rect

BEYOND_FRAME = 60.0  # a mm beyond the allowed frame
IN_CROWD = 0.3  # so much of its price has what a leader crosses in a crowd: better that than a letter on a line


@dataclass(frozen=True, slots=True)
class Around:
    """What stands about the labels of a figure: lines and solids, other things to name, the drawn extents, a frame;
    whether it is a polygon, of which the table of its equation tells directions."""

    obstacles: Obstacles
    wanted: tuple[Want, ...]
    drawn: Rect
    frame: Rect | None
    unnamed: tuple[Spot, ...] = ()  # points without a letter
    grounds: tuple[Line, ...] = ()  # edges of hatching, beside which a number is taken for the frame's
    polygon: bool = False


@dataclass(frozen=True, slots=True)
class Stand:
    """What each of some places stands on: lines and solids there, those between it and what is named, or that its
    leader crosses; and what it could be taken to name."""

    under: Floats
    between: Floats
    misled: Floats

    def price(self, want: Want, spots: Spots, led: bool, frame: Rect | None) -> Floats:
        """All this together, for a label that has no other place in a crowd, or for another."""
        cost = self.under + (self.between * (IN_CROWD if led and want.farther else 1.0) + self.misled)
        return cost if frame is None else cost + BEYOND_FRAME * beyond(want, spots.centre, frame)

    def some(self, which: Indices) -> Stand:
        """That of some of them, or of them in another order."""
        return Stand(self.under[which], self.between[which], self.misled[which])


Some = tuple[Want, Spots]  # places of one label


def stands(around: Around, near: Sequence[Some], led: Sequence[Some]) -> list[Stand]:
    """What places beside what is named, and then those on a leader, stand on; of many labels of one figure together."""
    if not near and not led:
        return []
    obstacles = around.obstacles
    under = priced(obstacles, [(want, spots.centre) for want, spots in (*near, *led)])
    between = (*_parted(obstacles, near), *_crossed(obstacles, led))
    named = Named.by(around.wanted, around.unnamed, around.grounds) if near else None
    wrong = [misled(want, named, spots.centre) for want, spots in near] if named else []
    wrong += [alongside(want, obstacles, spots) for want, spots in led]
    return [Stand(*one) for one in zip(under, between, wrong, strict=True)]


def priced(obstacles: Obstacles, places: Sequence[tuple[Want, Complexes]]) -> list[Floats]:
    """What the lines and solids of a figure cost each label at each of its places."""
    counts = [len(centre) for _, centre in places]
    own = _repeated([want.own for want, _ in places], counts)
    size = np.repeat([complex(want.width, want.height) for want, _ in places], counts)
    breaks = np.repeat([want.thing in BREAKING for want, _ in places], counts)
    centre = np.concatenate([centre for _, centre in places])
    groups = _groups(counts)
    cost = obstacles.cost(centre, size, (own[:, 0], own[:, 1]), groups, breaks)
    return [cost[some] for some in groups]


def _parted(obstacles: Obstacles, near: Sequence[Some]) -> list[Floats]:
    """What stands between each place and what is named."""
    if not near:
        return []
    counts = [len(spots.centre) for _, spots in near]
    own, groups = _repeated([want.own for want, _ in near], counts), _groups(counts)
    keep = np.repeat([want.radius for want, _ in near], counts)
    root, centre = (np.concatenate(ends) for ends in zip(*((s.root, s.centre) for _, s in near), strict=True))
    cost = obstacles.parted(root, keep, centre, (own[:, 0], own[:, 1]), groups)
    return [cost[some] for some in groups]


def _crossed(obstacles: Obstacles, led: Sequence[Some]) -> list[Floats]:
    """What the leader of each place crosses."""
    if not led:
        return []
    counts = [len(spots.centre) for _, spots in led]
    own, groups = _repeated([want.own for want, _ in led], counts), _groups(counts)
    foot, end = (np.concatenate(ends) for ends in zip(*(_leaders(*one) for one in led), strict=True))
    cost = obstacles.crossings(foot, end, (own[:, 0], own[:, 1]), groups)
    return [cost[some] for some in groups]


def _leaders(want: Want, spots: Spots) -> tuple[Complexes, Complexes]:
    """Where the leader of each place starts and ends."""
    return spots.foot, ends(spots.foot, spots.centre, complex(want.width / 2, want.height / 2))


def _repeated(pairs: Sequence[tuple[complex, complex]], counts: Sequence[int]) -> Complexes:
    return np.repeat(np.array(pairs, dtype=complex), counts, axis=0)


def _groups(counts: Sequence[int]) -> list[slice]:
    ends = np.cumsum(counts).tolist()
    return [slice(end - count, end) for count, end in zip(counts, ends, strict=True)]


def beyond(want: Want, centre: Complexes, rect: Rect) -> Floats:
    """How far a label at each of these places sticks out of a rectangle, mm."""
    x, y, w, h = centre.real, centre.imag, want.width / 2, want.height / 2
    out: Floats = np.maximum(rect.x0 - (x - w), 0.0)
    for side in (x + w - rect.x1, rect.y0 - (y - h), y + h - rect.y1):
        out += np.maximum(side, 0.0)
    return out
