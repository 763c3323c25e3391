"""Which line is which vector: one optimal assignment on name, direction, length and connection; never greedy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from ..expected import NOTHING, Edge, Shape
from ..segment import Segment
from .fit import Fit

SIZE, PLACE, REVERSED, BARE, NEEDLESS = 0.6, 0.4, 0.1, 0.08, 0.06  # weights of what disagrees
NAMED, LEFT = 1.0, 0.68  # for the right name; of a line that is none of the vectors, or a vector that is not there
PART, MM, PLACE_MM = 0.15, 1.0, 4.0  # of a vector's length, and mm, at which half of a weight is lost
HUNG, FAR_OFF = 6.0, 10.0  # mm: an end that is where it should be; of lines that share none
LONE = 0.3  # of a line with a head that nothing answers to

Matrix = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Match:
    """The line of each vector (by its first quantity), the optional lines, and the lines that are neither.

    cost: how badly the drawing fits what it was compared with.
    """

    lines: Mapping[str, Segment]
    optional: tuple[tuple[Edge, Segment], ...]
    extra: tuple[Segment, ...]
    cost: float


def assigned(fit: Fit, shape: Shape) -> Match:
    """The best assignment of the lines of a figure to its vectors as they should be, or as a mistake makes them."""
    edges = [*shape.edges, *_needless(shape)]
    heads = any(one.headed for one in fit.lines)
    costs = _costs(fit, shape.name, edges, heads)
    full = np.hstack([costs, np.full((len(fit.lines), len(fit.lines)), LEFT)])
    rows, columns = linear_sum_assignment(full)
    lines: dict[str, Segment] = {}
    optional: list[tuple[Edge, Segment]] = []
    extra: list[Segment] = []
    for i, j in zip(rows, columns, strict=True):
        one = fit.lines[i]
        if j >= len(edges):
            extra.append(one)
        elif edges[j].key:
            lines[edges[j].key] = one if one.headed else _likely(one, edges[j], heads)
        else:
            optional.append((edges[j], one))
    cost = float(full[rows, columns][[j < len(edges) and bool(edges[j].key) for j in columns]].sum())
    cost += LEFT * (len(shape.edges) - len(lines)) + LONE * sum(one.headed for one in extra)
    _hung(lines, extra, shape, fit, heads)
    return Match(lines=lines, optional=tuple(optional), extra=tuple(extra), cost=cost)


def _hung(lines: dict[str, Segment], extra: list[Segment], shape: Shape, fit: Fit, heads: bool) -> None:
    """A line that begins or ends where a missing vector should is that vector, however wrong it is."""
    missing = [edge for edge in shape.edges if edge.key not in lines]
    left = [one for one in extra if (one.headed or not heads) and not one.name]
    if not missing or not left or fit.origin is None:
        return
    costs = np.array([[_off(one, edge) for edge in missing] for one in left])
    for i, j in zip(*linear_sum_assignment(costs), strict=True):
        if costs[i, j] < FAR_OFF:
            lines[missing[j].key] = left[i]
            extra.remove(left[i])


def _off(one: Segment, edge: Edge) -> float:
    """How far a line is from a vector of which it shares one end: in direction and length, 0 to 2."""
    if min(abs(one.start - edge.a), abs(one.end - edge.b)) > HUNG:
        return FAR_OFF
    turned = abs(np.angle(one.along / edge.along)) / np.pi
    return float(turned + abs(np.log(abs(one.along) / abs(edge.along))) / 4)


def _needless(shape: Shape) -> list[Edge]:
    """Lines between any two letters of the figure, which may be drawn: the sides of images, total vectors."""
    there = {frozenset((_near(edge.a), _near(edge.b))) for edge in shape.edges}
    return [
        Edge(keys=(), a=u.at, b=v.at, tail=u.letters, tip=v.letters)
        for u, v in combinations(shape.vertices, 2)
        if abs(u.at - v.at) > NOTHING and frozenset((_near(u.at), _near(v.at))) not in there
    ]


def _near(at: complex) -> tuple[float, float]:
    return round(at.real, 4) + 0.0, round(at.imag, 4) + 0.0


def _likely(one: Segment, edge: Edge, heads: bool) -> Segment:
    """A line without a head in a drawing that has heads has no sense of its own: it is taken as it should be."""
    return one.turned() if heads and abs(one.along + edge.along) < abs(one.along - edge.along) else one


def _costs(fit: Fit, name: str, edges: Sequence[Edge], heads: bool) -> Matrix:
    start, end = (np.array([getattr(one, at) for one in fit.lines])[:, None] for at in ("start", "end"))
    a, b = (np.array([getattr(edge, at) for edge in edges])[None, :] for at in "ab")
    own, should = end - start, b - a
    forth, back = np.abs(own - should), np.abs(own + should)
    turned = back < forth
    off = np.where(turned, back, forth)
    size = off / (off + PART * np.abs(should) + MM)
    ahead, behind = (np.abs(start - a) + np.abs(end - b)) / 2, (np.abs(start - b) + np.abs(end - a)) / 2
    away = np.minimum(ahead, behind) if fit.origin is not None else np.full(size.shape, PLACE_MM)
    headed = np.array([one.headed for one in fit.lines])[:, None]
    asked = np.array([bool(edge.key) for edge in edges])[None, :]
    against = turned & (headed if heads else np.ones_like(headed)) & asked
    costs = SIZE * size + PLACE * away / (away + PLACE_MM) + REVERSED * against
    costs += BARE * (heads & ~headed & asked) + NEEDLESS * ~asked + NEEDLESS * (headed & ~asked)
    return np.asarray(costs + _names(fit.lines, name, edges), dtype=float)


def _names(lines: Sequence[Segment], figure: str, edges: Sequence[Edge]) -> Matrix:
    """A name is believed before any geometry."""
    said = [one.name.removeprefix(f"{figure}:") for one in lines]
    return np.array([[0.0 if not name else -NAMED if name in edge.keys else NAMED for edge in edges] for name in said])
