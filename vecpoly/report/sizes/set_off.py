"""On the sketch of a mechanism: points that are set off from a bar by two lengths, and directions by their angles."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from math import degrees

from ...board.construction import Figure
from ...board.paper.marks import AngleMark, Mark, Point
from ...names import subscripted
from ...problem.problem import Problem
from ...problem.values.seen import Leaning, SetOff
from .lines import AXIS, angle, span

_LIKE, _BESIDE, _SMALL = 1e-3, 7.0, 0.02  # of a length that is told; mm from the line to a dimension; rad


def set_off(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """What words give by numbers stands there by its numbers; an angle of a link has its letter."""
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label}
    for datum in problem.given.data:
        match datum.seen:
            case SetOff() as told:
                yield from _beside(told, spots, figure.scale.value)
            case Leaning() as told if told.at in spots and abs(told.turn) > _SMALL:
                yield from angle(spots[told.at], told.turn, in_degrees(told.turn), AXIS)
            case _:
                pass
        if datum.symbol.startswith("φ_"):
            yield from _turned(problem, figure, datum.symbol, datum.si, spots)


def in_degrees(turn: float) -> str:
    """An angle as it stands in its arc, whichever way it is."""
    return f"{abs(degrees(turn)):.6g}°"


def _beside(told: SetOff, spots: Mapping[str, complex], mm: float) -> Iterator[Mark]:
    """The way along the line through its start and that square to it, which together lead to the point; mm: of the
    mechanism, in m, for one on paper."""
    start, point = subscripted(told.start), subscripted(told.point)
    if not {start, point} <= set(spots):
        return
    a, at = spots[start], spots[point]
    way = (at - a) * mm / complex(told.along, told.left)
    if abs(abs(way) - 1.0) < _LIKE:
        way /= abs(way)
        foot = a + way * told.along / mm
        other = -1j * way if told.left > 0 else 1j * way
        yield from span(a, foot, _in_mm(told.along), _BESIDE * other)
        yield from span(foot, at, _in_mm(told.left))


def _in_mm(metres: float) -> str:
    return f"{abs(1e3 * metres):.6g}"


def _turned(problem: Problem, figure: Figure, symbol: str, turn: float, spots: Mapping[str, complex]) -> Iterator[Mark]:
    """φ of a link on the frame that is no crank with an angle of its own: the arm of a train."""
    mech, link = problem.mechanism, symbol.removeprefix("φ_")
    marked = any(isinstance(mark, AngleMark) and mark.label.startswith(symbol) for mark in figure.marks)
    if marked or link not in mech.bodies or abs(turn) < _SMALL:
        return
    points = [point for point in mech.link(link).points if point in spots]
    pivot = next((point for point in points if point in mech.frame), None)
    for point in points if pivot else ():
        if point != pivot and abs(cmath.phase((spots[point] - spots[pivot or ""]) / cmath.rect(1.0, turn))) < _SMALL:
            yield from angle(spots[pivot or ""], turn, symbol, AXIS)
            return
