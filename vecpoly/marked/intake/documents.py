"""Answers as YAML or JSON: {student: ..., answers: {3-9: {v_E: 0.173}}}, one or a list of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError

from ...batch.roster import plain
from ...errors import Place, TableError, UnknownNameError
from ...grading.key import AnswerKey
from ...problem.schema.validate import first_told
from ...problem.text.source import read
from ...words import Words
from .heads import Head, head
from .joined import joined
from .returned import Answers, Returned


class Document(BaseModel):
    """One student's answers: problem → symbol → as it was written."""

    model_config = ConfigDict(extra="forbid", coerce_numbers_to_str=True)
    student: str
    answers: dict[str, dict[str, str | float | None]]


class Documents(BaseModel):
    """Those of several."""

    model_config = ConfigDict(extra="forbid")
    students: list[Document]


def documents(
    path: Path,
    any_keys: Mapping[str, AnswerKey],
    keys_of: Callable[[str], Mapping[str, AnswerKey] | None],
    returned: Returned,
) -> None:
    """Add what a file holds. Raises TableError for what is no such document, with the key that is wrong."""
    for n, one in enumerate(_parsed(path), 1):
        number, place = plain(one.student), Place(str(path), n)
        keys = keys_of(number)
        if keys is None:
            said = Words(f"名册中没有学号 {number}；请核对", f"the register has no student {number}; check the number")
            returned.fault(place, "stranger", said)
            continue
        for problem, cells in one.answers.items():
            if problem not in keys:
                names = "、".join(keys)
                said = Words(
                    f"没有题 {problem}；有 {names}", f"there is no problem {problem}; there are {', '.join(keys)}"
                )
                returned.fault(place, "problem", said)
                continue
            _add(number, problem, cells, keys, place, returned)


def _add(
    student: str,
    problem: str,
    cells: Mapping[str, Any],
    keys: Mapping[str, AnswerKey],
    place: Place,
    returned: Returned,
) -> None:
    parts: dict[Head, str] = {}
    for symbol, value in cells.items():
        try:
            parts[head(symbol, {problem: keys[problem]})] = "" if value is None else str(value)
        except UnknownNameError as error:
            returned.fault(place, "symbol", error.words)
    where = {one.symbol: place for one in parts}
    returned.add(Answers(student=student, problem=problem, cells=joined(keys[problem], parts), places=where))


def _parsed(path: Path) -> list[Document]:
    data = read(path).data
    try:
        if "students" in data:
            return Documents.model_validate(data).students
        return [Document.model_validate(data)]
    except ValidationError as error:
        model = Documents if "students" in data else Document
        example = Words(
            "（如 {student: 学号, answers: {3-9: {v_E: 0.173}}}）",
            " (e.g. {student: number, answers: {3-9: {v_E: 0.173}}})",
        )
        said = Words(f"{path}：", f"{path}: ") + first_told(model, error) + example
        raise TableError(said, code="document") from None
