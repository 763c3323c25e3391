"""In which order the figures of a construction are read."""

from __future__ import annotations

from collections.abc import Sequence

from ..board.construction import Figure


def reading_order(figures: Sequence[Figure]) -> tuple[Figure, ...]:
    """The figures as they come, a force polygon after the free body of its name, to which it belongs; those without a
    body that were closed before, without friction, stand before the bodies."""
    first = {(f.view, f.name) for f in figures}
    beside = [f for f in figures if (f.view.beside, f.name) in first]
    begun = min(map(begun_in, beside), default=0)
    early = [f for f in figures if f.view.beside is not None and f not in beside and begun_in(f) < begun]
    ordered: list[Figure] = []
    for figure in figures:
        if early and figure.view is early[0].view.beside:
            ordered, early = [*ordered, *early], []
        if figure not in beside and figure not in ordered:
            ordered += [figure, *(f for f in beside if f.view.beside is figure.view and f.name == figure.name)]
    return tuple(ordered)


def begun_in(figure: Figure) -> int:
    """The step that began it."""
    return min((mark.step for mark in figure.marks), default=0)
