"""A solved problem: the construction, the oracle's answers beside it, and what the hand may be off by."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf, nan
from typing import TYPE_CHECKING, Any, Self, cast

import numpy as np

from .amend import Length, Spot, amend, found_all
from .answer import YES_NO, Answer, plain, reading_json, small_table, told_short
from .board.construction import Construction, LineOfAction, Reading
from .board.hand import Hand, hand, scatter
from .board.otherwise.amended import Amended
from .board.otherwise.slip import Slip
from .board.paper.sizes import unfit
from .check.alarm import Cause, Weighed, alarm_at, contradicted, warning
from .check.idle import idle
from .check.precision import PLENTY, noise, sizes
from .check.truth import ActsAt, size_of
from .found import answered, conclusion, found_json, linkage, objection, verification
from .foundation.arguments import of_kind
from .foundation.frozen import FrozenMap
from .mechanism.model import Mechanism
from .methods.centres.compare import comparable
from .methods.desk import Desk
from .methods.drawn import Drawn
from .names import Key, is_place
from .printed.steps import as_printed
from .problem.problem import Problem, Scales
from .task import Task, task_of
from .words import Words, language

if TYPE_CHECKING:
    from .check.found import Verified

__all__ = ["REPEATS", "YES_NO", "Answer", "Solution", "fewer_digits", "solve", "told_short"]

REPEATS = 200  # repeated hands behind every expected drawing error


@dataclass(frozen=True)
class Solution:
    """What `solve` gives: the problem, its construction and its answers."""

    problem: Problem
    construction: Construction
    answers: Mapping[str, Answer]
    warnings: tuple[Words, ...] = ()  # what is accepted but hardly meant, in the file and of the scales

    def __post_init__(self) -> None:
        object.__setattr__(self, "answers", FrozenMap(self.answers))

    def toned(self, tones: Mapping[str, int]) -> Self:
        """The same with its vectors told apart by these tones; with none ({}) it is in black, as an examination is."""
        return replace(self, construction=self.construction.toned(tones))

    @property
    def suspect(self) -> bool:
        """Whether an answer, or what it was found by, must not be taken for right."""
        return self.construction.warning is not None

    @cached_property
    def verification(self) -> tuple[Verified, ...]:
        """Of a synthesis: what each valid solution does, moved by the exact solver with the lengths read on paper."""
        return verification(self.problem, self.construction.candidates)

    @property
    def linkage(self) -> Problem:
        """Of a synthesis: the solution that is taken, as a problem of its own; its lengths are those read on paper.

        Raises NotAskedError where nothing was to be found.
        """
        return linkage(self.problem, self.construction.candidates)

    @property
    def mechanism(self) -> Mechanism:
        """The linkage that was found, its crank driving; the problem's own mechanism where none was to be found."""
        return self.problem.subject if isinstance(self.problem.subject, Mechanism) else self.linkage.mechanism

    def __str__(self) -> str:
        """The answers as a small table."""
        return small_table(self.answers.values(), language())

    def as_json(self) -> dict[str, Any]:
        """Everything asked, as plain data; of a force analysis also everything else that was drawn, under `forces`."""
        data: dict[str, Any] = {
            "id": self.problem.id,
            "hand": self.construction.hand,
            "suspect": self.suspect,
            "answers": {key: answer.as_json() for key, answer in self.answers.items()},
        }
        if self.warnings:
            data["warnings"] = [{"zh": words.zh, "en": words.en} for words in self.warnings]
        data |= found_json(self.construction, self.verification)
        forces = {key: reading_json(reading) for key, reading in self.construction.forces.items()}
        return cast("dict[str, Any]", plain(data | ({"forces": forces} if forces else {})))


def solve(
    problem: Problem,
    *,
    by: str = "drafting",
    seed: int = 0,
    repeats: int = REPEATS,
    precise: bool = True,
    readings: Mapping[str, Length] | None = None,
    points: Mapping[str, Spot] | None = None,
    slip: Slip | None = None,
    sketch: Desk | None = None,
) -> Solution:
    """Draw the solution of a problem with this hand and set the oracle's answers beside it.

    readings, points: lengths read (``{"bc": "38 mm"}``) and points found (``{"c": (12.0, 31.5)}``, mm on the figure) by
    somebody else: the construction goes on with them, and all that follows is drawn anew. slip: the solution of
    somebody who makes this mistake. sketch: of this problem by an exact hand (`methods.plan.sketched`), where there is
    one already. precise: also find how many digits the exact values keep, and which statements decide nothing; else the
    former is done only where something is suspect. Raises AssemblyError, DeadPointError, MobilityError, NoMethodError;
    UnknownNameError where nothing of that name is read or found.
    """
    of_kind(problem, Problem, Words("题目（load 或 loads 的结果）", "a problem, as load and loads give it,"))
    task = task_of(problem)
    size = sizes(problem, task.truth)  # first: the refusals of the truth know the range of the input that does assemble
    off = noise(problem, task.truth, size) if precise else dict.fromkeys(size, 0.0)
    amended = amend(readings, points, slip)
    drawn = task.draw(hand(by, seed=seed, repeats=repeats), amended, sketch)
    found_all(amended, drawn.construction.acts, readings)
    answers = _answers(task, drawn, off, size, scatters=by == "pencil", judged=bool(repeats))
    if not precise and any(answer.suspect for answer in answers.values()):
        return solve(
            problem, by=by, seed=seed, repeats=repeats, readings=readings, points=points, slip=slip, sketch=sketch
        )
    construction, answers = as_printed(drawn.construction, answers)
    small = unfit(construction.figures, task.given({figure.view for figure in construction.figures}))
    told = (*problem.warnings, *(idle(problem) if precise else ()), *small)
    return Solution(problem, _warned(task, drawn._replace(construction=construction), answers), answers, told)


