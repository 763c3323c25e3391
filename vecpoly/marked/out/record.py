"""The marks of a class as one JSON file, and what differs from those of another day."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from ...errors import VecpolyError
from ...grading.compare.outcome import Outcome
from ...grading.drawings.judging.mark import Verdict
from ...words import Lang, Words
from ..work import Result

NAME = "marks.json"
VERSION = 1
_LINE = Words("（线）", " (line)")
_UNITS = Words("单位", "units")
_NOTHING = ("", "", "")
_Marked = tuple[str, str, str]  # student, problem, quantity
_Mark = tuple[float | str, str, str]  # points, outcome, what was written


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
        if data["version"] == VERSION:
            _points(data, "en")  # whatever is to be compared can be read
            return dict(data)
    except (ValueError, KeyError, TypeError, AttributeError):
        pass
    raise VecpolyError(
        Words(
            f"{file}：不是批改记录；请给出 vecpoly grade 写过的文件夹",
            f"{file}: no marks; name a folder that vecpoly grade wrote",
        ),
        code="no-marks",
    )


def differences(before: Mapping[str, Any], after: Mapping[str, Any], lang: Lang) -> list[list[str | float]]:
    """Student, problem, quantity, points before and after, what was written: of all that is marked otherwise."""
    rows: list[list[str | float]] = []
    old, new = _points(before, lang), _points(after, lang)
    for key in dict.fromkeys((*old, *new)):
        was, now = old.get(key), new.get(key)
        if was != now:
            rows.append([*key, *(was or _NOTHING), *(now or _NOTHING)])
    return rows


def _points(data: Mapping[str, Any], lang: Lang) -> dict[_Marked, _Mark]:
    """How everything was marked: numbers, rows of equations, lines of drawings, scales that are stated, units."""
    parts = [
        (student["number"], problem, marked)
        for student in data["students"]
        for problem, marked in student["problems"].items()
    ]
    return {
        (number, problem, one["key"]): (round(one["points"], 6), Outcome(one["outcome"]).words.of(lang), one["written"])
        for number, problem, marked in parts
        for one in (*marked["answers"], *marked.get("equations", ()))
    } | {
        (number, problem, one["key"] + _LINE.of(lang)): (
            round(one["points"], 6), Verdict(one["verdict"]).words.of(lang), ""
        )
        for number, problem, marked in parts
        for one in marked.get("lines", ())
    } | {
        (number, problem, name): (points, "", "")
        for number, problem, marked in parts
        for name, points in _beside(marked, lang) if points
    }  # fmt: skip


def _beside(marked: Mapping[str, Any], lang: Lang) -> Iterator[tuple[str, float]]:
    """What a sheet has for the scales that it states, and loses by its units."""
    yield from ((name, round(points, 6)) for name, points in marked.get("stated", {}).items())
    yield _UNITS.of(lang), -round(marked.get("lost", 0.0), 6)
