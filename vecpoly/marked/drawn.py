"""Students' drawings: each file told whose it is by its name, graded vector by vector, drawn over the exact polygons.

``2024001_3-9.dxf``, or ``2024001/3-9.dxf``: the student's number, then the problem.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from ..batch.register import Part, Register, Sheet
from ..drawing.backends.pdf import to_pdf
from ..errors import Fault, ProblemFileError, VecpolyError
from ..foundation.files import write_whole
from ..grading.drawings.grade import grade_drawing
from ..grading.drawings.judging.mark import DrawingMark
from ..grading.drawings.model import drawing_key
from ..grading.drawings.overlay import overlay
from ..grading.drawings.readers.door import READERS
from ..words import Lang, Words
from .out.tables import csv_bytes

HEAD = (
    Words("学号", "number"),
    Words("姓名", "name"),
    Words("题号", "problem"),
    Words("图", "figure"),
    Words("矢量", "vector"),
    Words("结论", "verdict"),
    Words("缘由", "reason"),
    Words("文件", "file"),
)
_PARTS = re.compile(r"[_\s]")
Told = Callable[[Words, int, int], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """The verdicts on all drawings of a class, the files that tell them, and what could not be used."""

    marks: tuple[tuple[Sheet, Part, DrawingMark], ...]
    files: tuple[Path, ...]
    faults: tuple[Fault, ...]


def grade_drawings(register: Register, folder: Path, out: Path, lang: Lang, told: Told) -> Drawn:
    """Grade every drawing in the folder; one that is nobody's, or cannot be read, is told and stops no other.

    Writes drawings.csv, a row for each vector, and for each file its polygons over the exact ones. No points follow
    from a drawing: they are a person's to give.
    """
    found = sorted(path for path in folder.rglob("*") if path.suffix.lower() in READERS)
    marks: list[tuple[Sheet, Part, DrawingMark]] = []
    files: list[Path] = []
    faults: list[Fault] = []
    for done, path in enumerate(found, 1):
        told(Words("看图", "reading drawings"), done, len(found))
        try:
            sheet, part = _owner(register, path)
            key = drawing_key(register.variant(part))
            mark = grade_drawing(key, path, scales=part.scales)
            if pages := overlay(mark, key, lang):
                name = f"{sheet.student.number}_{part.problem}.pdf"
                files.append(write_whole(out / "drawings" / name, to_pdf(*pages)))
            marks.append((sheet, part, mark))
        except ProblemFileError as error:
            faults += error.faults
        except VecpolyError as error:
            said = Words(f"{path.name}：", f"{path.name}: ") + error.words
            faults.append(Fault(said=said, code=error.code))
    table = write_whole(out / "drawings.csv", csv_bytes(list(_rows(marks, lang))))
    return Drawn(marks=tuple(marks), files=(table, *files), faults=tuple(faults))


def _owner(register: Register, path: Path) -> tuple[Sheet, Part]:
    """Whose drawing it is, and of which problem; raises VecpolyError where the name does not tell."""
    for number, problem in _names(path):
        sheet = next((one for one in register.sheets if number in (one.student.number, one.sheet)), None)
        part = next((one for one in sheet.parts if one.problem == problem), None) if sheet is not None else None
        if sheet is not None and part is not None:
            return sheet, part
    raise VecpolyError(
        Words(
            "文件名看不出是谁的哪道题；请命名为 学号_题号，如 2024001_3-9.dxf，或放在以学号命名的文件夹里",
            "its name does not tell whose it is, and of which problem; call it NUMBER_PROBLEM, as 2024001_3-9.dxf, "
            "or put it into a folder of the student's number",
        ),
        code="drawing-owner",
    )


def _names(path: Path) -> Iterator[tuple[str, str]]:
    """What the name may mean: number_problem, number_name_problem, number/problem."""
    parts = _PARTS.split(path.stem)
    if len(parts) > 1:
        yield parts[0], parts[-1]
    yield path.parent.name.partition("_")[0], path.stem


def _rows(marks: list[tuple[Sheet, Part, DrawingMark]], lang: Lang) -> Iterator[list[str | float]]:
    yield [word.of(lang) for word in HEAD]
    for sheet, part, mark in marks:
        for figure in mark.figures:
            for one in figure.vectors if figure.drawn else ():
                who = [sheet.student.number, sheet.student.name, part.problem]
                told = [figure.title.of(lang), one.key, one.verdict.words.of(lang), one.reason.of(lang)]
                yield [*who, *told, Path(mark.file).name]
