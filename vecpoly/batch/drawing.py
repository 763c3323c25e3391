"""Values for a whole class: everybody's first variant that is far enough from those of all others."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

from ..errors import NotAskedError, VecpolyError
from ..foundation.stock import A4
from ..grading.key import AnswerKey
from ..problem.problem import Problem
from ..variants.apart import Apart, Taken
from ..variants.conditions import Condition
from ..variants.judge import Standard
from ..variants.obstacle import obstacle
from ..variants.pilot import Pilot
from ..variants.seeds import Seed
from ..words import Words
from .register import Part
from .run.runners import Runner, Task
from .run.store import Store, digest
from .run.tasks import Draw, cut

BATCH = 10  # students of one task
ROUNDS = 48  # in which somebody may be too near to another
HOPELESS = 60  # variants that are too near to somebody's, one after another: the ranges hold no more
FAR_FEWER = 2.0  # times the students that seem to have room: more are refused before anything is drawn
Told = Callable[[str, int, int], None]  # what is being done, how much of it, of how much


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """A problem to be drawn for everybody, with what all variants are held to."""

    problem: Problem
    fingerprint: str
    standard: Standard


def drawn(
    course: Course,
    seeds: Sequence[Seed],
    kept: Mapping[str, Part],
    run: Runner,
    out: Path,
    told: Told,
    begin: float = 0.0,
) -> tuple[dict[str, Part], dict[str, VecpolyError]]:
    """Student -> variant, and whoever got none. kept: what was handed out before, and stays. begin: where in the class
    this process begins (0 to 1): shards that see one folder share the work, each begins at its own place.

    Everybody's turn comes in an order that follows from the seeds alone: the order of the roster does not matter.
    """
    apart, parts = Apart(course.problem.gate.apart), dict(kept)
    for number in sorted(kept):
        apart.takes(kept[number].key)
    first = sorted(
        (seed for seed in seeds if seed.student not in kept), key=lambda seed: seed.stream(-1).below(1 << 60)
    )
    waiting, refused, vain = [(seed, 0) for seed in first], dict[str, VecpolyError](), 0
    for _ in range(ROUNDS):
        left: list[tuple[Seed, int]] = []
        for seed, found in _found(course, waiting, apart.taken, run, out, told, begin):
            good = next((part for part in found if apart.takes(part.key)), None)
            vain = 0 if good is not None else vain + len(found)
            if good is not None:
                parts[seed.student] = good
            elif not found:
                refused[seed.student] = _no_variant(course, obstacle(course.problem, seed, course.standard))
            else:
                left.append((seed, found[-1].attempt + 1))
        waiting = left
        if vain >= HOPELESS or not waiting:
            break
    return parts, refused | {seed.student: _no_variant(course, Condition.APART) for seed, _ in waiting}


def _found(
    course: Course, waiting: Sequence[tuple[Seed, int]], taken: Taken, run: Runner, out: Path, told: Told, begin: float
) -> Iterator[tuple[Seed, list[Part]]]:
    """The variants of each from an attempt on, in this order."""
    tasks = [
        Draw(
            problem=course.problem,
            fingerprint=course.fingerprint,
            standard=course.standard,
            taken=taken,
            seeds=tuple(seed for seed, _ in piece),
            starts=tuple(start for _, start in piece),
        )
        for piece in cut(waiting, BATCH)
    ]
    results = finished(tasks, run, out, lambda done, of: told(course.problem.id, done, of), begin)
    for task, result in zip(tasks, results, strict=True):
        for seed, found in zip(task.seeds, result, strict=True):
            yield seed, [Part(**{**one, "key": AnswerKey.from_json(one["key"])}) for one in found]


def finished(
    tasks: Sequence[Task], run: Runner, out: Path, told: Callable[[int, int], None], begin: float = 0.0
) -> list[Any]:
    """The results of all tasks: of those that are on file, and of the others when they are done."""
    store = Store(out)
    results = [store.get(task.address) for task in tasks]
    waiting = [n for n, result in enumerate(results) if result is None]
    first = int(begin * len(waiting))
    todo = waiting[first:] + waiting[:first]
    told(len(tasks) - len(todo), len(tasks))
    for count, (number, result) in enumerate(run.each([tasks[n] for n in todo], out), 1):
        results[todo[number]] = result
        told(len(tasks) - len(todo) + count, len(tasks))
    return results


def refuse_too_few(problem: Problem, found: Pilot, students: int) -> None:
    """Raise VecpolyError where the grids hold fewer good values than there are students, who are to be told apart, or
    where by far not so many can be."""
    count = prod(one.count for one in problem.ranges)
    good, some = int(count * found.passed), max(1.0, found.room)
    if not problem.gate.apart or (good >= students and FAR_FEWER * some >= students):
        return
    few = Words(
        f"{count} 组数据中约 {good} 组合格，而学生有 {students} 名",
        f"of {count} sets of values some {good} pass, for {students} students",
    )
    near = Words(
        f"读数能互相拉开距离的学生约 {some:.0f} 名，而学生有 {students} 名",
        f"about {some:.0f} of {students} students can be told apart by their readings",
    )
    said, remedy = few if good < students else near, Condition.APART.remedy
    raise VecpolyError(
        Words(
            f"题 {problem.id}：{said.zh}；请{remedy.zh}，如 0",
            f"problem {problem.id}: {said.en}; {remedy.en}, say to 0",
        ),
        code="too-few",
        numbers={"good": good, "room": min(some, count), "students": students},
    )


def refuse_other_paper(problem: Problem) -> None:
    """Raise NotAskedError where the drawings are not on A4, for which the tags of a class's sheets are placed."""
    if problem.paper.format == A4:
        return
    name = problem.paper.format.name
    raise NotAskedError(
        Words(
            f"题 {problem.id} 用 {name} 图纸，而班级题单的定位标记按 A4 排布；请去掉 sheet 中的 format",
            f"problem {problem.id} is drawn on {name} paper, and the tags of a class's sheets have their places on A4: "
            "take `format` out of `sheet`",
        ),
        code="not-on-a4",
        numbers={"problem": problem.id, "format": name},
    )


def _no_variant(course: Course, why: Condition) -> VecpolyError:
    name = course.problem.id
    return VecpolyError(
        Words(
            f"题 {name}：没有找到合格的数据：{why.words.zh}；请{why.remedy.zh}",
            f"problem {name}: no variant was found: {why.words.en}; {why.remedy.en}",
        ),
        code="no-variant",
        numbers={"problem": name, "condition": str(why)},
    )


def fingerprint(data: object, version: str) -> str:
    """What a problem's variants follow from, in a few letters: its data and the program."""
    return digest(["problem", data, version])
