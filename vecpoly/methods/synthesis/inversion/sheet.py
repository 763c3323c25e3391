"""What stands on the sheet while pins are sought: pins and bodies in all positions, under their letters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ....board.paper.marks import Dot
from ....board.place import Place
from ....board.strokes import NO_LENGTH
from ....designs.inversion.plan import FRAME, Plan
from ....foundation.frozen import FrozenMap
from ....foundation.slotted import replace
from ....plane import Points, cross, nominal, unit
from ....plane.geometry import dot
from ....plane.traced import acts_of, bare, traced
from ....words import Words
from ..draft import SHEET, Draft
from ..linkage import pin, pivot

Places = tuple[Points, ...]
FLAT = 1e-6  # mm: a point nearer to the line of a body is on it
GRAZING = 0.26  # sine (15°) below which two arcs of transfer meet too flatly


@dataclass(frozen=True, slots=True, kw_only=True)
class Stands:
    """Two points of a body on paper: its origin, and one on its line."""

    start: Points
    end: Points

    @property
    def along(self) -> Points:
        """The direction of its line."""
        return unit(self.end - self.start)


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """Where pins and bodies lie, position by position. labels: of pins that are lettered otherwise on the sheet."""

    draft: Draft
    plan: Plan
    pins: Mapping[str, Places]
    bodies: Mapping[str, tuple[Stands, ...]]
    labels: Mapping[str, str] = FrozenMap({})

    def with_pin(self, letter: str, places: Places) -> Sheet:
        """The same with one more pin."""
        return replace(self, pins=FrozenMap({**self.pins, letter: places}))

    def with_body(self, name: str, stands: tuple[Stands, ...]) -> Sheet:
        """The same with one more body."""
        return replace(self, bodies=FrozenMap({**self.bodies, name: stands}))

    def still(self, letter: str) -> bool:
        """Whether a pin is fixed to the frame, or stands still by the data."""
        first, *others = (complex(nominal(at)) for at in self.pins[letter])
        return all(abs(at - first) < NO_LENGTH for at in others)

    def named(self, letter: str, position: int) -> str:
        """A pin in a position as it is lettered: B_2; a fixed one by its letter alone."""
        label = self.labels.get(letter, letter)
        return label if letter in self.pins and self.still(letter) else f"{label}_{position + 1}"

    def on_line(self, point: Points, body: str, position: int) -> bool:
        """Whether a point lies on the line of the body in a position."""
        stands = self.bodies[body][position]
        return _on_line(stands.start, stands.end, point)

    def carried(self, point: Points, body: str, position: int, onto: int, letter: str) -> Points:
        """A point that is rigid with the body, carried with it from one position onto another.

        By arcs about two points of the body; laid off where it is on their line; where the arcs would meet too flatly,
        as a corner of the same figure.
        """
        if body == FRAME or position == onto:
            return point
        here, there = self.bodies[body][position], self.bodies[body][onto]
        return transferred(self.draft, (here.start, here.end, point), (there.start, there.end), letter)


def transferred(
    draft: Draft, of: tuple[Points, Points, Points], on: tuple[Points, Points], letter: str, place: Place = SHEET
) -> Points:
    """The third corner of a triangle on another place of its base, of the same hand."""
    p, q, corner = of
    board = draft.board
    legs = unit(corner - p) if _far(corner, p) else unit(q - p), unit(corner - q) if _far(corner, q) else unit(p - q)
    if _on_line(p, q, corner):  # either way
        way = np.where(bare(dot(q - p, corner - p)) > 0, 1.0, -1.0)
        return board.lay_off(on[0], way * unit(on[1] - on[0]), np.abs(corner - p))
    radii = np.abs(corner - p), np.abs(corner - q)
    what = Words(f"转移 ${letter}$", f"carrying ${letter}$ over")
    if abs(float(nominal(cross(*legs)))) < GRAZING:
        met = board.image(of, on)
    else:
        met = of_each(bare(cross(q - p, corner - p)) > 0, *board.arcs(on[0], radii[0], on[1], radii[1], what))
    for centre, radius in zip(on, radii, strict=True):
        board.swing(place, centre, radius, met)
    return met


def _on_line(p: Points, q: Points, point: Points) -> bool:
    return abs(float(nominal(cross(unit(q - p), point - p)))) < FLAT


def of_each(first: Any, one: Points, other: Points) -> Points:
    """Of two places the one, or by those hands for which `first` is not so, the other."""
    if np.all(first):
        return one
    return traced(np.where(first, bare(one), bare(other)), acts_of(one, other)) if np.any(first) else other


def _far(one: Points, other: Points) -> bool:
    return abs(complex(nominal(one - other))) > 1e-9


def placed(draft: Draft, at: complex) -> Points:
    """A place given by coordinates (m), set out from the origin."""
    if at == 0:
        return np.complex128(0)
    return draft.board.lay_off(0j, at / abs(at), draft.mm(abs(at)))


def lettered(draft: Draft, letter: str, places: Places, dot: Dot = Dot.JOINT) -> Places:
    """The places of a pin get their letters: one where it is fixed, else with the number of the position."""
    if len({complex(nominal(at)) for at in places}) == 1:
        return (pivot(draft, letter, places[0]),) * len(places)
    return tuple(pin(draft, f"{letter}_{n}", at, dot) for n, at in enumerate(places, 1))
