"""A frame tells the numbers of the equations whose vectors the solution draws in it."""

from __future__ import annotations

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.construction import Figure, Step
from vecpoly.board.paper.marks import Vector
from vecpoly.board.paper.tones import key_of, known_as
from vecpoly.report.question.equations import numbers


def _terms(figure: Figure, step: Step) -> int:
    """How many terms of its equation a step draws in a polygon."""
    if step.equation is None or figure.view.bodies:
        return 0
    laid = {key_of(mark) for mark in figure.marks if isinstance(mark, Vector) and mark.step == step.number}
    return len({known_as("", symbol) for symbol in step.equation.symbols} & laid)


@each(IDS)
def test_an_equation_is_told_of_the_figure_that_has_its_terms(name: str) -> None:
    """Of a link with a balancing moment, whose arm is measured in the same step, it stood over the mechanism."""
    construction = drawn(name).construction
    steps = [step for step in construction.steps if step.equation is not None]
    for number, step in enumerate(steps, 1):
        counts = {(one.view.name, one.name): _terms(one, step) for one in construction.figures}
        told = {(one.view.name, one.name) for one in construction.figures if number in numbers(construction, one)}
        most: int = max(counts.values())
        if told and most:
            assert all(counts[one] == most for one in told), (number, told, counts)
