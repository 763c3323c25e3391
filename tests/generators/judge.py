"""One random problem judged: drawn by the exact hand = oracle = central differences of the oracle's positions.

right: all agree. refused: the program declines, with its reason. wrong: two of the three disagree, or what is called
locked moves by the exact equilibrium. broken: a traceback.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from tests.at_once import exactly
from vecpoly import loads
from vecpoly.algebra.formula import plain
from vecpoly.designs.base import Design
from vecpoly.designs.verdict import Verdict as Use
from vecpoly.door import Problem
from vecpoly.errors import LockedError, VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle.forces import forces
from vecpoly.oracle.synthesis.registry import linkages
from vecpoly.solution import Answer, Solution, solve

from .differences import against_differences
from .family import Check, OnText, content
from .nearby import largest, natural, over_a_period, slack

AGREE = 1e-9  # of the largest quantity of the kind


class Kind(StrEnum):
    """How a random problem ended."""

    RIGHT = "right"
    REFUSED = "refused"
    WRONG = "wrong"
    BROKEN = "broken"


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """The end of one problem and the reason: of a refusal its text, of a wrong one what disagrees."""

    kind: Kind
    why: str = ""

    @property
    def reason(self) -> str:
        """The text without its numbers and letters of points, so that like refusals count as one."""
        return re.sub(
            r"\b[A-Z]\d?\b",
            "X",
            re.sub(r"[-−]?\d+(\.\d+)?(e[-+]?\d+)?", "#", self.why.splitlines()[0] if self.why else ""),
        )[:160]


def judge(text: str, also: Check = content, *, fitted: bool = True) -> Verdict:
    """Load, draw, and compare; never raises. fitted: at scales that fill a sheet, which takes two more drawings;
    else at some that are likely."""
    try:
        return _judged(text, also, fitted)
    except LockedError as error:
        kind = Kind.WRONG if moves(text) else Kind.REFUSED
        return Verdict(kind=kind, why=f"{type(error).__name__}: {error}")
    except VecpolyError as error:
        why = f"{type(error).__name__}: {error}"
        lost = error.code == "precision.lost"  # a solution in closed form of which rounding leaves nothing
        return Verdict(kind=Kind.WRONG if not lost and _is_solved(text) else Kind.REFUSED, why=why)
    except Exception as error:  # whatever escapes is what is sought
        return Verdict(kind=Kind.BROKEN, why=f"{type(error).__name__}: {error}")


def _is_solved(text: str) -> bool:
    """Whether a task of synthesis that was refused has solutions in closed form: then it was refused wrongly."""
    try:
        subject = loads(text).subject
        return isinstance(subject, Design) and any(one.verdict is Use.VALID for one in linkages(subject))
    except VecpolyError:
        return False


def moves(text: str) -> bool:
    """Whether the file is accepted and the exact equilibrium of its loads exists."""
    try:
        problem = loads(text)
        if problem.loads is None:
            return False
        forces(problem.mechanism, problem.loads)
    except VecpolyError:
        return False
    return True


def _judged(text: str, also: Check, fitted: bool) -> Verdict:
    if isinstance(also, OnText):
        told = also.wrong(text)
        return Verdict(kind=Kind.WRONG if told else Kind.RIGHT, why=told)
    problem = loads(text)
    solution = solve(problem, by="exact", repeats=0) if fitted else exactly(problem)
    wrong = _disagreeing(solution)
    if not wrong and isinstance(problem.subject, Mechanism) and len(problem.subject.drives) == 1:
        wrong = against_differences(problem.subject, solution)
    warning = solution.construction.warning
    wrong = wrong or ("" if warning is None else f"alarm: {warning.en}") or _nameless(solution)
    wrong = wrong or _told_twice(problem) or also(solution)
    if not wrong and (none := solution.construction.conclusion) is not None:
        return Verdict(kind=Kind.REFUSED, why=f"no solution: {none.en}")
    return Verdict(kind=Kind.WRONG if wrong else Kind.RIGHT, why=wrong)


def _told_twice(problem: Problem) -> str:
    """A symbol that is given with two values; and a problem just read has values that may be varied."""
    assert problem.parameters is not None  # raises where what was read is not what its values say
    known: dict[str, str] = {}
    for one in problem.given.data:
        if one.symbol and known.setdefault(one.symbol, one.text) != one.text:
            return f"{one.symbol} is given as {known[one.symbol]} and as {one.text}"
    return ""


def _nameless(solution: Solution) -> str:
    """A length in a formula that has no letters: nobody could read it off the sheet."""
    lines = (line for step in solution.construction.steps for line in step.formulas)
    return next((f"no letters: {plain(line)}" for line in lines if "—" in plain(line)), "")


def _disagreeing(solution: Solution) -> str:
    """The first quantity of which the exact hand draws something else than the oracle finds."""
    answers = [one for one in solution.answers.values() if not one.undefined]
    near: dict[str, float] | None = None
    subject = solution.problem.subject
    floor = natural(subject) if isinstance(subject, Mechanism) else dict(getattr(subject, "likely", {}))
    floor |= over_a_period(solution.problem)
    for one in answers:
        unit = one.reading.unit
        size = largest(solution, unit, floor)
        if unit == "rad/s^2":  # where all turns evenly, ω² tells what an acceleration is small against
            size = max([size, *(other.exact**2 for other in answers if other.reading.unit == "rad/s")])
        if gap(one) <= AGREE * size:
            continue
        near = slack(solution) if near is None else near
        if not gap(one) <= AGREE * size + near.get(one.key, 0.0):
            drawn, exact = (
                (one.drawn_vector, one.exact_vector) if one.drawn_vector is not None else (one.drawn, one.exact)
            )
            return f"{one.key} drawn {drawn}, exact {exact}"
    return ""


def gap(answer: Answer) -> float:
    """How far the drawn value is from the exact one."""
    if answer.drawn_vector is not None and answer.exact_vector is not None:
        return abs(answer.drawn_vector - answer.exact_vector)
    return abs(answer.deviation)
