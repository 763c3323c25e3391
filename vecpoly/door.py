"""The door: problems, solutions and constructions as a user holds them, with all that the house can do with them.

The classes inside the house are data and know nothing of what comes after them. Those here are the same data, equal to
them, and reach into every part: ``load("3-9").solve().report("3-9.pdf")``, pictures in a notebook.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from functools import wraps
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

from . import solution as inside
from .amend import Length, Spot
from .board import construction as board
from .board.slip import Slip
from .problem import assignment, problem
from .problem import load as files
from .words import Lang, language

Kind = TypeVar("Kind")
P = ParamSpec("P")


class Problem(problem.Problem):
    """One exercise, as `load` and `loads` give it."""

    __slots__ = ()

    def solve(self, *, by: str = "drafting", seed: int = 0, readings: Mapping[str, Length] | None = None,
              points: Mapping[str, Spot] | None = None, slip: Slip | None = None) -> Solution:
        """Draw the solution of this problem by a hand: exact, drafting or pencil; readings, points, slip: as in `solve`."""
        return solve(self, by=by, seed=seed, readings=readings, points=points, slip=slip)

    def __eq__(self, other: object) -> bool:
        return _same(self, other, problem.Problem)

    def __hash__(self) -> int:
        return super().__hash__()

    def _repr_svg_(self) -> str:
        """The sketch of the mechanism or device, in Jupyter."""
        from .notebook.pages import problem_svg

        return problem_svg(self, language())

    def _repr_html_(self) -> str:
        """What is given and asked, with the sketch, in Jupyter."""
        from .notebook.pages import problem_html

        return problem_html(self, language())


class Construction(board.Construction):
    """What was drawn: steps, acts, figures, readings."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        return _same(self, other, board.Construction)

    def __hash__(self) -> int:
        return super().__hash__()

    def _repr_html_(self) -> str:
        """Steps, acts and figures, in Jupyter."""
        from .notebook.pages import construction_html

        return construction_html(self, language())


class Solution(inside.Solution):
    """What `solve` gives: the problem, its construction and its answers."""

    problem: Problem
    construction: Construction

    def report(self, path: str | Path, *, lang: Lang = "zh", style: str = "solution") -> Path:
        """Write the report of this problem as a PDF."""
        from .report.document import write_report

        return write_report([self], path, lang=lang, style=style)

    def __eq__(self, other: object) -> bool:
        return _same(self, other, inside.Solution)

    def __hash__(self) -> int:
        return super().__hash__()

    def _repr_svg_(self) -> str:
        """The first sheet, in Jupyter."""
        from .notebook.pages import solution_svg

        return solution_svg(self, language())

    def _repr_html_(self) -> str:
        """The answers and the sheets, in Jupyter."""
        from .notebook.pages import solution_html

        return solution_html(self, language())


def _as_held(find: Callable[P, problem.Problem]) -> Callable[P, Problem]:
    """The same function, giving problems as a user holds them."""

    @wraps(find)
    def found(*args: P.args, **kwargs: P.kwargs) -> Problem:
        return _as(Problem, find(*args, **kwargs))

    return found


def _as_solved(solve: Callable[P, inside.Solution]) -> Callable[P, Solution]:
    """The same function, giving solutions as a user holds them."""

    @wraps(solve)
    def solved(*args: P.args, **kwargs: P.kwargs) -> Solution:
        done = solve(*args, **kwargs)
        return Solution(_as(Problem, done.problem), _as(Construction, done.construction), done.answers, done.warnings)

    return solved


def _with_problems(find: Callable[P, assignment.Assignment]) -> Callable[P, assignment.Assignment]:
    """The same function, giving assignments whose problems are as a user holds them."""

    @wraps(find)
    def found(*args: P.args, **kwargs: P.kwargs) -> assignment.Assignment:
        sheet = find(*args, **kwargs)
        return replace(sheet, problems=tuple(_as(Problem, one) for one in sheet.problems))

    return found


def _as(kind: type[Kind], plain: Any) -> Kind:
    """The same data as a user holds it."""
    return plain if isinstance(plain, kind) else kind(**{field.name: getattr(plain, field.name) for field in fields(plain)})


def _same(one: Any, other: object, kind: type) -> bool:
    """Whether two are the same data, held by a user or inside."""
    return isinstance(other, kind) and all(getattr(one, field.name) == getattr(other, field.name) for field in fields(one))


load, loads = _as_held(files.load), _as_held(files.loads)
load_assignment = _with_problems(assignment.load_assignment)
solve = _as_solved(inside.solve)
