"""A class of three with a problem of one variant, made once; answer files in every shape."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from itertools import cycle
from pathlib import Path

from vecpoly import load
from vecpoly.batch.register import Exercise, Part, Register, Sheet
from vecpoly.batch.student import Student
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import Kind
from vecpoly.grading.scheme import Scheme
from vecpoly.marked.graded import Graded, Order, grade
from vecpoly.problem.values.vary import data_of
from vecpoly.words import Lang, Words

NUMBERS = ("2023001", "2023002", "2023003")
ANGLES = ("45 deg", "40 deg", "50 deg")
Change = Callable[[str, str], str]  # of a student's answer to a quantity


@cache
def register() -> Register:
    """Three students, each with an own crank angle of 3-9."""
    problem = load("3-9")
    parts = []
    for angle in ANGLES:
        variant = problem.vary(phi=angle)
        key = answer_key(variant)
        parts.append(Part(problem="3-9", attempt=0, values={"phi": angle}, scales=dict(key.scales), key=key))
    sheets = tuple(
        Sheet(sheet=f"S{n}", student=Student(number=number, name=name, team="机1"), parts=(part,))
        for n, (number, name, part) in enumerate(zip(NUMBERS, ("张三", "=李四", "王五"), parts, strict=True))
    )
    exercise = Exercise(id="3-9", data=data_of(problem), fingerprint="")
    title = Words("作业", "Homework")
    return Register(
        assignment="hw", salt="", title=title, lang="zh", vecpoly="test", exercises=(exercise,), sheets=sheets
    )


def answers(number: str, change: Change = lambda key, text: text) -> dict[str, str]:
    """A student's right answers to all that is asked, changed as is said."""
    sheet = register().sheet(number)
    assert sheet is not None
    cells = {}
    for one in sheet.parts[0].key.quantities:
        if one.asked:
            sense = (" 逆" if one.exact > 0 else " 顺") if one.kind is Kind.SIGNED else ""
            cells[one.key] = change(one.key, f"{abs(one.exact):.4g}{sense}")
    return cells


def everybody() -> dict[str, dict[str, str]]:
    return {number: answers(number) for number in NUMBERS}


# N was once read as "no", and the row that the form itself writes told as one without a number
UNITS = (
    "N",
    "mm",
    "°",
    "↻ ↺",
    "N·m",
    "m/s",
    "(m/s²)/mm",
    "v_C = v_B + v_CB: ✓ ?",
    "kg·m²",
    "r/min",
    "s",
    "",
    "g·mm",
    "✓ ×",
    "Ⅱ Ⅲ Ⅳ",
)


def wide(path: Path, rows: Mapping[str, Mapping[str, str]], *, encoding: str = "utf-8", mark: str = ",") -> Path:
    """A CSV file with a row of units, as the answers form has it: all that it may write, one after another."""
    heads = list(next(iter(rows.values())))
    lines = [
        mark.join(["学号", *heads]),
        mark.join(["", *(unit for unit, _ in zip(cycle(UNITS), heads, strict=False))]),
    ]
    lines += [mark.join([number, *(cells[head] for head in heads)]) for number, cells in rows.items()]
    path.write_bytes("\r\n".join(lines).encode(encoding))
    return path


def graded(
    out: Path,
    *files: Path,
    scheme: Scheme | None = None,
    before: Path | None = None,
    feedback: bool = False,
    drawings: Path | None = None,
    lang: Lang = "zh",
) -> Graded:
    """Mark these files into a folder."""
    order = Order(
        register=register(),
        files=files,
        out=out,
        scheme=scheme or Scheme(),
        lang=lang,
        feedback=feedback,
        drawings=drawings,
        before=before,
    )
    return grade(order, lambda *_: None)
