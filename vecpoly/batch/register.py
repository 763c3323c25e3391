"""The register of a class: who has which values, scales, key, layout. Grading reads it, and never draws again."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache, partial
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from ..errors import UnknownNameError, VecpolyError
from ..foundation.slotted import replace
from ..grading.key import AnswerKey
from ..grading.scheme import USUAL_SCHEME, Scheme
from ..problem.problem import Problem, Scales
from ..problem.values.made import problem as made
from ..problem.values.vary import vary
from ..words import Words
from .sheet.layout import Layout
from .student import Student

VERSION = 1
NAME = "register.json"


@dataclass(frozen=True, slots=True, kw_only=True)
class Exercise:
    """A problem of the assignment: its data as a problem file has them; what is demoted, and why; yield of the
    draws."""

    id: str
    data: Mapping[str, Any]
    fingerprint: str
    demoted: tuple[str, ...] = ()
    passed: float = 1.0
    failed: Mapping[str, float] | None = None

    def changed(self, now: Exercise) -> tuple[str, ...]:
        """The keys of the data, but for its texts, that are others now, so that values drawn of it would be others."""
        mine, theirs = (json.loads(json.dumps(dict(one.data), default=str)) for one in (self, now))
        return tuple(
            sorted(
                key for key in {*mine, *theirs} - {"title", "statement", "source"} if mine.get(key) != theirs.get(key)
            )
        )

    @property
    def problem(self) -> Problem:
        """The problem as the lecturer wrote it."""
        return _problem(self.id, json.dumps(self.data, ensure_ascii=False))


@lru_cache(maxsize=64)
def _problem(name: str, data: str) -> Problem:
    """The problem of these data, made once."""
    return made(json.loads(data), name=name)


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """One student's variant of a problem: attempt of the seed, values as written, scales (SI per mm), the key."""

    problem: str
    attempt: int
    values: Mapping[str, str]
    scales: Mapping[str, float]
    key: AnswerKey


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """One student's sheet; layout: None before it has been laid out."""

    sheet: str
    student: Student
    parts: tuple[Part, ...]
    layout: Layout | None = None
    layout_hash: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Register:
    """A class: its assignment, its problems, its sheets in the order of their numbers, how they are marked."""

    assignment: str
    salt: str
    title: Words
    lang: str
    vecpoly: str
    exercises: tuple[Exercise, ...]
    sheets: tuple[Sheet, ...]
    scheme: Scheme = USUAL_SCHEME
    version: int = VERSION

    def exercise(self, problem: str) -> Exercise:
        """The problem with this id. Raises UnknownNameError."""
        for one in self.exercises:
            if one.id == problem:
                return one
        raise UnknownNameError(Words(f"名册中没有题 {problem}", f"the register has no problem {problem}"))

    def sheet(self, number: str) -> Sheet | None:
        """The sheet of the student with this number; None where there is none."""
        return next((one for one in self.sheets if one.student.number == number), None)

    def variant(self, part: Part) -> Problem:
        """The problem as this student has it: to be solved with the student's own readings."""
        problem = self.exercise(part.problem).problem
        return replace(vary(problem, part.values) if part.values else problem, scales=Scales(part.scales))

    def marked_by(self, scheme: Scheme) -> Register:
        """The class with this scheme, whose points stand in every key."""
        sheets = (replace(sheet, parts=tuple(map(partial(_pointed, scheme), sheet.parts))) for sheet in self.sheets)
        return replace(self, sheets=tuple(sheets), scheme=scheme)

    def as_bytes(self) -> bytes:
        """The file, the same for the same class: a line for each sheet."""
        data = _adapter().dump_python(self, mode="json")
        sheets = ",\n".join(map(_line, data.pop("sheets")))
        rows = [f"{_line(name)}: {_line(value)}" for name, value in data.items()]
        return ("{" + ",\n".join([*rows, f'"sheets": [\n{sheets}\n]']) + "}\n").encode()


def _line(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


def _pointed(scheme: Scheme, part: Part) -> Part:
    return replace(part, key=scheme.key(part.key))


def read_register(path: Path) -> Register:
    """The register in a file, or in the folder that holds it. Raises VecpolyError where it is none, OSError."""
    file = path / NAME if path.is_dir() else path
    try:
        data = json.loads(file.read_bytes())
        if data.get("version") != VERSION:
            raise VecpolyError(
                Words(
                    f"{file}：名册版本为 {data.get('version')}，只能读版本 {VERSION}；请用写它的 vecpoly 版本",
                    f"{file}: the register has version {data.get('version')}, only {VERSION} is read; use "
                    f"the vecpoly that wrote it",
                ),
                code="version",
            )
        return _adapter().validate_python(data)
    except (ValueError, AttributeError) as error:
        if isinstance(error, VecpolyError):
            raise
        first = f"{error.errors()[0]['loc']}" if isinstance(error, ValidationError) else str(error)
        raise VecpolyError(
            Words(
                f"{file}：不是名册（{first}）；请用 vecpoly class 重新生成",
                f"{file}: no register ({first}); write it again by 'vecpoly class'",
            ),
            code="no-register",
        ) from None


def layout_from(data: object) -> Layout:
    """The layout in plain data."""
    return _layouts().validate_python(data)


@cache
def _layouts() -> TypeAdapter[Layout]:
    return TypeAdapter(Layout)


@cache
def _adapter() -> TypeAdapter[Register]:
    return TypeAdapter(Register)
