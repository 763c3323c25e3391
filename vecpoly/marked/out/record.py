"""The marks of a class as one JSON file, and what differs from those of another day."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ...errors import VecpolyError
from ...words import Words
from ..work import Result

NAME = "marks.json"
VERSION = 1


def record(results: Sequence[Result], assignment: str) -> dict[str, Any]:
    """Everything that was found, as plain data."""
    return {"version": VERSION, "assignment": assignment, "students": [_student(one) for one in results]}


def record_bytes(results: Sequence[Result], assignment: str) -> bytes:
    """The file: the same marks, the same bytes."""
    return (json.dumps(record(results, assignment), ensure_ascii=False, indent=1, sort_keys=True) + "\n").encode()


def _student(one: Result) -> dict[str, Any]:
    return {
        "number": one.student.number, "name": one.student.name, "class": one.student.team, "sheet": one.sheet,
        "total": one.total, "worth": one.worth, "returned": one.returned,
        "faults": [{"zh": fault.zh, "en": fault.en} for fault in one.faults],
        "problems": {problem: marked.as_json() for problem, marked in one.marks.items()},
    }  # fmt: skip


def read_record(path: Path) -> dict[str, Any]:
    """The marks in a file, or in the folder that holds it. Raises VecpolyError where there are none, OSError."""
    file = path / NAME if path.is_dir() else path
    try:
        data = json.loads(file.read_bytes())
        if data["version"] == VERSION and isinstance(data["students"], list):
            return dict(data)
    except (ValueError, KeyError, TypeError):
        pass
    raise VecpolyError(
        Words(
            f"{file}：不是批改记录；请给出 vecpoly grade 写过的文件夹",
            f"{file}: no marks; name a folder that vecpoly grade wrote",
        ),
        code="no-marks",
    )


def differences(before: Mapping[str, Any], after: Mapping[str, Any]) -> list[list[str | float]]:
    """Student, problem, quantity, points before and after, what was written: of all that is marked otherwise."""
    rows: list[list[str | float]] = []
    old, new = _points(before), _points(after)
    for key in dict.fromkeys((*old, *new)):
        was, now = old.get(key), new.get(key)
        if was != now:
            rows.append([*key, *(_told(was)), *(_told(now))])
    return rows


def _points(data: Mapping[str, Any]) -> dict[tuple[str, str, str], tuple[float, str, str]]:
    return (
        {
            (student["number"], problem, one["key"]): (round(one["points"], 6), one["outcome"], one["written"])
            for student in data["students"]
            for problem, marked in student["problems"].items()
            for one in marked["answers"]
        }
        | {
            (student["number"], problem, f"{one['key']} (line)"): (round(one["points"], 6), one["verdict"], "")
            for student in data["students"]
            for problem, marked in student["problems"].items()
            for one in marked.get("lines", ())
        }
        | {
            (student["number"], problem, one["key"]): (round(one["points"], 6), one["outcome"], one["written"])
            for student in data["students"]
            for problem, marked in student["problems"].items()
            for one in marked.get("equations", ())
        }
    )


def _told(one: tuple[float, str, str] | None) -> list[str | float]:
    return ["", "", ""] if one is None else [one[0], one[1], one[2]]
