"""An assignment: a title block and several problems, each with what differs from its file."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

from ..errors import FaultError, ProblemFileError, UnknownNameError
from ..foundation.arguments import of_kind
from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass
from ..words import Words
from .build import build
from .load import opened
from .marking import NOTHING_SAID, Marking, marking_in
from .problem import Problem
from .reach import Reach, Resolver
from .schema.assignment import AssignmentSpec
from .schema.faults import Faults, meant
from .schema.validate import validate
from .text.overlay import overlay
from .text.source import Tree, decoded, parse, read

FIELDS = {
    "course": "课程",
    "class": "班级",
    "name": "姓名",
    "number": "学号",
    "grade": "成绩",
    "teacher": "任课教师",
    "date": "批改日期",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Assignment:
    """A sheet of problems; `block` has the keys of FIELDS, empty where nothing is written."""

    title: Words
    block: Mapping[str, str]
    problems: tuple[Problem, ...]
    path: Path | None = None
    id: str = ""  # in codes and seeds
    salt: str = ""
    marking: Marking = NOTHING_SAID

    def __post_init__(self) -> None:
        object.__setattr__(self, "block", FrozenMap(dict(self.block)))


def is_assignment(path: Path) -> bool:
    """Does this file list problems (an assignment) or is it one?"""
    data = read(path).data
    return "problems" in data and "links" not in data


def load_assignment(where: str | Path, *, allow_outside: bool = False, resolver: Resolver | None = None) -> Assignment:
    """The assignment in this file; allow_outside, resolver: as in `load`. Raises ProblemFileError."""
    of_kind(where, (str, Path), Words("文件名", "the name of a file"))
    path = Path(where)
    tree = _tree(path, str(where), Reach(path.parent, allow_outside, resolver))
    faults = Faults(tree.name, tree.places)
    spec = validate(AssignmentSpec, tree.data, faults)
    block = _block(spec.title_block, faults)
    problems = [_problem(item, i, tree, path, faults) for i, item in enumerate(spec.problems)]
    faults.settle()
    found = tuple(problem for problem in problems if problem is not None)
    _no_twins(found, faults)
    marking = marking_in(tree, spec)
    _refuse_strangers(marking, {problem.id for problem in found})
    return Assignment(
        title=spec.title, block=block, problems=found, path=path, id=spec.id or path.stem, salt=spec.salt,
        marking=marking,
    )  # fmt: skip


def _tree(path: Path, name: str, reach: Reach) -> Tree:
    """The values of the assignment: the resolver's, or the file's."""
    data = reach.held(name)
    tree = read(path) if data is None else parse(decoded(data, name), name)
    tree.reach = reach
    return tree


def block_of(written: Mapping[str, str], tree: Tree) -> dict[str, str]:
    """The title block of a file; raises ProblemFileError."""
    faults = Faults(tree.name, tree.places)
    block = _block(written, faults)
    faults.settle()
    return block


def _block(written: Mapping[str, str], faults: Faults) -> dict[str, str]:
    names = {**{key: key for key in FIELDS}, **{zh: key for key, zh in FIELDS.items()}}
    block = dict.fromkeys(FIELDS, "")
    for key, value in written.items():
        with faults.at("title_block", key):
            if key not in names:
                raise FaultError(
                    Words(f"标题栏没有“{key}”一项", f"unknown field '{key}'") + meant(key, names), code="unknown-key"
                )
            if block[names[key]]:
                raise FaultError(
                    Words(
                        f"'{key}' 与 '{FIELDS[names[key]]}' 是同一栏，且已填 '{block[names[key]]}'；请删去其一",
                        f"'{key}' and '{names[key]}' are one field, which holds "
                        f"'{block[names[key]]}' already; leave out one of them",
                    ),
                    code="contradiction",
                )
            block[names[key]] = value or ""
    return block


def _problem(item: str | dict[str, Any], index: int, tree: Tree, path: Path, faults: Faults) -> Problem | None:
    with faults.at("problems", index):
        over = part(tree, ("problems", index)) if isinstance(item, dict) else None
        name = item if isinstance(item, str) else item.get("problem")
        if not isinstance(name, str):
            raise FaultError(
                Words(
                    "请写出题号，如 {problem: 3-9, input: {omega: 10 rad/s ccw}}",
                    "name the problem, e.g. {problem: 3-9, input: {omega: 10 rad/s ccw}}",
                ),
                code="missing",
            )
        try:
            base, file = opened(name, path.parent, tree.reach)
        except (ProblemFileError, UnknownNameError) as error:
            raise FaultError(error.words, code=error.code) from None
        if over is None:
            return build(base, file)
        over.data.pop("problem")
        if "extends" in over.data:
            raise FaultError(
                Words(
                    f"此项已由 problem: {name} 指明题目，不能再写 extends；请删去",
                    f"problem: {name} says already on what this builds; leave out extends",
                ),
                "extends",
            )
        return build(overlay(base, over), file)
    return None


def part(tree: Tree, path: tuple[str | int, ...]) -> Tree:
    """The part of a tree below a path, with its places."""
    data: Any = tree.data
    for step in path:
        data = data[step]
    depth = len(path)
    return Tree(
        tree.name,
        dict(data),
        {p[depth:]: place for p, place in tree.places.items() if p[:depth] == path},
        tree.text,
        tree.files,
        tree.reach,
    )


def _refuse_strangers(marking: Marking, problems: Collection[str]) -> None:
    """Raise where points or totals stand for a problem that the assignment does not have."""
    faults = marking.faults
    for key, named in (("points", marking.said.points), ("totals", marking.said.totals)):
        for problem in named:
            with faults.at(key, problem):
                if problem not in problems:
                    raise FaultError(
                        Words(f"作业中没有题“{problem}”", f"the assignment has no problem '{problem}'")
                        + meant(problem, problems),
                        code="unknown-name",
                    )
    faults.settle()


def _no_twins(problems: tuple[Problem, ...], faults: Faults) -> None:
    seen: dict[str, int] = {}
    for i, problem in enumerate(problems):
        with faults.at("problems", i):
            if problem.id in seen:
                raise FaultError(
                    Words(
                        f"id“{problem.id}”已用于 problems[{seen[problem.id]}]；请另取一个，如 id: {problem.id}-b",
                        f"id '{problem.id}' is already that of problems[{seen[problem.id]}]; give this one "
                        f"another, e.g. id: {problem.id}-b",
                    ),
                    code="contradiction",
                )
            seen[problem.id] = i
    faults.settle()
