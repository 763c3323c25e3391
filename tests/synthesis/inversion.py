"""Problems of linkages through positions, as they are written; shared by the tests of this folder."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import vecpoly
from vecpoly.board.candidates import Candidate
from vecpoly.board.hand import hand
from vecpoly.drawing.sheets.paper import DrawingPaper
from vecpoly.methods.synthesis.plan import construct_design
from vecpoly.solution import Solution, solve


def posed(kind: str, **data: Any) -> vecpoly.Problem:
    """A synthesis of this kind with these data."""
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": kind, "data": data})


def drawn_anyhow(kind: str, **data: Any) -> tuple[Candidate, ...]:
    """What the exact hand finds on paper, be it of any use or not; its pins in mm as they will be."""
    drawn = construct_design(posed(kind, **data), hand("exact"), DrawingPaper()).construction
    mu = 1e3 * drawn.figures[0].scale.value
    return tuple(replace(one, pins={key: mu * at for key, at in one.pins.items()}) for one in drawn.candidates)


def solved(problem: vecpoly.Problem) -> Solution:
    """The solution by the exact hand alone."""
    return solve(problem, by="exact", repeats=0, precise=False)


def pose(x: float, y: float, deg: float) -> str:
    """A position of a body."""
    return f"({x!r}, {y!r}) mm at {deg!r} deg"


def place(x: float, y: float) -> str:
    """A point."""
    return f"({x!r}, {y!r}) mm"
