"""Every problem of the library drawn once by the exact hand,
for claims about what stands on the paper and in the steps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from typing import Any, TypeVar

import pytest

from tests.found import DEVICES, FOUND
from tests.laws import few
from vecpoly.board.construction import Construction, Figure, View
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.methods import draw as drawing
from vecpoly.methods import plan
from vecpoly.methods.desk import VECTOR, Desk
from vecpoly.names import At
from vecpoly.problem.library import library
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.solution import Solution, solve
from vecpoly.words import Words

T = TypeVar("T")

LIBRARY = tuple(entry.id for entry in library())
IDS = few(LIBRARY, 2)  # of which claims about every drawing are made: in the soak the whole library
DRAFTED = few(LIBRARY, 6)  # whose sheets are laid, and which are drawn by all hands: in the soak the whole library


@dataclass(frozen=True, slots=True)
class Drawn:
    """A problem, its solution, what was drawn, and the desk on which it lay (none for a device)."""

    problem: Problem
    solution: Solution
    desk: Desk | None

    @property
    def construction(self) -> Construction:
        return self.solution.construction

    def figures(self, view: View) -> tuple[Figure, ...]:
        """All figures of a kind."""
        return tuple(figure for figure in self.construction.figures if figure.view is view)


@cache
def given(name: str) -> Problem:
    """The problem of this id, read once: of the library, or one that was found outside it."""
    found = FOUND.get(name) or DEVICES.get(name)
    return loads(found) if found else load(name)


@cache
def drawn(name: str) -> Drawn:
    """The problem of this id, drawn by the exact hand."""
    desks: list[Desk] = []
    draw = drawing.draw

    def watched(*args: Any) -> Desk:
        desks.append(draw(*args))
        return desks[-1]

    problem = given(name)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(plan, "draw", watched)
        solution = solve(problem, by="exact", repeats=0, precise=False)
    return Drawn(problem, solution, desks[-1] if desks else None)


@cache
def drafted(name: str) -> Solution | None:
    """The problem of this id drawn as on paper, with all repeated hands; None where no method on file draws it."""
    try:
        return solve(given(name))
    except VecpolyError:
        return None


@cache
def ids(*, mechanisms: bool = True, view: View | None = None) -> tuple[str, ...]:
    """The problems about mechanisms (else about devices), those that draw a figure of this kind."""
    of_kind = (name for name in IDS if _is_mechanism(name) is mechanisms)
    return tuple(name for name in of_kind if view is None or drawn(name).figures(view))


@cache
def _is_mechanism(name: str) -> bool:
    return isinstance(given(name).subject, Mechanism)


def desk_of(name: str) -> Desk:
    """The desk of a mechanism."""
    desk = drawn(name).desk
    assert desk is not None
    return desk


def standing(desk: Desk) -> dict[str, tuple[View, complex, complex]]:
    """The vectors of both motion polygons by key: figure, tail and head."""
    return {
        key: (place, complex(stood.start), complex(stood.end))
        for (place, key), stood in desk.board.ledger.vectors.items()
        if isinstance(place, View) and place in VECTOR and not key.startswith("(")  # a sum of two that are parallel
    }


def tips(desk: Desk, view: View) -> dict[At, complex]:
    """The ends of the points' vectors on a polygon."""
    return {at: complex(desk.tip(view, at)) for at in desk.tips(view)}


def hanging(value: object, kind: type[T] | tuple[type[T], ...]) -> Iterator[T]:
    """Everything of a kind in a value, wherever it hangs."""
    if isinstance(value, kind):
        yield value
    elif isinstance(value, Mapping):
        for part in value.values():
            yield from hanging(part, kind)
    elif isinstance(value, tuple | list):
        for part in value:
            yield from hanging(part, kind)
    else:
        own: type = type(value)
        for name in _fields_of(own):
            yield from hanging(getattr(value, name), kind)


@cache
def _fields_of(kind: type) -> tuple[str, ...]:
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) else ()


@cache
def said(name: str) -> tuple[Words, ...]:
    """Every sentence of a construction."""
    return tuple(hanging(drawn(name).construction, Words))
