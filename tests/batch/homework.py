"""An assignment of one problem with ranges and one without, and classes that do it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest

import vecpoly
from vecpoly.batch import classwork
from vecpoly.batch.classwork import Made, Order, make_class
from vecpoly.batch.run.runners import Here
from vecpoly.batch.student import Student
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.problem import Problem
from vecpoly.problem.values.vary import data_of
from vecpoly.variants.pilot import Pilot

TEXT = """\
title: {zh: 第三次作业, en: Homework 3}
id: hw3
problems:
  - problem: 3-9
    id: block
    scales: null
    find: [v_C2B, v_C2C3, omega_3, v_E]
    vary: {AB: 24 mm .. 40 mm by 2 mm, phi: 0 deg .. 355 deg by 5 deg, omega: 8 rad/s cw .. 12 rad/s cw by 0.5 rad/s}
"""


def people(numbers: Sequence[int]) -> tuple[Student, ...]:
    return tuple(Student(number=f"2023{n:04}", name=f"学生{n}", team="机械 1 班") for n in numbers)


FOUR = people(range(4))


def ordered(out: Path, students: Sequence[Student], text: str = TEXT) -> Order:
    """The order for this class, its assignment beside the folder; as the command gives it."""
    out.mkdir(parents=True, exist_ok=True)
    file = out.parent / "hw3.yaml"
    file.write_text(text, encoding="utf-8")
    return Order(
        assignment=load_assignment(file), students=tuple(students), out=out, lang="zh", version=vecpoly.__version__
    )


def made(out: Path, students: Sequence[Student], text: str = TEXT) -> Made:
    """The whole class in this process."""
    with piloted():
        return make_class(ordered(out, students, text), Here(), lambda *_: None)


_PILOTS: dict[str, Pilot] = {}
_draw_pilot = classwork._pilot


def remembered(problem: Problem) -> Pilot:
    told = {key: value for key, value in data_of(problem).items() if key != "statement"}
    key = f"{told} {problem.ranges}"
    if key not in _PILOTS:
        _PILOTS[key] = _draw_pilot(problem)
    return _PILOTS[key]


@contextmanager
def piloted() -> Iterator[None]:
    """The pilot knows neither shards nor rosters: in this process it is drawn once for each problem."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(classwork, "_pilot", remembered)
        yield


def files(out: Path) -> dict[str, bytes]:
    """Everything that was made, without what is kept for going on."""
    return {
        str(file.relative_to(out)): file.read_bytes()
        for file in sorted(out.rglob("*"))
        if file.is_file() and ".work" not in file.parts
    }
