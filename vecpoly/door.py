"""The door: problems, solutions and constructions as a user holds them, with all that the house can do with them.

The classes inside the house are data and know nothing of what comes after them. Those here are the same data, equal to
them, and reach into every part: ``load("3-9").solve().report("3-9.pdf")``, pictures in a notebook.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from . import record
from . import solution as inside
from .amend import Length, Spot
from .board import construction as board
from .board.otherwise.slip import Slip
from .foundation.slotted import replace
from .problem import assignment
from .problem import load as files
from .problem import problem as exercise
from .problem.values import made
from .problem.values.vary import data_of, parameters, vary
from .words import Lang, language

if TYPE_CHECKING:
    from .cycle import Cycle
    from .grading.student import Checked

Kind = TypeVar("Kind")
P = ParamSpec("P")


class Problem(exercise.Problem):
    """One exercise, as `load` and `loads` give it."""

    __slots__ = ()

    def solve(
        self,
        *,
        by: str = "drafting",
        seed: int = 0,
        readings: Mapping[str, Length] | None = None,
        points: Mapping[str, Spot] | None = None,
        slip: Slip | None = None,
    ) -> Solution:
        """Draw the solution of this problem by a hand: exact, drafting or pencil; readings, points, slip: as in
        `solve`."""
        return solve(self, by=by, seed=seed, readings=readings, points=points, slip=slip)

    def vary(self, **changes: Any) -> Problem:
        """The same problem with other values: vary(AB="120 mm", phi="30 deg", F="200 N"); numbers are in SI.

        `parameters` has the names. Raises UnknownNameError for any other, ProblemFileError for what no file may hold.
        """
        return _as(Problem, vary(self, changes))

    @property
    def parameters(self) -> Mapping[str, str]:
        """The names by which values may be varied, with what is written: {'AB': '30 mm', 'phi': '60 deg', ...}."""
        return parameters(self)

    @property
    def data(self) -> dict[str, Any]:
        """What it says as a dictionary of texts, as a problem file has it; vecpoly.problem(data) makes it again."""
        return data_of(self)

    def check_answers(self, answers: Mapping[str, str | float] | Iterable[str]) -> Checked:
        """Check somebody's answers, {"v_D": "0.49", "ω5": "4.72 顺"} or ["v_D=0.49"]: right, close, or wrong with the
        reason."""
        from .grading.student import check_answers

        return check_answers(self, answers)

    def cycle(self, n: int = 361) -> Cycle:
        """The mechanism at n positions over its whole cycle: columns as numpy arrays, or as a DataFrame."""
        from .cycle import cycle

        return cycle(self, n)

    def __eq__(self, other: object) -> bool:
        return _same(self, other, exercise.Problem)

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

    def report(self, path: str | Path, *, lang: Lang = "zh", style: str = "solution", plain: bool = False) -> Path:
        """Write the report of this problem as a PDF; plain: in black alone."""
        from .report.document import write_report

        return write_report([self], path, lang=lang, style=style, plain=plain)

    @property
    def linkage(self) -> Problem:
        """Of a synthesis: the solution that is taken, as a problem of its own; its lengths are those read on paper.

        Raises NotAskedError where nothing was to be found.
        """
        return _as(Problem, super().linkage)

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


def _as_held(find: Callable[P, exercise.Problem]) -> Callable[P, Problem]:
    """The same function, giving problems as a user holds them."""

    @wraps(find)
    def found(*args: P.args, **kwargs: P.kwargs) -> Problem:
        return _as(Problem, find(*args, **kwargs))

    return found


def _as_solved(solve: Callable[P, inside.Solution]) -> Callable[P, Solution]:
    """The same function, giving solutions as a user holds them."""

    @wraps(solve)
    def solved(*args: P.args, **kwargs: P.kwargs) -> Solution:
        return _held(solve(*args, **kwargs))

    return solved


def _held(done: inside.Solution) -> Solution:
    """A solution as a user holds it."""
    return Solution(_as(Problem, done.problem), _as(Construction, done.construction), done.answers, done.warnings)


def from_json(text: str, kind: type[Kind]) -> Kind:
    """The Problem, Mechanism, Construction or Solution of a JSON text; raises VecpolyError where it holds none."""
    match kind.__name__:
        case "Problem":
            found: Any = _as(Problem, record.from_json(text, exercise.Problem))
        case "Construction":
            found = _as(Construction, record.from_json(text, board.Construction))
        case "Solution":
            found = _held(record.from_json(text, inside.Solution))
        case _:
            found = record.from_json(text, kind)
    made_of: Kind = found
    return made_of


def _with_problems(find: Callable[P, assignment.Assignment]) -> Callable[P, assignment.Assignment]:
    """The same function, giving assignments whose problems are as a user holds them."""

    @wraps(find)
    def found(*args: P.args, **kwargs: P.kwargs) -> assignment.Assignment:
        sheet = find(*args, **kwargs)
        return replace(sheet, problems=tuple(_as(Problem, one) for one in sheet.problems))

    return found


def _as(kind: type[Kind], plain: Any) -> Kind:
    """The same data as a user holds it."""
    return (
        plain
        if isinstance(plain, kind)
        else kind(**{field.name: getattr(plain, field.name) for field in fields(plain)})
    )


def _same(one: Any, other: object, kind: type) -> bool:
    """Whether two are the same data, held by a user or inside."""
    return isinstance(other, kind) and all(
        getattr(one, field.name) == getattr(other, field.name) for field in fields(one) if field.compare
    )


load, loads = _as_held(files.load), _as_held(files.loads)
load_assignment = _with_problems(assignment.load_assignment)
solve = _as_solved(inside.solve)
problem = _as_held(made.problem)
