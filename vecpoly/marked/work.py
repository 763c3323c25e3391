"""Mark the work of a class: everybody on the register, with what they returned, or without."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache

from ..batch.register import Part, Register, Sheet
from ..batch.student import Student
from ..board.otherwise.slip import Slip
from ..errors import Place, VecpolyError
from ..foundation.slotted import replace
from ..grading.drawings.judging.mark import DrawingMark
from ..grading.marking.marked import Marked
from ..grading.marking.marker import mark
from ..grading.scheme import Scheme
from ..grading.sheet import sheet_of
from ..grading.slips.mutants import mutants
from ..mistakes import slips
from ..words import Words
from .drawn import NOBODYS, Drawn, Work
from .intake.returned import Answers, Returned

Given = Mapping[tuple[str, str], Answers]
Catalogue = Callable[[str], tuple[Slip, ...]]  # of a problem: the slips that can be made with it
PIECE = 10  # students of one task


@dataclass(frozen=True, slots=True, kw_only=True)
class Result:
    """One student: marks by problem, where each answer stands, drawings over the exact ones, what went wrong."""

    student: Student
    sheet: str
    marks: Mapping[str, Marked]
    places: Mapping[tuple[str, str], Place] = field(default_factory=dict)
    returned: bool = True
    aside: bool = False  # a row of this student was not used
    drawings: Mapping[str, Work] = field(default_factory=dict)
    faults: tuple[Words, ...] = ()

    @property
    def total(self) -> float:
        """The points of all problems."""
        return sum(one.total for one in self.marks.values())

    @property
    def worth(self) -> float:
        """All points that could be had."""
        return sum(one.worth for one in self.marks.values())

    @property
    def waiting(self) -> int:
        """Answers, rows and scales that a person must look at."""
        return sum(one.waiting for one in self.marks.values()) + self.aside + len(self.faults)


def mark_class(
    register: Register, returned: Returned, scheme: Scheme, jobs: int = 1, drawn: Drawn = NOBODYS
) -> Iterator[Result]:
    """Everybody on the register, in its order; what was returned by nobody is marked as blank.

    What goes wrong with one sheet is kept with it, and does not stop the others.
    """
    pieces = [register.sheets[i : i + PIECE] for i in range(0, len(register.sheets), PIECE)]
    tasks = [(replace(register, sheets=piece), _of(piece, returned), scheme, _drawn(piece, drawn)) for piece in pieces]
    if jobs < 2 or len(tasks) < 2:
        for task in tasks:
            yield from _marked(*task)
        return
    with ProcessPoolExecutor(max_workers=min(jobs, len(tasks))) as pool:
        for results in pool.map(_marked, *zip(*tasks, strict=True)):
            yield from results


def _of(piece: Sequence[Sheet], returned: Returned) -> dict[tuple[str, str], Answers]:
    numbers = {sheet.student.number for sheet in piece}
    return {key: one for key, one in returned.answers.items() if key[0] in numbers}


def _drawn(piece: Sequence[Sheet], drawn: Drawn) -> dict[tuple[str, str], Work]:
    numbers = {sheet.student.number for sheet in piece}
    return {key: one for key, one in drawn.works.items() if key[0] in numbers}


def _marked(register: Register, answers: Given, scheme: Scheme, drawn: Mapping[tuple[str, str], Work]) -> list[Result]:
    """One piece of the class."""
    catalogue = cache(lambda problem: slips(register.exercise(problem).problem))
    return [_result(register, sheet, answers, scheme, catalogue, drawn) for sheet in register.sheets]


def _result(
    register: Register,
    sheet: Sheet,
    answers: Given,
    scheme: Scheme,
    catalogue: Catalogue,
    drawn: Mapping[tuple[str, str], Work],
) -> Result:
    marks: dict[str, Marked] = {}
    places: dict[tuple[str, str], Place] = {}
    faults: list[Words] = []
    for part in sheet.parts:
        whose = (sheet.student.number, part.problem)
        mine, work = answers.get(whose), drawn.get(whose)
        marks[part.problem] = _one(register, part, mine, scheme, catalogue, faults, None if work is None else work.mark)
        if mine is not None:
            places |= {(part.problem, symbol): place for symbol, place in mine.places.items()}
    whole = [(sheet.student.number, part.problem) for part in sheet.parts]
    return Result(
        student=sheet.student, sheet=sheet.sheet, marks=marks, places=places, faults=tuple(faults),
        returned=any(one in answers or one in drawn for one in whole),
        drawings={one[1]: drawn[one] for one in whole if one in drawn},
    )  # fmt: skip


def _one(
    register: Register,
    part: Part,
    mine: Answers | None,
    scheme: Scheme,
    catalogue: Catalogue,
    faults: list[Words],
    drawing: DrawingMark | None,
) -> Marked:
    key, variant = scheme.key(part.key), register.variant(part)
    something = mine is not None or drawing is not None
    written = sheet_of(key, mine.cells if mine is not None else {}, printed_scales=something)
    faults += [Words(f"题 {part.problem}：", f"problem {part.problem}: ") + fault for fault in written.faults]
    try:
        return mark(
            variant, key, lambda: mutants(variant, key, catalogue(part.problem)), written, scheme.rules, drawing
        )
    except VecpolyError as error:  # told, and marked without a drawing
        faults.append(error.words)
        return mark(variant, key, tuple, written, replace(scheme.rules, following=False), drawing)
