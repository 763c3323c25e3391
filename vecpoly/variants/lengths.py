"""Which graded vectors are too short on paper, told by the oracle before anything is drawn."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..board.paper.scales import round_up
from ..board.place import View
from ..names import Kind, Rel
from ..problem.problem import Problem
from .frames import ROOM

Values = NDArray[Any]
POLYGONS = {View.VELOCITY: (Kind.V,), View.ACCELERATION: (Kind.A, Kind.AN, Kind.AT, Kind.AK, Kind.AR)}
FAINT = 1e-3  # mm: what is still shorter may be nothing, which is not too short
SURE = 1e-6  # relative: what the drawing may differ by from the oracle, and more


def surely_short(problem: Problem, asked: Mapping[str, Values], graded: Collection[str]) -> NDArray[np.bool_]:
    """Where some graded vector is shorter than the gate has it, at whatever scale its polygon fits its frame: it is no
    smaller than what is asked of it from the pole. The drawing would be refused."""
    found = np.zeros(next(map(len, asked.values()), 0), bool)
    if problem.by_centres or problem.curvature is not None:
        return found
    for view in POLYGONS:
        sizes = [size for key, size in drawn_on(problem, view, asked).items() if key in graded]
        scale = _least_scale(problem, view, asked) if sizes else None
        if scale is not None:
            for size in sizes:
                found |= (size > FAINT * scale) & (size < problem.gate.vectors * scale * (1 - SURE))
    return found


def drawn_on(problem: Problem, view: View, asked: Mapping[str, Values]) -> dict[str, Values]:
    """The sizes of the asked vectors of this polygon."""
    drawn = {rel.key for rel in _rels(problem) if rel.kind in POLYGONS[view]}
    return {key: np.abs(values) for key, values in asked.items() if key in drawn}


def _least_scale(problem: Problem, view: View, asked: Mapping[str, Values]) -> Values | None:
    """The scale that is given, or else the finest at which the asked vectors from the pole stay in the frame; None
    where there are none."""
    if (given := problem.scales.of(view.mu)) is not None:
        return np.array(given)
    from_pole = (POLYGONS[view][0], None)
    poled = {rel.key for rel in _rels(problem) if (rel.kind, rel.ref) == from_pole}
    parts = [part for key, values in asked.items() if key in poled for part in _filled(values)]
    if not parts:
        return None
    largest = np.max(parts, axis=0) * (1 - SURE)
    return np.array([round_up(size) if size > 0 and isfinite(size) else np.inf for size in map(float, largest)])


def _rels(problem: Problem) -> Iterator[Rel]:
    return (ask.rel for ask in problem.asks if isinstance(ask.rel, Rel))


def _filled(values: Values) -> tuple[Values, Values]:
    """How much of its frame a vector from the pole takes, across and up."""
    return np.abs(values.real) / ROOM[0], np.abs(values.imag) / ROOM[1]
