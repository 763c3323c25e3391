"""The two kinds of work that are shared out: to draw the values of some students, and to write their sheets."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from ...errors import VecpolyError
from ...foundation.files import write_whole
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...solution import solve
from ...variants.apart import Taken
from ...variants.draw import Variant, variants
from ...variants.judge import Standard
from ...variants.keyed import key_for
from ...variants.seeds import Seed
from ...words import Lang, Words
from ..codes import sheet_id
from ..register import Part, Register, Sheet
from ..sheet.compose import composed, layout_of
from ..sheet.write import sheet_bytes
from ..solved import solution_bytes
from ..student import Student
from .store import Store, bytes_digest, digest

SEVERAL = 2  # variants that are found at once for somebody whose first is too near to another's


@dataclass(frozen=True, slots=True, kw_only=True)
class Draw:
    """Find variants of a problem for some students, for each from an attempt on."""

    problem: Problem
    fingerprint: str
    standard: Standard
    seeds: tuple[Seed, ...]
    starts: tuple[int, ...]
    taken: Taken

    @property
    def address(self) -> str:
        return digest(
            ["draw", self.fingerprint, [asdict(seed) for seed in self.seeds], self.starts, asdict(self.taken)]
        )

    def run(self, out: Path) -> list[list[dict[str, Any]]]:
        """For each student the variants that were found, as plain data; what another process found is not sought."""
        if (known := Store(out).get(self.address)) is not None:
            return list(known)
        found = [
            [
                _plain(one, self.standard)
                for one in islice(
                    variants(self.problem, seed, self.standard, self.taken, start), SEVERAL if start else 1
                )
            ]
            for seed, start in zip(self.seeds, self.starts, strict=True)
        ]
        Store(out).put(self.address, found, {})
        return found


def _plain(one: Variant, standard: Standard) -> dict[str, Any]:
    part = Part(
        problem=one.problem.id,
        attempt=one.attempt,
        values=dict(one.values),
        scales=dict(one.problem.scales.given),
        key=key_for(one.key, standard),
    )
    return {**asdict(part), "key": part.key.as_json()}


@dataclass(frozen=True, slots=True, kw_only=True)
class Print:
    """Write question and solution of some students."""

    register: Register  # with these students' sheets alone
    mark: str  # of everything else that the pages follow from

    @property
    def address(self) -> str:
        return digest(["print", self.mark, self.register.as_bytes().decode()])

    def run(self, out: Path) -> list[dict[str, Any]]:
        """For each student the layout, or what went wrong; the files lie beside."""
        results, files = list[dict[str, Any]](), dict[str, str]()
        for sheet in self.register.sheets:
            try:
                layout, written = _printed(self.register, sheet, out)
                results.append({"number": sheet.student.number, "layout": layout})
                files |= written
            except (OSError, MemoryError):
                raise  # it is not the sheet
            except Exception as error:  # also a fault of ours: one sheet that cannot be written stops no other
                why = error.words if isinstance(error, VecpolyError) else _fault(error)
                results.append({"number": sheet.student.number, "error": {"zh": why.zh, "en": why.en}})
        Store(out).put(self.address, results, files)
        return results


def _fault(error: Exception) -> Words:
    """What is told of an error that nobody foresaw."""
    said = f"{type(error).__name__}: {error}".splitlines()[0][:200]
    return Words(f"程序内部错误（{said}），请报告", f"a fault inside vecpoly ({said}); please report it")


def _printed(register: Register, sheet: Sheet, out: Path) -> tuple[dict[str, Any], dict[str, str]]:
    """The two PDFs of a student: layout, and names with digests."""
    lang: Lang = "zh" if register.lang == "zh" else "en"
    solutions = [solve(register.variant(part), precise=False) for part in sheet.parts]
    seeds = [
        Seed(assignment=register.assignment, problem=part.problem, student=sheet.student.number, salt=register.salt)
        for part in sheet.parts
    ]
    pages = composed(
        [(solution, part.key, seed) for solution, part, seed in zip(solutions, sheet.parts, seeds, strict=True)], lang
    )
    title = register.title.of(lang)
    question = sheet_bytes(
        pages, title=title, assignment=register.assignment, sheet=sheet.sheet, student=sheet.student, lang=lang
    )
    made = {
        question_file(sheet.student): question,
        solution_file(sheet.student): solution_bytes(solutions, register, sheet),
    }
    for name, data in made.items():
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        write_whole(out / name, data)
    return layout_of(pages).as_json(), {name: bytes_digest(data) for name, data in made.items()}


def question_file(student: Student) -> str:
    """Where a question lies."""
    return f"questions/{file_name(student)}.pdf"


def solution_file(student: Student) -> str:
    """Where a solution lies."""
    return f"solutions/{file_name(student)}.pdf"


def file_name(student: Student) -> str:
    """20231234_王小明: what may stand in the name of a file on any system."""
    name = "".join(char for char in student.name if char.isalnum())
    return f"{student.number}_{name}" if name else student.number


def own(register: Register, sheets: Sequence[Sheet]) -> Register:
    """The register with these sheets alone, and no more of its problems than the pages need."""
    exercises = tuple(replace(one, passed=1.0, failed=None) for one in register.exercises)
    return replace(register, exercises=exercises, sheets=tuple(sheets))


def bare(student: Student, parts: Sequence[Part], assignment: str, salt: str) -> Sheet:
    """A sheet before it is laid out."""
    return Sheet(sheet=sheet_id(assignment, salt, student.number), student=student, parts=tuple(parts))


def cut(items: Sequence[Any], size: int) -> Iterator[Sequence[Any]]:
    """Pieces of so many."""
    for start in range(0, len(items), size):
        yield items[start : start + size]


def laid_out(sheets: Sequence[Sheet], layouts: Mapping[str, Any]) -> tuple[Sheet, ...]:
    """The sheets with their layouts, those without one left out."""
    from ..register import layout_from

    done = []
    for sheet in sheets:
        if sheet.student.number in layouts:
            layout = layout_from(layouts[sheet.student.number])
            done.append(replace(sheet, layout=layout, layout_hash=layout.hash))
    return tuple(done)
