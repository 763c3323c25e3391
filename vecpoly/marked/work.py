"""Mark the work of a class: everybody on the register, with what they returned, or without."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from functools import cache

from ..batch.register import Part, Register, Sheet
from ..batch.student import Student
from ..board.otherwise.slip import Slip
from ..errors import VecpolyError
from ..grading.marking.marked import Marked
from ..grading.marking.marker import mark
from ..grading.scheme import Scheme
from ..grading.sheet import sheet_of
from ..grading.slips.mutants import mutants
from ..mistakes import slips
from ..words import Words
from .intake.returned import Answers, Returned

Catalogue = Callable[[str], tuple[Slip, ...]]  # of a problem: the slips that can be made with it
PIECE = 10  # students of one task


@dataclass(frozen=True, slots=True, kw_only=True)
class Result:
    """One student: marks by problem, where each answer stands, what went wrong."""

    student: Student
    sheet: str
    marks: Mapping[str, Marked]
    places: Mapping[tuple[str, str], str] = field(default_factory=dict)
    returned: bool = True
    faults: tuple[Words, ...] = ()

    @property
    def total(self) -> float:
        """The points of all problems."""
        return sum(one.total for one in self.marks.values())

    @property
    def worth(self) -> float:
        """All points that could be had."""
        return sum(one.worth for one in self.marks.values())


def mark_class(register: Register, returned: Returned, scheme: Scheme, jobs: int = 1) -> Iterator[Result]:
    """Everybody on the register, in its order; what was returned by nobody is marked as blank.

    What goes wrong with one sheet is kept with it, and does not stop the others.
    """
    pieces = [register.sheets[i : i + PIECE] for i in range(0, len(register.sheets), PIECE)]
    tasks = [(replace(register, sheets=piece), _of(piece, returned), scheme) for piece in pieces]
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


def _marked(register: Register, answers: Mapping[tuple[str, str], Answers], scheme: Scheme) -> list[Result]:
    """One piece of the class."""
    catalogue = cache(lambda problem: slips(register.exercise(problem).problem))
    return [_result(register, sheet, answers, scheme, catalogue) for sheet in register.sheets]


def _result(
    register: Register, sheet: Sheet, answers: Mapping[tuple[str, str], Answers], scheme: Scheme, catalogue: Catalogue
) -> Result:
    marks: dict[str, Marked] = {}
    places: dict[tuple[str, str], str] = {}
    faults: list[Words] = []
    for part in sheet.parts:
        mine = answers.get((sheet.student.number, part.problem))
        marks[part.problem] = _one(register, part, mine, scheme, catalogue, faults)
        if mine is not None:
            places |= {(part.problem, symbol): place for symbol, place in mine.places.items()}
    returned = any((sheet.student.number, part.problem) in answers for part in sheet.parts)
    return Result(
        student=sheet.student, sheet=sheet.sheet, marks=marks, places=places, returned=returned, faults=tuple(faults)
    )


def _one(
    register: Register, part: Part, mine: Answers | None, scheme: Scheme, catalogue: Catalogue, faults: list[Words]
) -> Marked:
    key, variant = scheme.key(part.key), register.variant(part)
    written = sheet_of(key, mine.cells if mine is not None else {}, printed_scales=mine is not None)
    faults += written.faults
    try:
        return mark(variant, key, lambda: mutants(variant, key, catalogue(part.problem)), written, scheme.rules)
    except VecpolyError as error:  # told, and marked without a drawing
        faults.append(error.words)
        return mark(variant, key, tuple, written, replace(scheme.rules, following=False))
