"""How far off a drawn vector may be: the same T as for its length in the key, and σ of its direction."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import hypot, isfinite
from typing import Any

import numpy as np

from ....board.acts import Locate, Measure
from ....board.hand import scatter
from ....methods.drawn import Drawn
from ....problem.problem import Problem
from ....solution import scales_of
from ...allowance import Allowance
from ...derive.tolerance import Scatter
from ...key import Graded, Kind
from ...redraw import drawn_by
from ..expected import NOTHING, Edge, Shape


@dataclass(frozen=True, slots=True, kw_only=True)
class Allowed:
    """T of a vector's length (mm), and of its direction (degrees)."""

    mm: float
    degrees: float


def tolerances(problem: Problem, shapes: Sequence[Shape], rule: Allowance) -> Mapping[tuple[str, str], Allowed]:
    """(figure, quantity) → T, by the scatter of students' hands that draw the whole construction."""
    drawn = drawn_by(problem, rule.hand())
    scatter = Scatter(drawn, rule, scales_of(drawn.construction).given)
    pairs = [(shape, edge) for shape in shapes if not shape.diagram for edge in shape.edges]
    graded = scatter.bounded([_graded(shape, edge, drawn, rule) for shape, edge in pairs])
    return {
        (shape.name, edge.key): Allowed(mm=one.allowed, degrees=_degrees(shape, edge, drawn, rule))
        for (shape, edge), one in zip(pairs, graded, strict=True)
    }


def _graded(shape: Shape, edge: Edge, drawn: Drawn, rule: Allowance) -> Graded:
    """The vector's length as a reading of the key."""
    size = abs(edge.along)
    sigma = hypot(_spread(np.abs(_by_hands(shape, edge, drawn))), 0.0 if _read(shape, edge, drawn) else rule.read)
    return Graded(
        key=edge.key,
        symbol=edge.letters,
        kind=Kind.READING,
        unit="mm",
        block=shape.name,
        exact=size,
        mm=size,
        sigma=sigma,
    )


def _by_hands(shape: Shape, edge: Edge, drawn: Drawn) -> Any:
    """The vector by every hand: as read, or else from its ends; of what no hand scatters, as it is."""
    if (number := _read(shape, edge, drawn)) is not None:
        return drawn.hands[number] * edge.along / abs(edge.along)
    return _at(shape, edge.b, drawn) - _at(shape, edge.a, drawn)


def _read(shape: Shape, edge: Edge, drawn: Drawn) -> int | None:
    """The act that reads its length."""
    for act in drawn.construction.acts:
        if isinstance(act, Measure) and act.number in drawn.hands and act.figure == shape.name:
            ends = {(act.a, act.b), (act.b, act.a)}
            if any(abs(a - edge.a) < NOTHING and abs(b - edge.b) < NOTHING for a, b in ends):
                return act.number
    return None


def _at(shape: Shape, at: complex, drawn: Drawn) -> Any:
    """A place of the figure by every hand."""
    for act in drawn.construction.acts:
        if isinstance(act, Locate) and act.figure == shape.name and abs(act.at - at) < NOTHING:
            return drawn.hands.get(act.number, at)
    return at


def _spread(found: Any) -> float:
    if np.ndim(found) == 0:
        return 0.0
    repeats = found[1:][np.isfinite(found[1:])]
    return scatter(repeats) if repeats.size else 0.0


def _degrees(shape: Shape, edge: Edge, drawn: Drawn, rule: Allowance) -> float:
    ends = _at(shape, edge.b, drawn) - _at(shape, edge.a, drawn)
    spread = rule.k * float(np.degrees(_spread(np.angle(ends / edge.along)))) if np.ndim(ends) else 0.0
    return max(rule.direction, min(spread, 2 * rule.direction)) if isfinite(spread) else rule.direction
