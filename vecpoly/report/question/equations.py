"""Which vector equations are drawn in a figure, by their numbers, and what they are called."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from ...board.construction import Construction, Figure, Step
from ...board.paper.marks import Vector
from ...board.paper.tones import key_of, known_as
from ...board.place import Pane, Place
from ...foundation.slotted import replace
from ...words import Words

_NAMES = {
    "velocity": Words("速度方程", "Velocity equation"),
    "acceleration": Words("加速度方程", "Acceleration equation"),
    "force": Words("力平衡方程", "Equilibrium of forces"),
}
_ANY = Words("矢量方程", "Vector equation")


def numbers(construction: Construction, figure: Figure) -> tuple[int, ...]:
    """The numbers of the equations that are drawn in this figure, counted through the whole solution."""
    places = [step.view for step in equated(construction)]
    return tuple(n for n, place in enumerate(places, 1) if place is not None and _is(place, figure))


def equated(construction: Construction) -> tuple[Step, ...]:
    """The steps with an equation, each with the figure in which it is drawn: that of the step, or the one other in
    which its terms are, where the step goes on to measure elsewhere."""
    steps = [step for step in construction.steps if step.equation is not None]
    return tuple(replace(step, view=_drawn_in(construction, step)) for step in steps)


def _drawn_in(construction: Construction, step: Step) -> Place | None:
    """The figure in which most terms of a step's equation are drawn by it, the step's own first."""
    symbols = step.equation.symbols if step.equation is not None else ()
    keys = {known_as("", symbol) for symbol in symbols}
    shown = [(len(keys & _laid(figure, step.number)), figure) for figure in construction.figures]
    most, place = 0, step.view
    for count, figure in sorted(shown, key=lambda one: step.view is None or not _is(step.view, one[1])):
        if count > most:
            most, place = count, Pane(figure.view, figure.name) if figure.name else figure.view
    return place


def _laid(figure: Figure, step: int) -> set[str]:
    """The keys of the vectors that a step draws in a polygon."""
    vectors = (mark for mark in figure.marks if isinstance(mark, Vector) and mark.step == step)
    return {key for one in vectors for key in (one.key, key_of(one))} if not figure.view.bodies else set()


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
