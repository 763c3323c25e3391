"""Students' drawings: each file told whose it is by its name, graded vector by vector, drawn over the exact polygons.

``2024001_3-9.dxf``, or ``2024001/3-9.dxf``: the student's number, then the problem.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..batch.register import Part, Register, Sheet
from ..drawing.backends.pdf import to_pdf
from ..drawing.scene import Scene
from ..errors import Fault, ProblemFileError, VecpolyError
from ..foundation.files import write_whole
from ..foundation.slotted import replace
from ..grading.drawings.grade import grade_drawing
from ..grading.drawings.judging.mark import DrawingMark
from ..grading.drawings.model import drawing_key
from ..grading.drawings.overlay import overlay
from ..grading.drawings.readers.door import READERS, read_drawing
from ..grading.sheet import sheet_of
from ..words import Lang, Words
from .intake.returned import Returned
from .out.plain import csv_bytes

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
class Work:
    """One drawing: whose it is, its verdicts, each polygon over the exact one."""

    sheet: Sheet
    part: Part
    mark: DrawingMark
    scenes: tuple[Scene, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """The drawings of a class by student's number and problem, the files that tell of them, and what could not be
    used."""

    works: Mapping[tuple[str, str], Work] = field(default_factory=dict)
    files: tuple[Path, ...] = ()
    faults: tuple[Fault, ...] = ()


NOBODYS = Drawn()


def grade_drawings(register: Register, returned: Returned, folder: Path, out: Path, lang: Lang, told: Told) -> Drawn:
    """Grade every drawing in the folder; one that is nobody's, or cannot be read, is told and stops no other.

    Writes drawings.csv, a row for each vector, and for each file its polygons over the exact ones.
    """
    there = sorted(path for path in folder.rglob("*") if path.is_file())
    found = [path for path in there if path.suffix.lower() in READERS]
    works: dict[tuple[str, str], Work] = {}
    files: list[Path] = []
    faults: list[Fault] = []
    for done, path in enumerate(found, 1):
        told(Words("看图", "reading drawings"), done, len(found))
        number = ""
        try:
            sheet, part = _owner(register, path, folder)
            number, whose = sheet.student.number, (sheet.student.number, part.problem)
            _refuse_second(works.get(whose))
            works[whose] = one = _work(register, returned, sheet, part, path, lang)
            if one.scenes:
                name = f"{sheet.student.number}_{part.problem}.pdf"
                files.append(write_whole(out / "drawings" / name, to_pdf(*one.scenes, title=name, lang=lang)))
        except VecpolyError as error:
            faults += _faults(path, error, number)
    faults += _of_other_programs(register, folder, set(there) - set(found), works)
    table = write_whole(out / "drawings.csv", csv_bytes(list(_rows(works.values(), lang))))
    return Drawn(works=works, files=(table, *files), faults=tuple(faults))


def _faults(path: Path, error: VecpolyError, number: str) -> list[Fault]:
    """What is wrong with a file, and whose it is where its name tells."""
    whose = {"student": number} if number else {}
    if isinstance(error, ProblemFileError):
        return [replace(one, numbers={**one.numbers, **whose}) for one in error.faults]
    said = Words(f"{path.name}：", f"{path.name}: ") + error.words
    return [Fault(said=said, code=error.code, numbers=whose)]


def _of_other_programs(
    register: Register, folder: Path, paths: Iterable[Path], works: Mapping[tuple[str, str], Work]
) -> Iterator[Fault]:
    """Drawings that nobody can read here, DWG and photographs, of whoever handed in none that can be read."""
    for path in sorted(paths):
        try:
            sheet, part = _owner(register, path, folder)
        except VecpolyError:
            continue  # a list of names, a picture of the system's
        if (sheet.student.number, part.problem) not in works:
            kinds = "、".join(READERS)
            said = Words(
                f"{path.name}：不是 {kinds} 文件，未能评图；DWG 请另存为 DXF，照片请人工批改",
                f"{path.name}: is none of {kinds.replace('、', ', ')} and was not marked; save a DWG as DXF, mark a "
                "photograph by hand",
            )
            yield Fault(said=said, code="format", numbers={"student": sheet.student.number})


def _work(register: Register, returned: Returned, sheet: Sheet, part: Part, path: Path, lang: Lang) -> Work:
    """The drawing at the scales that the sheet prints, or that its student typed; where one that nobody stated fits it
    better, it is held at that, for a person to look at."""
    answers = returned.answers.get((sheet.student.number, part.problem))
    typed = sheet_of(part.key, answers.cells).scales if answers is not None else {}
    key, drawing = drawing_key(register.variant(part)), read_drawing(path)
    mark = grade_drawing(key, drawing, scales={**part.scales, **typed})
    if mark.slip is None and _costs(mark):
        free = grade_drawing(key, drawing)
        mark = free if _costs(free) < _costs(mark) else mark
    return Work(sheet=sheet, part=part, mark=mark, scenes=overlay(mark, key, lang))


def _costs(mark: DrawingMark) -> int:
    """How many mistakes there are; a polygon that is not drawn is as many as it has vectors."""
    return sum(one.costs for figure in mark.figures for one in figure.vectors)


def _refuse_second(before: Work | None) -> None:
    """Raise where there is a drawing of this problem by this student already."""
    if before is not None:
        raise VecpolyError(
            Words(
                f"此题已有该生的图 {Path(before.mark.file).name}；只取先读到的，请只留一份",
                f"there is {Path(before.mark.file).name} of the same student and problem, which was taken; leave one",
            ),
            code="twice",
        )


def _owner(register: Register, path: Path, drawings: Path) -> tuple[Sheet, Part]:
    """Whose drawing it is, and of which problem; raises VecpolyError where the name does not tell."""
    for number, problem in _names(path):
        sheet = next((one for one in register.sheets if number in (one.student.number, one.sheet)), None)
        part = next((one for one in sheet.parts if one.problem == problem), None) if sheet is not None else None
        if sheet is not None and part is not None:
            return sheet, part
    raise VecpolyError(_why_nobodys(register, path, drawings), code="drawing-owner")


def _why_nobodys(register: Register, path: Path, drawings: Path) -> Words:
    """A student or a problem that the class has not, else a name that tells neither."""
    problems = {one.id for one in register.exercises}
    names = list(_names(path))
    for number, problem in names[:-1] if path.parent == drawings else names:
        known = any(number in (one.student.number, one.sheet) for one in register.sheets)
        if problem in problems and not known:
            return Words(
                f"登记表中没有学号 {number}；请核对文件名",
                f"the register has no student {number}; check the file's name",
            )
        if known and problem not in problems:
            there = ", ".join(sorted(problems))
            return Words(
                f"这次作业没有题 {problem}；有：{there}", f"this class has no problem {problem}; there are {there}"
            )
    return Words(
        "文件名看不出是谁的哪道题；请命名为 学号_题号，如 2024001_3-9.dxf，或放在以学号命名的文件夹里",
        "its name does not tell whose it is, and of which problem; call it NUMBER_PROBLEM, as 2024001_3-9.dxf, "
        "or put it into a folder of the student's number",
    )


def _names(path: Path) -> Iterator[tuple[str, str]]:
    """What the name may mean: number_problem, number_name_problem, number/problem, this last."""
    parts = _PARTS.split(path.stem)
    if len(parts) > 1:
        yield parts[0], parts[-1]
    yield path.parent.name.partition("_")[0], path.stem


def _rows(works: Iterable[Work], lang: Lang) -> Iterator[list[str | float]]:
    yield [word.of(lang) for word in HEAD]
    for work in works:
        who = [work.sheet.student.number, work.sheet.student.name, work.part.problem]
        for figure in work.mark.figures:
            for one in figure.vectors if figure.drawn else ():
                told = [figure.title.of(lang), one.key, one.verdict.words.of(lang), one.reason.of(lang)]
                yield [*who, *told, Path(work.mark.file).name]
        for said in work.mark.told:
            yield [*who, "", "", "", said.of(lang), Path(work.mark.file).name]
