"""On the sketch of a mechanism: how far a block stands from the letter from which its travel is told to count."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...board.construction import Figure
from ...board.paper.marks import Mark, Point, Role, Segment
from ...mechanism.model import Prismatic
from ...problem.problem import Problem
from .lines import NEAR, span

_BESIDE = 9.0  # mm from the line along which the pin moves to the dimension
_LIKE = 1e-3  # of its distance from there by which it may be drawn differently


def travels(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """s_1 along the guide from K, or from where the parallel through the pin is nearest to K."""
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label}
    travelled = {datum.symbol: datum.si for datum in problem.given.data if datum.symbol.startswith("s_")}
    for joint in (one for one in problem.mechanism.joints if isinstance(one, Prismatic)):
        size = travelled.get(f"s_{joint.block}", 0.0) / figure.scale.value
        if abs(size) < NEAR or not {joint.pin, joint.through} <= set(spots):
            continue
        pin, start = spots[joint.pin], spots[joint.through]
        way = (pin - start) / complex(size, joint.offset / figure.scale.value)
        if abs(abs(way) - 1.0) < _LIKE:
            way /= abs(way)
            foot = pin - way * size
            if abs(foot - start) > NEAR:
                yield Segment(a=start, b=foot, role=Role.CONSTRUCTION, step=1)
            yield from span(foot, pin, f"s_{joint.block}", _freer(spots.values(), pin, way))


def _freer(spots: Iterable[complex], pin: complex, way: complex) -> complex:
    """Away from the line on the side on which fewer letters stand."""
    sides = [((spot - pin) / way).imag for spot in spots]
    left = sum(side > NEAR for side in sides) <= sum(side < -NEAR for side in sides)
    return _BESIDE * way * (1j if left else -1j)
