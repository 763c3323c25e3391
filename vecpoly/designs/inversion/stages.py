"""A linkage that is found pin after pin, each by what the one before has given: six-bars of two inversions."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import partial
from typing import Any, ClassVar

from pydantic import Field, model_validator

from ...devices.base import Length
from ...names import Named
from ...words import Words
from ..base import Design
from ..ranged.datum import Datum, of_point, put_in, quantity
from .assembling import Assembly
from .chain import chain
from .plan import Find, Plan
from .step import Step
from .told import Pieces, stages_task
from .written import Direction, Place, Point, told_angle


class Stages(Design):
    """frame: fixed pivots; links: lengths that are given; rays: links known by the directions of a line of theirs
    (AB: from A), the driver first; points: pins known by their places on a guide; stages: what is found, in order."""

    kind: ClassVar[str] = "stages"
    frame: dict[str, Place]
    links: dict[str, Length] = Field(default_factory=dict)
    rays: dict[str, tuple[Direction, ...]]
    points: dict[str, tuple[Place, ...]] = Field(default_factory=dict)
    stages: tuple[Step, ...]

    @model_validator(mode="after")
    def _whole(self) -> Stages:
        self.plan()
        return self

    def varied(self) -> Iterator[Datum[Design]]:
        """The lengths of links, the fixed pivots but the first, the last direction of each ray."""
        for letters, length in self.links.items():
            name, longer = Words.same(letters), partial(self._longer, letters)
            yield Datum(name=name, unit="mm", value=length.si, put=longer)
        for letter, place in [*self.frame.items()][1:]:
            yield from of_point(Words.same(letter), place.at, partial(self._moved, letter))
        for letters, angles in self.rays.items():
            name = Words(f"{letters} 的末一方向角", f"the last direction of {letters}")
            yield Datum(name=name, unit="deg", value=angles[-1].si, put=partial(self._turned, letters))

    def _longer(self, letters: str, si: float) -> Design:
        return put_in(self, "links", letters, quantity(si))

    def _moved(self, letter: str, at: complex) -> Design:
        return put_in(self, "frame", letter, Point(at, f"{at:.17g}"))

    def _turned(self, letters: str, si: float) -> Design:
        return put_in(self, "rays", letters, (*self.rays[letters][:-1], quantity(si)))

    def task(self, asked: Collection[str]) -> Words:
        """What is given of which link, and what is found one after another."""
        ahead = [key.removeprefix("delta_") for key in asked if key.startswith("delta_")]
        steps = [step.told(self.plan().count) for step in self.stages]
        given = Pieces(
            frame=tuple(self.frame), links=tuple(self.links), rays=tuple(self.rays), points=tuple(self.points)
        )
        return stages_task(given, steps, ahead)

    def quantities(self) -> tuple[Named, ...]:
        """The lengths of all links that are found, loop by loop; by how much pins are ahead of the lines of links."""
        plan = self.plan()
        lengths = tuple(Named(one + two, f"l_{{{one}{two}}}", "mm") for one, two in plan.bars())
        pins = (stage.pin for stage in plan.stages if isinstance(stage, Find) and plan.turns(stage.on))
        return (*lengths, *(Named(f"delta_{pin}", f"δ_{{{pin}}}", "deg") for pin in pins))

    def built(self, values: Mapping[str, float]) -> dict[str, Any] | None:
        """The linkage in the first position, its first ray, or its crank, driving it."""
        return chain(self.plan(), values, self.omega)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Pivots, lengths, rays and points."""
        pins = tuple((letter, place.text) for letter, place in self.frame.items())
        links = tuple((f"l_{{{letters}}}", length.text) for letters, length in self.links.items())
        rays = tuple((f"φ_{{{letters}}}", ", ".join(map(told_angle, angles))) for letters, angles in self.rays.items())
        points = tuple(
            (f"{letter}_{{{n}}}", place.text)
            for letter, places in self.points.items()
            for n, place in enumerate(places, 1)
        )
        return (*pins, *links, *rays, *points, *(one for step in self.stages for one in step.given()))

    @property
    def size(self) -> float:
        """The extent of what is given."""
        at = [place.at for place in self.frame.values()]
        at += [place.at for places in self.points.values() for place in places]
        lengths = [length.si for length in self.links.values()]
        return max(2 * max(abs(p - at[0]) for p in at), *lengths, 0.01)

    def plan(self) -> Plan:
        """The plan that these stages are."""
        frame = {letter: place.at for letter, place in self.frame.items()}
        links = {letters: length.si for letters, length in self.links.items()}
        rays = {letters: tuple(angle.si for angle in angles) for letters, angles in self.rays.items()}
        points = {letter: tuple(place.at for place in places) for letter, places in self.points.items()}
        return Assembly(frame, links, rays, points).plan(self.stages)
