"""Columns of another platform's table, as a small YAML file says: no platform is known to the program."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Sequence
from io import StringIO
from pathlib import Path
from typing import Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, field_validator, model_validator

from ...errors import FaultError, VecpolyError
from ...problem.problem import Problem
from ...problem.schema.validate import first_told
from ...problem.text.source import read
from ...words import Words
from ..register import Register, Sheet

_OF_STUDENT = ("number", "name", "class", "sheet")


class ColumnOf(BaseModel):
    """A column: its head, and what stands in it: number, name, class, sheet, a value such as ``3-9:AB``, or a text for
    everybody."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    head: str
    holds: str = ""
    text: str = ""

    @model_validator(mode="after")
    def _is_one_thing(self) -> Self:
        if self.holds and self.text:
            said = Words(
                f"列“{self.head}”又有 holds 又有 text；请只留一个",
                f"column '{self.head}' has holds and text; leave one of them",
            )
            raise FaultError(said, code="both")
        return self


class Profile(BaseModel):
    """A table for a platform: the name of the file, whether it begins with the mark of UTF-8, its columns."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    file: str
    mark: bool = True
    columns: tuple[ColumnOf, ...] = Field(min_length=1)

    @field_validator("file")
    @classmethod
    def _is_a_name(cls, file: str) -> str:
        if not re.fullmatch(r"[\w\-]+\.csv", file):
            raise FaultError(
                Words(
                    f"“{file}”不是文件名；应为字母、数字、“-”、“_”，以 .csv 结尾",
                    f"'{file}' is no name of the file: letters, digits, '-' and '_', and .csv at the end",
                ),
                code="spelling",
            )
        return file


def read_profile(path: Path) -> Profile:
    """The profile in this file. Raises VecpolyError with the key that is wrong."""
    try:
        return Profile.model_validate(read(path).data)
    except ValidationError as error:
        example = Words(
            "（如 {file: xuexitong.csv, columns: [{head: 学号, holds: number}]}）",
            " (e.g. {file: xuexitong.csv, columns: [{head: No, holds: number}]})",
        )
        said = Words(f"{path}：", f"{path}: ") + first_told(Profile, error) + example
        raise VecpolyError(said, code="profile") from None


def table_bytes(register: Register, profile: Profile) -> bytes:
    """The table, one row a student. Raises VecpolyError for a column that holds nothing known."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow(column.head for column in profile.columns)
    for sheet in register.sheets:
        writer.writerow(_cell(sheet, column) for column in profile.columns)
    return text.getvalue().encode("utf-8-sig" if profile.mark else "utf-8")


def guarded(text: str) -> str:
    """A text that no spreadsheet takes for a formula."""
    return f"'{text}" if text[:1] in "=+-@\t\r" and text[:1] else text


def _cell(sheet: Sheet, column: ColumnOf) -> str:
    if not column.holds:
        return column.text
    if column.holds in _OF_STUDENT:
        held = (sheet.student.number, sheet.student.name, sheet.student.team, sheet.sheet)
        return guarded(held[_OF_STUDENT.index(column.holds)])  # what others wrote; −43 mm is no formula
    problem, _, name = column.holds.partition(":")
    for part in sheet.parts:
        if part.problem == problem and name in part.values:
            return part.values[name]
    raise _nothing(column, [f"{part.problem}:{name}" for part in sheet.parts for name in part.values])


def refuse_unknown(profile: Profile, problems: Iterable[Problem]) -> None:
    """Raise VecpolyError for a column that would hold nothing, before anything is made."""
    values = [f"{problem.id}:{one.name}" for problem in problems for one in problem.ranges]
    for column in profile.columns:
        if column.holds and column.holds not in (*_OF_STUDENT, *values):
            raise _nothing(column, values)


def _nothing(column: ColumnOf, values: Sequence[str]) -> VecpolyError:
    known = (*_OF_STUDENT, *values)
    return VecpolyError(
        Words(
            f"列“{column.head}”的 holds: {column.holds} 不存在；可写 {'、'.join(known)}",
            f"column '{column.head}' holds {column.holds}, which is nothing; write one of {', '.join(known)}",
        ),
        code="profile",
    )