def _answers(
    task: Task, drawn: Drawn, off: Mapping[str, float], size: Mapping[str, float], *, scatters: bool, judged: bool
) -> dict[str, Answer]:
    """What was read beside what is exact; `judged`: by the scatter of repeated hands too."""
    asked, answers, readings = task.asked, {}, answered(drawn.construction, task.truth.values)
    places = {key for key, rel in asked.items() if is_place(rel)}
    read, exact, spread = comparable(readings, task.truth.values, drawn.repeats, places)
    ideal, true, _ = comparable({key: drawn.ideal[key] for key in readings}, task.truth.values, {}, places)
    for key, reading in read.items():
        reached = _expected(spread[key])
        limit = alarm_at(reached, spread[key], scatters=scatters)
        weighed = _weighed(
            reading,
            exact[key],
            ideal[key],
            true[key],
            reach=limit if judged else nan,
            noise=off[key],
            size=size[key],
            steady=not scatters,
        )
        line, turns = task.truth.lines.get(key), reading.unit in task.turning
        answers[key] = _answer(asked[key], reading, exact[key], reached, line, turns, weighed)
    return answers


def _warned(task: Task, drawn: Drawn, answers: Mapping[str, Answer]) -> Construction:
    """The construction with its readings, and the alarm where something must not be taken for right."""
    wrong = [(one.reading.symbol, one.suspect) for one in answers.values() if one.suspect]
    wrong += [(rel.symbol, Cause.APART) for rel in contradicted(task.truth, drawn.motion) if rel.key not in answers]
    readings = {**drawn.construction.readings, **{key: answer.reading for key, answer in answers.items()}}
    said, found = warning(wrong), (task.problem, drawn.construction.candidates)
    other, ended = objection(*found), conclusion(*found)
    alarm = said + other if said and other else said or other
    return replace(drawn.construction, readings=readings, warning=alarm, conclusion=ended)


def fewer_digits(solution: Solution) -> Words | None:
    """What is to be said where exact values have lost digits near a dead point or change point."""
    short = [(answer.reading.symbol, answer.digits) for answer in solution.answers.values() if answer.digits < PLENTY]
    if not short:
        return None
    zh, en = (
        "、".join(f"${symbol}$ 剩 {left} 位" for symbol, left in short),
        ", ".join(f"${symbol}$ {left}" for symbol, left in short),
    )
    return Words(
        f"机构离死点（变点）很近，精确值的有效数字减少：{zh}。",
        f"So near to a dead point (change point) the exact values keep only a few digits: {en}.",
    )


def scales_of(construction: Construction) -> Scales:
    """The scales of a drawing; figures that lie aside have their own."""
    return Scales({f.view.mu.key: f.scale.value for f in reversed(construction.figures) if not f.aside})


def constructed(problem: Problem, by: Hand, amended: Amended) -> Drawn:
    """The drawing alone, without the answers that check it."""
    return task_of(problem).draw(by, amended)


def _expected(scalars: Any) -> float:
    """3σ of the repeated hands; of none 0."""
    repeated = np.asarray(scalars)
    found = repeated[1:] if repeated.ndim else repeated[None]  # all hands find the same
    found = found[np.isfinite(found)]
    return 3.0 * scatter(found) if found.size else inf  # no repeated hand closes the polygon: nothing can be promised


def _answer(
    rel: Key, reading: Reading, exact: complex | float, error: float, line: ActsAt | None, turns: bool, weighed: Weighed
) -> Answer:
    return Answer(
        rel=rel,
        reading=reading,
        drawn=reading.scalar,
        exact=size_of(exact),
        expected_error=error,
        drawn_vector=reading.vector,
        exact_vector=exact if isinstance(exact, complex) else None,
        exact_acts=None if line is None else LineOfAction(point=line.point, tangent=line.tangent, couple=line.couple),
        turns=turns,
        weighed=weighed,
    )


def _weighed(
    reading: Reading,
    exact: complex | float,
    ideal: Reading,
    true: complex | float,
    *,
    reach: float,
    noise: float,
    size: float,
    steady: bool,
) -> Weighed:
    as_vector = ideal.vector is not None and isinstance(true, complex)
    return Weighed(
        drawn=reading.scalar,
        exact=size_of(exact),
        ideal=ideal.vector if as_vector and ideal.vector is not None else ideal.scalar,
        true=true if as_vector else size_of(true),
        reach=reach,
        noise=noise,
        size=size,
        steady=steady,
    )
