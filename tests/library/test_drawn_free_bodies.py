"""Claims about the forces of every free body of the library: each can be told from the bar along which it acts, and
each has a line to the body on which it acts."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence

import numpy as np

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import (
    Curve,
    Disc,
    Dot,
    FrictionCircle,
    GearMark,
    Mark,
    Point,
    RackMark,
    Segment,
    Slot,
    Vector,
)
from vecpoly.drawing.symbols.outlines import outlines

IDS = Later(lambda: [*ids(view=View.BODY), *FOUND])
ALONG, SEEN = 0.1, 0.7  # rad to a bar, mm from it: an arrow within both is taken for the bar
PART, FAR, ON = 0.3, 6.0, 1.0  # of an arrow; mm: what hangs in the air; on a line
STEPS = np.linspace(0.0, 1.0, 41)
ROUND = np.exp(1j * np.linspace(0.0, 2 * np.pi, 200))


def forces(figure: Figure) -> Iterator[Vector]:
    """The arrows of forces, not those of velocities beside them."""
    for mark in figure.marks:
        if isinstance(mark, Vector) and mark.label and not mark.label.startswith("v"):
            yield mark


def on_bar(arrow: Vector, a: complex, b: complex) -> float:
    """The part of an arrow that lies on a bar along which it runs."""
    lean = abs(cmath.phase((arrow.b - arrow.a) / (b - a)))
    shaft = (arrow.a + (arrow.b - arrow.a) * STEPS - a) / (b - a)
    on = (shaft.real > 0.0) & (shaft.real < 1.0) & (abs(shaft.imag) * abs(b - a) < SEEN)
    return float(on.mean()) if min(lean, np.pi - lean) < ALONG else 0.0


def shape(mark: Mark) -> Iterator[np.ndarray]:
    """Places of a body: its points, rims and pitch lines."""
    match mark:
        case GearMark() | Disc() | FrictionCircle():
            yield mark.centre + mark.radius * ROUND
        case Curve():
            yield np.array(mark.points)
        case RackMark():
            yield mark.a + (mark.b - mark.a) * STEPS
        case Point() if mark.dot is not Dot.NONE:
            yield np.array([mark.at])
        case Segment():
            yield mark.a + (mark.b - mark.a) * STEPS
        case _:
            pass


@each(IDS)
def test_no_force_of_a_free_body_hides_on_a_bar(name: str) -> None:
    for figure in drawn(name).figures(View.BODY):
        bars = [bar for bar in inked(figure.marks) if abs(bar[1] - bar[0]) > 10.0]
        hidden = [force.label for force in forces(figure) if any(on_bar(force, *bar) > PART for bar in bars)]
        assert not hidden, figure.name


def inked(marks: Sequence[Mark]) -> list[tuple[complex, complex]]:
    """The lines of a body on which an arrow is not seen: not the middle of a slot, which is white."""
    slots = {(mark.a, mark.b) for mark in marks if isinstance(mark, Slot)}
    return [bar for bar in outlines(marks) if bar not in slots]


@each(IDS)
def test_no_force_of_a_free_body_lies_on_another(name: str) -> None:
    for figure in drawn(name).figures(View.BODY):
        there = list(forces(figure))
        for n, force in enumerate(there):
            on = [other.label for other in there[:n] + there[n + 1 :] if on_bar(force, other.a, other.b) > PART]
            assert not on, (figure.name, force.label)


@each(IDS)
def test_every_force_of_a_free_body_stands_at_it_or_on_a_line_from_it(name: str) -> None:
    for figure in drawn(name).figures(View.BODY):
        edges = [a + (b - a) * STEPS for a, b in outlines(figure.marks)]
        shapes = [*edges, *(places for mark in figure.marks for places in shape(mark))]
        if not shapes:
            continue
        there = np.concatenate(shapes)
        for force in forces(figure):
            shaft = force.a + (force.b - force.a) * STEPS
            assert np.abs(shaft[:, None] - there).min() < FAR, (figure.name, force.label)
