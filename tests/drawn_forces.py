"""Forces of the drawn library, for claims about their arrows: what was read of them, and where they stand."""

from __future__ import annotations

import numpy as np

from tests.drawn_library import drawn, ids
from tests.each import Later
from tests.found import FORCES
from vecpoly.board.construction import Figure, Reading, View
from vecpoly.board.paper.marks import Vector
from vecpoly.mechanism.loads import Force, Moment
from vecpoly.oracle.forces import forces

IDS = Later(lambda: [*ids(view=View.FORCE), *FORCES])  # and members that were found by lot
NEAR = 1e-6  # mm
NONE = 1e-6  # N: no force


def by_symbol(name: str) -> dict[str, Reading]:
    """Everything that the force analysis found, by its printed symbol."""
    return {
        reading.symbol: reading for reading in drawn(name).construction.forces.values() if reading.vector is not None
    }


def arrows(figure: Figure) -> list[Vector]:
    """The arrows of a figure that carry a symbol."""
    return [mark for mark in figure.marks if isinstance(mark, Vector) and mark.label]


def size_of(name: str, load: Force | Moment) -> float:
    """As given, or of a load that depends on place and speed as the oracle finds it."""
    problem = drawn(name).problem
    assert problem.loads is not None and load.size is not None
    if load.law is None:
        return load.size
    return float(np.real(forces(problem.mechanism, problem.loads).value(load.name)))
