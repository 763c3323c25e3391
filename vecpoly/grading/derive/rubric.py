"""How many points each quantity is worth: a few per part of the solution, shared out over what is asked there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import inf

from ...foundation.slotted import replace
from ..key import NOTHING, Graded, Kind, Points
from .blocks import ACCELERATION, DIAGRAM, FORCE, OTHER, VELOCITY

POLYGON = 4.0  # points of one quantity that stands for lines of a polygon, at most: a fifth of twenty
SINGLE = 2.0  # of any other: a ratio, an angle, a moment that is worked out, a place
_SEEN = (Kind.READING, Kind.VECTOR, Kind.PLACE, Kind.LINE)


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """Points of one part: for its scale, for its lines as drawn (M), for values read (A), for ω and α (A and sense).

    equation: how many of those for lines go to the direction and magnitude rows, where these were filled in.
    line, single: what one quantity that stands for lines, or any other, is worth at most.
    """

    scale: float = 0.0
    drawn: float = 0.0
    values: float = 0.0
    rates: float = 0.0
    equation: float = 0.0
    line: float = inf
    single: float = inf


def _blocks() -> dict[str, Block]:
    return {
        DIAGRAM: Block(scale=1, drawn=2, values=2, line=SINGLE, single=SINGLE),
        VELOCITY: Block(scale=1, drawn=5, values=1, rates=1, equation=2, line=POLYGON, single=SINGLE),
        ACCELERATION: Block(scale=1, drawn=7, values=2, rates=2, equation=3, line=POLYGON, single=SINGLE),
        FORCE: Block(scale=1, drawn=6, values=2, rates=3, equation=2, line=POLYGON, single=SINGLE),
        OTHER: Block(drawn=3, values=5, line=SINGLE, single=SINGLE),
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
    found = {one.key: one for one in graded}
    points: dict[str, Points] = {}
    stated: dict[str, float] = {}
    for name in dict.fromkeys(one.block for one in worth):
        block, here = rubric.blocks.get(name, Block()), [one for one in worth if one.block == name]
        points |= _shared(block, here, found)
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


def _shared(block: Block, here: Sequence[Graded], found: Mapping[str, Graded]) -> dict[str, Points]:
    """Points of the quantities of one part; what nobody can earn goes to the values."""
    standing = _for_lines(here, found)
    drawn = standing or [one.key for one in here]
    rates = [one for one in here if one.kind is Kind.SIGNED]
    values = [one for one in here if one not in rates] or rates
    for_values = block.values + (0.0 if rates else block.rates)
    points: dict[str, Points] = {}
    for one in here:
        method = block.drawn / len(drawn) if one.key in drawn else 0.0
        accuracy = for_values / len(values) if one in values else 0.0
        rate = block.rates / len(rates) / 2 if one in rates else 0.0
        points[one.key] = Points(method=method, accuracy=accuracy + rate, sense=rate)
    to_scale = [one.key for one in here if one.key in standing and (one.mu or _lines(one, found))]
    return _bounded(points, {one.key: block.line if one.key in to_scale else block.single for one in here})


def _for_lines(here: Sequence[Graded], found: Mapping[str, Graded]) -> list[str]:
    """The quantities that stand for lines of this part: what is read off its figure, and what is computed from lines
    for which none of these stands, as ω_2 is where v_CB is not asked."""
    seen = [one for one in here if one.kind in _SEEN or (one.kind is Kind.SCALAR and one.mu)]
    told = {one.line for one in seen}
    return [one.key for one in here if one in seen or _lines(one, found) - told]


def _lines(one: Graded, found: Mapping[str, Graded]) -> set[str]:
    """The lengths on the figure of its part from which a quantity is computed; none where it is one of areas."""
    below = [found[name] for name in (one.line, *one.needs) if name in found]
    if any(each.unit == "mm^2" for each in below):
        return set()
    return {each.key for each in below if each.kind is Kind.READING and each.block == one.block}


def _bounded(points: Mapping[str, Points], most: Mapping[str, float]) -> dict[str, Points]:
    """No quantity with more than it may have: what is above goes to the others, for the way, as far as these have
    room."""
    bounded = {name: _cut(one, most[name]) for name, one in points.items()}
    above = sum(one.total for one in points.values()) - sum(one.total for one in bounded.values())
    while above > 1e-9 and (open_ones := [name for name, one in bounded.items() if one.total < most[name] - 1e-9]):
        each = above / len(open_ones)
        for name in open_ones:
            more = min(each, most[name] - bounded[name].total)
            bounded[name] = replace(bounded[name], method=bounded[name].method + more)
            above -= more
    return bounded


def _cut(one: Points, most: float) -> Points:
    """In the same shares, no more than this."""
    share = min(1.0, most / one.total) if one.total else 1.0
    return Points(method=one.method * share, accuracy=one.accuracy * share, sense=one.sense * share)
