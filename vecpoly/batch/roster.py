"""The roster: 学号, 姓名, 班级 in XLSX or CSV, as schools export them; what is wrong with a row does not stop the
others."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

from ..errors import Fault, Place, VecpolyError
from ..limits import PERSON, ROSTER
from ..tables.files import bytes_of
from ..tables.texts import decoded, separated
from ..tables.workbooks import WORKBOOKS, reading
from ..words import Words
from .columns import NAME, NUMBER, TEAM, is_one
from .student import Student

Row = tuple[int, tuple[str, ...]]  # its number in the file, from 1, and its cells
_HEADS = {"number": NUMBER, "name": (*NAME, "student"), "team": TEAM}
_NUMBER = re.compile(r"[A-Za-z0-9][A-Za-z0-9._\-]*")
_AS_FLOAT = re.compile(r"(\d{5,})\.0")


class RosterError(VecpolyError, ValueError):
    """A roster that cannot be read: file, row, column, cause, remedy."""


@dataclass(frozen=True, slots=True)
class Roster:
    """The students, in the order of the file, and what is wrong with the other rows; nameless: without a column of
    names."""

    students: tuple[Student, ...]
    faults: tuple[Fault, ...]
    nameless: bool = False


def read_roster(path: Path) -> Roster:
    """The roster in this file. Raises RosterError where no row of it can be read, or where a number stands twice."""
    rows = list(_rows(path))
    found = next(
        ((i, columns) for i, (_, cells) in enumerate(rows[:10]) if "number" in (columns := _columns(cells))), None
    )
    if found is None:
        heads = "、".join(cell for _, cells in rows[:1] for cell in cells if cell) or "—"
        raise RosterError(
            Words(
                f"{path}：前 10 行中没有“学号”一列（第 1 行为 {heads}）；请加表头：学号,姓名,班级",
                f"{path}: no column of student numbers in the first 10 rows (row 1 has {heads}); add a "
                f"header: number,name,class",
            ),
            code="no-header",
        )
    start, columns = found
    students, faults = list[tuple[int, Student]](), list[Fault]()
    for line, cells in rows[start + 1 :]:
        if any(cells) and "number" not in _columns(cells):  # a head of two rows, or one on each page
            one = _student(str(path), line, cells, columns)
            if isinstance(one, Fault):
                faults.append(one)
            else:
                students.append((line, one))
    _no_twins(path, students)
    if not students:
        raise RosterError(_nobody(path, faults), code="empty", faults=tuple(faults))
    return Roster(tuple(one for _, one in students), tuple(faults), nameless="name" not in columns)


def _nobody(path: Path, faults: Sequence[Fault]) -> Words:
    """That there are no students: no rows, or none that can be read."""
    if not faults:
        return Words(f"{path}：没有学生；表头下每行一名学生", f"{path}: no students; one a row below the header")
    rows = Words(
        f"{path}：{len(faults)} 行都读不出；首先，", f"{path}: none of {len(faults)} rows can be read; first, "
    )
    return rows + faults[0].words


def plain(text: object) -> str:
    """A cell as text: full-width letters and digits made plain, blanks folded, 20231234.0 as 20231234."""
    if text is None:
        return ""
    if isinstance(text, float) and text.is_integer():
        text = int(text)
    return " ".join(unicodedata.normalize("NFKC", str(text)).replace("\ufeff", "").split())


def numbered(text: object) -> str:
    """A student's number: as it stands, but 20231234.0, as tables of numbers are written out by some programs, without
    its end."""
    found = _AS_FLOAT.fullmatch(whole := plain(text))
    return whole if found is None else found[1]


def _columns(cells: Sequence[str]) -> dict[str, int]:
    """Which column holds what."""
    found: dict[str, int] = {}
    for i, cell in enumerate(cells):
        for what, heads in _HEADS.items():
            if is_one(cell, heads):
                found.setdefault(what, i)
    return found


def _student(file: str, line: int, cells: Sequence[str], columns: dict[str, int]) -> Student | Fault:
    """The student of a row, or what is wrong with it."""
    held = {what: cells[i] if i < len(cells) else "" for what, i in columns.items()}
    held["number"] = numbered(held["number"])
    if (wrong := _wrong(held)) is not None:
        column, code, said = wrong
        numbers = {"number": held["number"]} if held["number"] else {}
        return Fault(code=code, place=Place(file, line, columns[column] + 1), numbers=numbers, said=said)
    return Student(number=held["number"], name=held.get("name", ""), team=held.get("team", ""))


def _wrong(held: Mapping[str, str]) -> tuple[str, str, Words] | None:
    """What is wrong with a row: in which column, of what sort, in words."""
    number = held["number"]
    if not number:
        name = held.get("name")
        return "number", "missing", Words(
            f"{name or '此行'}没有学号；请补上", f"{name or 'this row'} has no number; fill it in"
        )  # fmt: skip
    if not held.get("name", "-"):  # a sum below the list, say
        return "name", "missing", Words(
            f"学号 {number} 没有姓名；若是学生请补上，若是合计等请删去此行",
            f"the number {number} has no name; fill it in, or delete the row if it is no student (a sum)",
        )  # fmt: skip
    if not _NUMBER.fullmatch(number):
        return "number", "spelling", Words(
            f"学号“{number}”应以字母或数字开头，且只能含字母、数字、'-'、'_' 和 '.'；请改正",
            f"the number '{number}' must begin with a letter or digit and may hold only these, '-', '_' and '.'; "
            "correct it",
        )  # fmt: skip
    if any(len(text) > PERSON or not text.isprintable() for text in held.values()):
        return "number", "out-of-range", Words(
            f"此行含有不可打印的字符，或学号、姓名、班级中有一格超过 {PERSON} 个字符；请改正",
            f"this row holds characters that cannot be printed, or a number, name or class of over {PERSON}; "
            "correct it",
        )  # fmt: skip
    return None


def _no_twins(path: Path, students: Sequence[tuple[int, Student]]) -> None:
    """Raise where two rows have one number: whose sheet would it be?"""
    first: dict[str, int] = {}
    for line, one in students:
        other = first.setdefault(one.number, line)
        if other != line:
            raise RosterError(
                Words(
                    f"{path}：学号 {one.number} 在第 {other} 行和第 {line} 行重复；请改正其一",
                    f"{path}: the number {one.number} stands in rows {other} and {line}; correct one of them",
                ),
                code="duplicate",
                numbers={"number": one.number, "row": other, "again": line},
            )


def _rows(path: Path) -> Iterator[Row]:
    """The rows of the file; raises RosterError for what is no table, OSError."""
    data = bytes_of(path, RosterError)
    reader = _xlsx if path.suffix.lower() in WORKBOOKS else _csv
    for line, cells in enumerate(reader(str(path), data), 1):
        if line > ROSTER:
            raise RosterError(
                Words(f"{path}：超过 {ROSTER} 行；请分成几份", f"{path}: more than {ROSTER} rows; split it"),
                code="too-long",
            )
        yield line, tuple(map(plain, cells))


def _xlsx(name: str, data: bytes) -> Iterator[Sequence[object]]:
    from openpyxl import load_workbook

    with reading(name, data, RosterError):
        sheet = load_workbook(BytesIO(data), data_only=True).worksheets[0]
        for one in tuple(sheet.merged_cells.ranges):  # what stands in a merged cell, a class, is said of all its rows
            said = one.start_cell.value
            sheet.unmerge_cells(one.coord)
            for row in range(one.min_row, min(one.max_row, ROSTER) + 1):
                sheet.cell(row, one.min_col).value = said
        yield from sheet.iter_rows(values_only=True)


def _csv(name: str, data: bytes) -> Iterator[Sequence[object]]:
    text = decoded(data, name, RosterError)
    mark = max("\t;,，", key=text[:4096].count)
    if mark == "，":
        text, mark = text.replace("，", ","), ","
    yield from separated(text, mark, name, RosterError)
