"""A solved problem: the construction, the oracle's answers beside it, and what the hand may be off by."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self, cast

from .amend import Length, Spot, amend, can_be_made, found_all
from .answer import YES_NO, Answer, plain, reading_json, small_table, told_short
from .board.construction import Construction
from .board.hand import Hand, hand
from .board.otherwise.amended import AS_DRAWN, Amended
from .board.otherwise.slip import Slip
from .board.paper.sizes import unfit
from .check.alarm import Cause, contradicted, warning
from .check.idle import idle
from .check.paced import paced
from .check.precision import PLENTY, noise, sizes
from .check.resting import at_rest
from .drawing.sheets.paper import DrawingPaper
from .found import conclusion, found_json, linkage, objection, verification
from .foundation.arguments import of_kind
from .foundation.frozen import FrozenMap
from .foundation.slotted import replace
from .mechanism.model import Mechanism
from .methods.desk import Desk
from .methods.drawn import Drawn
from .methods.plan import drawn_beside
from .plane import nominal
from .printed.steps import as_printed
from .printed.uniform import uniform
from .problem.problem import Problem, Scales
from .task import Task, task_of
from .weighed import answers_of
from .words import Words, language

if TYPE_CHECKING:
    from .check.designs.found import Verified

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
    UnknownNameError where nothing of that name is read or found, or nobody can make that mistake.
    """
    of_kind(problem, Problem, Words("题目（load 或 loads 的结果）", "a problem, as load and loads give it,"))
    task = task_of(problem)
    size = sizes(problem, task.truth)  # first: the refusals of the truth know the range of the input that does assemble
    off = noise(problem, task.truth, size) if precise else dict.fromkeys(size, 0.0)
    amended = amend(readings, points, slip)
    if slip is not None:
        can_be_made(slip, constructed(problem, hand("exact"), AS_DRAWN).construction.acts)
    drawn = task.draw(hand(by, seed=seed, repeats=repeats), amended, sketch)
    found_all(amended, drawn.construction.acts, readings)
    answers = uniform(answers_of(task, drawn, off, size, scatters=by == "pencil", judged=bool(repeats)))
    if not precise and any(answer.suspect for answer in answers.values()):
        return solve(
            problem, by=by, seed=seed, repeats=repeats, readings=readings, points=points, slip=slip, sketch=sketch
        )
    construction, answers = as_printed(drawn.construction, answers)
    small = unfit(construction.figures, task.given({figure.view for figure in construction.figures}))
    told = (*problem.warnings, *((*at_rest(problem), *idle(problem), *paced(problem)) if precise else ()), *small)
    return Solution(problem, _warned(task, drawn._replace(construction=construction), answers), answers, told)


def solve_by_hands(problem: Problem, by: Hand) -> tuple[Solution, Drawn]:
    """The solution of a linkage by an exact hand, and what hands beside it found, in one drawing; its lines end as they
    are worked out, not as they are printed.

    Raises what `solve` raises.
    """
    task = task_of(problem)
    size = sizes(problem, task.truth)
    drawn = drawn_beside(problem, by, DrawingPaper(problem.paper))
    alone = drawn._replace(repeats={key: nominal(scalars) for key, scalars in drawn.repeats.items()})
    answers = answers_of(task, alone, dict.fromkeys(size, 0.0), size, scatters=False, judged=False)
    if any(answer.suspect for answer in answers.values()):
        return solve(problem, by="exact", repeats=0), drawn
    return Solution(problem, _warned(task, alone, answers), answers), drawn


def read_off(problem: Problem, by: Hand) -> tuple[dict[str, Answer], Construction]:
    """The answers of a linkage as this hand reads them, and what it drew; nobody reads the lines that are worked out,
    and no ideal hand's drawing is beside it to tell what is suspect.

    Raises what `solve` raises.
    """
    task = task_of(problem)
    size = sizes(problem, task.truth)
    off = noise(problem, task.truth, size)
    drawn = drawn_beside(problem, by, DrawingPaper(problem.paper))
    return answers_of(task, drawn, off, size, scatters=by.name == "pencil", judged=False), drawn.construction


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
