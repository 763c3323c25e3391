"""On the sketch of a mechanism: points that are set off from a bar by two lengths, and directions by their angles."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from math import radians

from ...board.construction import Figure
from ...board.paper.marks import AngleMark, Mark, Point
from ...foundation.patterns import pattern
from ...problem.problem import Problem
from .lines import AXIS, angle, span

_OFF = (
    r"\$(\w+)\$ lies ([\d.]+) mm from \$(\w+)\$ along ([^.;]+?)( produced backwards)? "
    r"and ([\d.]+) mm to its (left|right)"
)
_TO_X = r"\$(\w)(\w)\$ is at ([−-]?[\d.]+)° to the \$x\$ axis"
_GUIDE = r"the guide through \$(\w)\$ is at ([−-]?[\d.]+)° to the horizontal"
_LIKE, _BESIDE, _SMALL = 1e-3, 7.0, 0.02  # of a length that is told; mm from the line to a dimension; rad


def set_off(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """What words give by numbers stands there by its numbers; an angle of a link has its letter."""
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label}
    for datum in problem.given.data:
        told = datum.of("en") if datum.words is not None else ""
        for name, along, start, _, back, off, side in pattern(_OFF).findall(told):
            if {name, start} <= set(spots):
                sizes = float(along) * (-1 if back else 1), float(off) * (1 if side == "left" else -1)
                yield from _beside(spots[start], spots[name], sizes, 1e3 * figure.scale.value)
        for at, _, size in pattern(_TO_X).findall(told):
            yield from _from_horizontal(spots, at, size)
        for at, size in pattern(_GUIDE).findall(told):
            yield from _from_horizontal(spots, at, size)
        if datum.symbol.startswith("φ_"):
            yield from _turned(problem, figure, datum.symbol, datum.si, spots)


def _beside(a: complex, at: complex, sizes: tuple[float, float], mm: float) -> Iterator[Mark]:
    """The way along the line through `a` and that square to it, which together lead to `at`; mm: of the mechanism, for
    one on paper."""
    way = (at - a) * mm / complex(*sizes)
    if abs(abs(way) - 1.0) < _LIKE:
        way /= abs(way)
        foot = a + way * sizes[0] / mm
        other = -1j * way if sizes[1] > 0 else 1j * way
        yield from span(a, foot, f"{abs(sizes[0]):g}", _BESIDE * other)
        yield from span(foot, at, f"{abs(sizes[1]):g}")


def _from_horizontal(spots: Mapping[str, complex], at: str, size: str) -> Iterator[Mark]:
    turn = radians(float(size.replace("−", "-")))
    if at in spots and abs(turn) > _SMALL:
        yield from angle(spots[at], turn, f"{size.lstrip('−-')}°", AXIS)


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
