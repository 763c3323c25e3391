"""Which vector equations are drawn in a figure, by their numbers, and what they are called."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from ...board.construction import Construction, Figure
from ...board.place import Pane, Place
from ...words import Words

_NAMES = {
    "velocity": Words("速度方程", "Velocity equation"),
    "acceleration": Words("加速度方程", "Acceleration equation"),
    "force": Words("力平衡方程", "Equilibrium of forces"),
}
_ANY = Words("矢量方程", "Vector equation")


def numbers(construction: Construction, figure: Figure) -> tuple[int, ...]:
    """The numbers of the equations that are drawn in this figure, counted through the whole solution."""
    places = [step.view for step in construction.steps if step.equation is not None]
    return tuple(n for n, place in enumerate(places, 1) if place is not None and _is(place, figure))


def _is(place: Place, figure: Figure) -> bool:
    view, name = (place.view, place.name) if isinstance(place, Pane) else (place, "")
    return (view, name) == (figure.view, figure.name)


def named(place: Place | None) -> Words:
    """What an equation is called that is drawn there."""
    view = place.view if isinstance(place, Pane) else place
    return _ANY if view is None else _NAMES.get(view.name, _ANY)


def runs(numbers: Sequence[int]) -> Iterator[list[int]]:
    """Numbers that follow one another, together."""
    for _, run in groupby(enumerate(numbers), key=lambda pair: pair[1] - pair[0]):
        yield [number for _, number in run]
