"""Answers as YAML or JSON: {student: ..., answers: {3-9: {v_E: 0.173}}}, or several under students: [...]."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path as FilePath

from pydantic import BaseModel, ConfigDict, ValidationError

from ...batch.roster import numbered
from ...errors import Place, TableError, UnknownNameError
from ...grading.key import AnswerKey
from ...problem.schema.faults import Path
from ...problem.schema.validate import first_told
from ...problem.text.source import read, read_text
from ...words import Words
from .heads import Head, head
from .joined import joined, twice
from .returned import Answers, Returned, written_twice

_EXAMPLE = Words(
    "（如 {student: 学号, answers: {3-9: {v_E: 0.173}}}）", " (e.g. {student: number, answers: {3-9: {v_E: 0.173}}})"
)


class Document(BaseModel):
    """One student's answers: problem → symbol → as it was written."""

    model_config = ConfigDict(extra="forbid", coerce_numbers_to_str=True)
    student: str
    answers: dict[str, dict[str, str | None]]


class Documents(BaseModel):
    """Those of several."""

    model_config = ConfigDict(extra="forbid")
    students: list[Document]


@dataclass(frozen=True, slots=True)
class _Read:
    """A document, and where each of its keys stands: its own path in the file, then that of the key."""

    document: Document
    path: Path
    places: Mapping[Path, Place]

    def place(self, *keys: str) -> Place:
        """Where a key of it stands, or the nearest above it."""
        path = (*self.path, *keys)
        return next(self.places[path[:n]] for n in range(len(path), -1, -1) if path[:n] in self.places)


def documents(
    path: FilePath,
    any_keys: Mapping[str, AnswerKey],
    keys_of: Callable[[str], Mapping[str, AnswerKey] | None],
    returned: Returned,
) -> None:
    """Add what a file holds. Raises TableError for what is no such document, with the key that is wrong."""
    for one in _parsed(path):
        number = numbered(one.document.student)
        keys = keys_of(number)
        if keys is None:
            said = Words(f"名册中没有学号 {number}；请核对", f"the register has no student {number}; check the number")
            returned.fault(one.place("student"), "stranger", said)
            continue
        for problem in one.document.answers:
            if problem not in keys:
                names = "、".join(keys)
                said = Words(
                    f"没有题 {problem}；有 {names}", f"there is no problem {problem}; there are {', '.join(keys)}"
                )
                returned.fault(one.place("answers", problem), "problem", said)
                continue
            _add(number, problem, one, keys[problem], returned)


def _add(student: str, problem: str, one: _Read, key: AnswerKey, returned: Returned) -> None:
    parts: dict[Head, str] = {}
    where: dict[str, Place] = {}
    for symbol, value in one.document.answers[problem].items():
        place = one.place("answers", problem, symbol)
        try:
            meant = head(symbol, {problem: key})
        except UnknownNameError as error:
            returned.fault(place, "symbol", error.words)
            continue
        more = {meant: value or ""}
        if twice(more, parts):
            returned.fault(place, "twice", written_twice(meant.symbol, where[meant.symbol]), student)
            continue
        parts |= more
        where.setdefault(meant.symbol, place)
    returned.add(Answers(student=student, problem=problem, cells=joined(key, parts), places=where))


def _parsed(path: FilePath) -> list[_Read]:
    _no_list(path)
    tree = read(path)
    model = Documents if "students" in tree.data else Document
    try:
        found = model.model_validate(tree.data)
    except ValidationError as error:
        said = Words(f"{path}：", f"{path}: ") + first_told(model, error) + _EXAMPLE
        raise TableError(said, code="document") from None
    if isinstance(found, Document):
        return [_Read(found, (), tree.places)]
    return [_Read(one, ("students", n), tree.places) for n, one in enumerate(found.students)]


def _no_list(path: FilePath) -> None:
    """Raise TableError for a list of students without its name."""
    if read_text(path).lstrip().startswith(("[", "- ")):
        said = Words(
            f"{path}：几名学生的答案请写在 students: 下，如 {{students: [{{student: 学号, answers: {{…}}}}, …]}}",
            f"{path}: those of several students stand under students:, as "
            "{students: [{student: number, answers: {...}}, ...]}",
        )
        raise TableError(said, code="document")
