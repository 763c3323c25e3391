"""From a class folder and answer files to a folder of grades, feedback, analysis and queue."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..batch.register import Register
from ..errors import Fault
from ..foundation.files import write_whole
from ..foundation.slotted import replace
from ..grading.key import AnswerKey
from ..grading.scheme import Scheme
from ..words import Lang, Words
from .drawn import NOBODYS, grade_drawings
from .foreign import own_work
from .intake.read import read_answers
from .intake.returned import Returned
from .out.items import items
from .out.plain import csv_bytes
from .out.queue import queue_rows
from .out.record import NAME, differences, read_record, record, record_bytes
from .out.tables import grade_rows, xlsx_bytes
from .work import Result, mark_class

CHANGES = (
    Words("学号", "number"),
    Words("题号", "problem"),
    Words("量", "quantity"),
    Words("原得分", "points before"),
    Words("原结论", "outcome before"),
    Words("原所写", "written before"),
    Words("得分", "points"),
    Words("结论", "outcome"),
    Words("所写", "written"),
)
Told = Callable[[Words, int, int], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Order:
    """What is to be marked, by which scheme, where the marks go.

    before: marks of another day to compare with; drawings: the folder of the students' drawings.
    """

    register: Register
    files: tuple[Path, ...]
    out: Path
    scheme: Scheme
    lang: Lang
    jobs: int = 1
    feedback: bool = True
    before: Path | None = None
    drawings: Path | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Graded:
    """What came out: everybody's results, what could not be used, the files, what is marked otherwise than before."""

    results: tuple[Result, ...]
    faults: tuple[Fault, ...]
    files: tuple[Path, ...]
    changed: tuple[tuple[str | float, ...], ...] | None = None


def grade(order: Order, told: Told) -> Graded:
    """Mark a class. Raises what reading the files raises; what is wrong with one row or sheet is kept and told."""
    register = order.register
    before = None if order.before is None else read_record(order.before)
    returned = gathered(register, order.files)
    drawn = NOBODYS
    if order.drawings is not None:
        drawn = grade_drawings(register, returned, order.drawings, order.out, order.lang, told)
    marked = mark_class(register, returned, order.scheme, order.jobs, drawn)
    results = tuple(
        own_work(register, one, order.scheme, returned) for one in _counted(marked, len(register.sheets), told)
    )
    faults = (*returned.faults, *drawn.faults)
    aside = {str(one.numbers["student"]) for one in faults if "student" in one.numbers}
    results = tuple(replace(one, aside=one.student.number in aside) for one in results)
    changed = None if before is None else differences(before, record(results, register.assignment), order.lang)
    files = list(_tables(order, results, faults, changed))
    if order.feedback:
        from .out.feedback import feedback_files

        files += feedback_files(register, results, order.out, order.lang, told, order.scheme.rules)
    files += drawn.files
    kept = None if changed is None else tuple(map(tuple, changed))
    return Graded(results=results, faults=faults, files=tuple(files), changed=kept)


def gathered(register: Register, files: Sequence[Path]) -> Returned:
    """The answers of all files, in their order."""
    keys = {sheet.student.number: {part.problem: part.key for part in sheet.parts} for sheet in register.sheets}
    any_keys: Mapping[str, AnswerKey] = next(iter(keys.values()), {})
    sheets = {sheet.student.number: sheet for sheet in register.sheets}
    whole = Returned()
    for file in files:
        one = read_answers(file, any_keys, keys.get, sheets)
        for answers in one.answers.values():
            whole.add(answers)
        whole.faults += one.faults
    return whole


def _counted(results: Iterator[Result], count: int, told: Told) -> Iterator[Result]:
    for done, result in enumerate(results, 1):
        told(Words("批改", "marking"), done, count)
        yield result


def _tables(
    order: Order, results: Sequence[Result], faults: Sequence[Fault], changed: list[list[str | float]] | None
) -> Iterator[Path]:
    out, lang = order.out, order.lang
    yield write_whole(out / "grades.csv", csv_bytes(grade_rows(results, lang)))
    first = next(iter(order.register.sheets), None)
    keys = [order.scheme.key(part.key) for part in first.parts] if first else []
    yield write_whole(out / "grades.xlsx", xlsx_bytes(results, items(results), lang, keys, order.scheme.rules))
    yield write_whole(out / "queue.csv", csv_bytes(queue_rows(results, lang, faults)))
    yield write_whole(out / NAME, record_bytes(results, order.register.assignment))
    if changed is not None:
        head: list[Any] = [word.of(lang) for word in CHANGES]
        yield write_whole(out / "changes.csv", csv_bytes([head, *changed]))
