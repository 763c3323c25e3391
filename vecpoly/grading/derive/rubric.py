"""How many points each quantity is worth: a few per part of the solution, shared out over what is asked there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ...foundation.slotted import replace
from ..key import NOTHING, Graded, Kind, Points
from .blocks import ACCELERATION, DIAGRAM, FORCE, OTHER, VELOCITY


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """Points of one part: for its scale, for its lines as drawn (M), for values read (A), for ω and α (A and sense).

    equation: how many of those for lines go to the direction and magnitude rows, where these were filled in.
    """

    scale: float = 0.0
    drawn: float = 0.0
    values: float = 0.0
    rates: float = 0.0
    equation: float = 0.0


def _blocks() -> dict[str, Block]:
    return {
        DIAGRAM: Block(scale=1, drawn=2, values=2),
        VELOCITY: Block(scale=1, drawn=5, values=1, rates=1, equation=2),
        ACCELERATION: Block(scale=1, drawn=7, values=2, rates=2, equation=3),
        FORCE: Block(scale=1, drawn=7, values=2, rates=2, equation=2),
        OTHER: Block(drawn=3, values=5),
    }


@dataclass(frozen=True, slots=True, kw_only=True)
class Rubric:
    """Points by part, and of single quantities where the lecturer says so."""

    blocks: Mapping[str, Block] = field(default_factory=_blocks)
    own: Mapping[str, Points] = field(default_factory=dict)

    @property
    def equations(self) -> dict[str, float]:
        """Part → points of its equations."""
        return {name: block.equation for name, block in self.blocks.items()}


USUAL = Rubric()


def shared(
    rubric: Rubric, graded: Sequence[Graded], scales: Mapping[str, float]
) -> tuple[tuple[Graded, ...], dict[str, float]]:
    """The quantities with their points, and the points of each scale that is used."""
    worth = [one for one in graded if one.asked]  # a length on the way is worth what the lecturer says
    points: dict[str, Points] = {}
    stated: dict[str, float] = {}
    for name in dict.fromkeys(one.block for one in worth):
        block, here = rubric.blocks.get(name, Block()), [one for one in worth if one.block == name]
        points |= _shared(block, here)
        if block.scale and (mu := scale_of(name, graded, scales)):
            stated[mu] = block.scale
    points |= rubric.own
    return tuple(replace(one, points=points.get(one.key, NOTHING)) for one in graded), stated


def scale_of(name: str, graded: Sequence[Graded], scales: Mapping[str, float]) -> str:
    """The scale of what is asked in this part, "" of none; a place off the sheet is found by that of the others."""
    block = [one for one in graded if one.block == name]
    asked = [one for one in block if one.asked]
    placed = any(one.kind is Kind.PLACE for one in asked)
    return next((one.mu for one in (block if placed else asked) if one.mu in scales), "")


def _shared(block: Block, here: Sequence[Graded]) -> dict[str, Points]:
    """Points of the quantities of one part; what nobody can earn goes to the values."""
    drawn = [one for one in here if one.kind in (Kind.READING, Kind.VECTOR, Kind.PLACE)] or list(here)
    rates = [one for one in here if one.kind is Kind.SIGNED]
    values = [one for one in here if one not in rates] or rates
    for_values = block.values + (0.0 if rates else block.rates)
    points: dict[str, Points] = {}
    for one in here:
        method = block.drawn / len(drawn) if one in drawn else 0.0
        accuracy = for_values / len(values) if one in values else 0.0
        rate = block.rates / len(rates) / 2 if one in rates else 0.0
        points[one.key] = Points(method=method, accuracy=accuracy + rate, sense=rate)
    return points
