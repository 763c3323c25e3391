"""A figure on which no length is read drawn so many times larger as a whole; symbols and letters keep their size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any

from ...board.construction import Figure, View
from ...board.paper.arrow_radius import clear_radius
from ...board.paper.marks import Block, Cell, FixedGuide, Hatched, Mark, TurnArrow, Vector
from ...foundation.slotted import replace

USUAL = 9.0  # mm: how far from its centre a curved arrow stands
_PLACES, _SIZES = frozenset(("a", "b", "at", "centre")), frozenset(("radius",))


def may_be_larger(figure: Figure) -> bool:
    """Whether it is a free body, or a part of a mechanism sketched without a scale; forces on a block stand at its
    sides, which keep their size."""
    if figure.view is View.BODY and figure.scale.symbol:
        return not any(isinstance(mark, Block) for mark in figure.marks)
    sketched = figure.view is View.MECHANISM and bool(figure.name) and not figure.scale.symbol
    linked = any(mark.owner.startswith("link ") for mark in figure.marks)
    return sketched and linked and not any(isinstance(mark, Vector | Cell | Hatched) for mark in figure.marks)


def larger(figure: Figure, factor: float) -> Figure:
    """The figure at its finer scale, by the same symbol."""
    scale = replace(figure.scale, value=figure.scale.value / factor)
    made = [_mark(mark, factor) for mark in figure.marks]
    stood: list[Mark] = [mark for mark in made if not isinstance(mark, TurnArrow)]
    for n, mark in enumerate(figure.marks):
        if isinstance(mark, TurnArrow):
            made[n] = _turning(mark, factor, stood)
            stood.append(made[n])
    return replace(figure, scale=scale, marks=tuple(made))


def _turning(mark: TurnArrow, factor: float, beside: Sequence[Mark]) -> TurnArrow:
    """A curved arrow is a symbol: as far from its centre as it stood, or as is usual, unless a circle runs there."""
    at, least = mark.at * factor, min(mark.radius * factor, max(mark.radius, USUAL))
    return replace(mark, at=at, radius=clear_radius(beside, at, least))


def _mark(mark: Mark, factor: float) -> Mark:
    if isinstance(mark, FixedGuide) and mark.about is not None:
        by = mark.about * (factor - 1.0)
        return replace(mark, a=mark.a + by, b=mark.b + by, about=mark.about + by)
    changed: dict[str, Any] = {}
    for field in fields(mark):
        if field.name in _PLACES | _SIZES:
            changed[field.name] = getattr(mark, field.name) * factor
        elif field.name == "points":
            changed["points"] = tuple(at * factor for at in mark.points)  # type: ignore[union-attr]
    return replace(mark, **changed)
