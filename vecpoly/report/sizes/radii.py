"""On the sketch of a mechanism: the radius of each circle of which the data give it, where the sketch is freest."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import pi, tau

import numpy as np

from ...board.construction import Figure
from ...board.paper.marks import AngleMark, Arc, Disc, GearMark, Ground, Mark, Point, TurnArrow
from ...drawing.symbols.outlines import outlines
from ...foundation.patterns import pattern
from ...problem.problem import Problem
from ...problem.values.seen import Round
from .lines import NARROW, OUT, radius

Circle = Arc | Disc | GearMark

_SYMBOL = r"r_\d(\^?′)?"  # of a link's own circle
_LIKE = 2e-3  # of a radius by which it may be drawn differently
_WAYS = tuple(tau * k / 48 for k in range(48))
_FIRST = 0.15 * pi  # of directions as free as each other the one nearest to this
_SHARES = np.linspace(0.0, 1.0, 25)
_FREE = 7.0  # mm: freer than this is not better
_GROUND = tuple(across - deep * 1j for across in (-4.0, 0.0, 4.0) for deep in (2.0, 5.0, 8.0))  # mm under a pivot


def radii(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """From centre to rim, each circle once."""
    circles = [*_circles(figure)]
    taken = _taken(figure)
    for symbol, size in _given(problem):
        like = [one for one in circles if abs(one.radius * figure.scale.value - size) < _LIKE * size]
        circle = min(like, key=lambda one: one.owner != f"link {symbol[2:3]}", default=None)
        if circle is not None:
            circles.remove(circle)
            drawn = [*radius(circle.centre, circle.radius, _freest(circle, taken), symbol)]
            taken = np.concatenate([taken, *(np.array([mark.at]) for mark in drawn if isinstance(mark, Point))])
            yield from drawn


def _given(problem: Problem) -> Iterator[tuple[str, float]]:
    """Symbols and sizes (m): data of their own, and what words tell of a base circle or of a fixed gear."""
    for datum in problem.given.data:
        if pattern(_SYMBOL).fullmatch(datum.symbol):
            yield datum.symbol, datum.si
        elif isinstance(told := datum.seen, Round):
            yield told.symbol, told.radius


def _circles(figure: Figure) -> Iterator[Circle]:
    for mark in figure.marks:
        if isinstance(mark, Disc | GearMark) or (isinstance(mark, Arc) and abs(mark.sweep) > 6.2):
            yield mark


def _freest(circle: Circle, taken: np.ndarray) -> float:
    """The direction in which the line and its letter are farthest from all else."""

    def clear(turn: float) -> float:
        way, low = cmath.rect(1.0, turn), 0.25 * circle.radius
        high = circle.radius if circle.radius >= NARROW else circle.radius + 2 * OUT
        start = low if circle.radius >= NARROW else circle.radius + 1.0
        line = circle.centre + way * (start + (high - start) * _SHARES)
        return min(_FREE, float(np.abs(line[:, None] - taken).min(initial=_FREE)))

    return max(_WAYS, key=lambda turn: (round(clear(turn), 1), -abs(cmath.phase(cmath.rect(1.0, turn - _FIRST)))))


def _taken(figure: Figure) -> np.ndarray:
    """Places of bars, points, supports, curved arrows and angles."""
    found = [a + (b - a) * _SHARES for a, b in outlines(figure.marks)]
    for mark in figure.marks:
        match mark:
            case Point():
                found.append(np.array([mark.at]))
            case Ground():
                found.append(mark.at + np.array(_GROUND))
            case TurnArrow():
                sweep = 1.8 if mark.ccw else -1.8
                found.append(mark.at + mark.radius * np.exp(1j * (mark.start + sweep * _SHARES)))
            case AngleMark():
                found.append(mark.at + mark.radius * np.exp(1j * (mark.start + mark.sweep * _SHARES)))
            case _:
                pass
    return np.concatenate(found) if found else np.zeros(0, dtype=complex)
