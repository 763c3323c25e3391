"""From an assignment and a roster to a folder of sheets, register, key and forms."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..errors import VecpolyError
from ..foundation.files import write_whole
from ..foundation.slotted import replace
from ..grading.scheme import USUAL_SCHEME, Scheme, scheme_of
from ..problem.assignment import Assignment
from ..problem.problem import Problem
from ..problem.schema.marking import MarkingSpec
from ..problem.values.vary import data_of
from ..variants.keyed import key_for
from ..variants.pilot import Pilot, pilot
from ..variants.seeds import Seed
from ..words import Lang, Words
from .drawing import Course, drawn, fingerprint, refuse_other_paper, refuse_too_few
from .handed_out import handed_out, kept, unchanged
from .printing import printed
from .register import NAME, Exercise, Part, Register
from .run.manifest import roster_digest, write_manifest
from .run.runners import Runner
from .run.tasks import bare, laid_out
from .student import Student
from .unvaried import same_for_all

_LEFT_OUT = ("printed", "errata", "tables", "extends")
Told = Callable[[Words, int, int], None]
Held = Callable[[Register], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Made:
    """What was made: the register; pilots by problem; who got no sheet, and why."""

    register: Register
    pilots: dict[str, Pilot]
    refused: dict[str, VecpolyError]


@dataclass(frozen=True, slots=True, kw_only=True)
class Order:
    """What is to be made, where, in which language; version: of the program, which the pages follow from."""

    assignment: Assignment
    students: tuple[Student, ...]
    out: Path
    lang: Lang
    version: str

    def seed(self, problem: str, student: str) -> Seed:
        """The seed of a student's values."""
        return Seed(assignment=self.assignment.id, problem=problem, student=student, salt=self.assignment.salt)


def make_class(
    order: Order,
    run: Runner,
    told: Told,
    shard: tuple[int, int] | None = None,
    *,
    pieces: int = 1,
    held: Held | None = None,
) -> Made:
    """Draw the values of all, write the sheets of all, and keep the register; or write one of so many shards, and keep
    what it made in a manifest. pieces: the shards whose sheets are there already. held: raises VecpolyError where the
    register is not what it must be, before it is kept.

    Raises VecpolyError where a problem gives too few variants; a student who cannot be served does not stop the others.
    """
    old, scheme = handed_out(order.out, order.assignment), _scheme(order.assignment)
    pilots, courses, exercises = {}, dict[str, Course](), list[Exercise]()
    for problem in map(_bare, order.assignment.problems):
        found = _pilot(problem)
        pilots[problem.id] = found
        if problem.ranges:
            refuse_too_few(problem, found, len(order.students))
        exercises.append(unchanged(_exercise(order, problem, found), old, order.out))
        courses[problem.id] = Course(problem=problem, fingerprint=exercises[-1].fingerprint, standard=found.standard)
    parts, refused = _drawn(order, courses, old, run, told, 0.0 if shard is None else shard[0] / shard[1])
    served = [one for one in order.students if one.number not in refused]
    register = _register(order, exercises, {one: [parts[name][one.number] for name in courses] for one in served})
    _no_twin_sheets(register)
    shares = [shard] if shard is not None else [(n, pieces) for n in range(pieces)]
    sheets_of = [register.sheets[n::of] for n, of in shares]
    layouts, failed = printed(register, order.out, run, told, sheets_of)
    done = replace(register, sheets=laid_out(register.sheets, layouts)).marked_by(scheme)
    if held is not None:
        held(done)
    if shard is None:
        write_whole(order.out / NAME, done.as_bytes())
    else:
        _note(order, done, shard, refused, failed)
    return Made(register=done, pilots=pilots, refused=refused | failed)


def _register(order: Order, exercises: Sequence[Exercise], parts: Mapping[Student, Sequence[Part]]) -> Register:
    """The register, of which no page is laid out yet."""
    of = order.assignment
    served = sorted(parts, key=lambda one: one.number)
    return Register(
        assignment=of.id,
        salt=of.salt,
        title=of.title,
        lang=order.lang,
        vecpoly=order.version,
        exercises=tuple(exercises),
        sheets=tuple(bare(one, parts[one], of.id, of.salt) for one in served),
    )


def _note(
    order: Order,
    done: Register,
    shard: tuple[int, int],
    refused: Mapping[str, VecpolyError],
    failed: Mapping[str, VecpolyError],
) -> None:
    """Write what this shard made, and who of its share got nothing."""
    mine = {number: error for number, error in refused.items() if _falls_to(number, order, shard)}
    write_manifest(order.out, done, roster_digest(order.students), shard, {**mine, **failed})


def _falls_to(number: str, order: Order, shard: tuple[int, int]) -> bool:
    """Whether it is this shard that tells of a student who got no values."""
    numbers = sorted(one.number for one in order.students)
    return numbers.index(number) % shard[1] == shard[0]


def _scheme(assignment: Assignment) -> Scheme:
    """How the class is marked; where points or rules name what there is not, this is told before anything is drawn."""
    from ..grading.derive.keyed import answer_key

    said = assignment.marking.said
    if said == MarkingSpec():
        return USUAL_SCHEME
    everywhere = bool(said.rules.independent or said.rules.first)
    asked = [one for one in assignment.problems if everywhere or one.id in {*said.points, *said.totals}]
    return scheme_of(assignment.marking, {one.id: answer_key(one) for one in asked})


def _bare(problem: Problem) -> Problem:
    """Without what was printed of the problem in a book, which is of other values."""
    return replace(problem, printed=(), errata=(), tables=(), source=None)


def _pilot(problem: Problem) -> Pilot:
    refuse_other_paper(problem)
    if not problem.ranges:
        return same_for_all(problem)
    return pilot(problem)


def _exercise(order: Order, problem: Problem, found: Pilot) -> Exercise:
    data = {key: value for key, value in data_of(problem).items() if key not in _LEFT_OUT}
    failed = {str(condition): round(share, 6) for condition, share in sorted(found.failed.items())}
    return Exercise(
        id=problem.id,
        data=data,
        fingerprint=fingerprint(data, order.version),
        demoted=tuple(sorted(found.standard.demoted)),
        passed=round(found.passed, 6),
        failed=failed,
    )


def _drawn(
    order: Order, courses: dict[str, Course], old: Register | None, run: Runner, told: Told, begin: float
) -> tuple[dict[str, dict[str, Part]], dict[str, VecpolyError]]:
    parts: dict[str, dict[str, Part]] = {}
    refused: dict[str, VecpolyError] = {}
    for name, course in courses.items():
        if not course.problem.ranges:
            same = _same(course)
            parts[name] = {one.number: same for one in order.students}
            continue
        seeds = [order.seed(name, one.number) for one in order.students]
        parts[name], without = drawn(
            course,
            seeds,
            kept(old, name),
            run,
            order.out,
            lambda what, done, of: told(Words(f"取数 {what}", f"drawing values of {what}"), done, of),
            begin,
        )
        refused |= without
    return parts, refused


def _same(course: Course) -> Part:
    """The one variant of a problem without ranges."""
    from ..grading.derive.keyed import answer_key
    from ..variants.frames import scaled
    from ..variants.look import sketch_of

    problem = scaled(course.problem, sketch_of(course.problem)) or course.problem
    return Part(
        problem=problem.id,
        attempt=0,
        values={},
        scales=dict(problem.scales.given),
        key=key_for(answer_key(problem), course.standard),
    )


def _no_twin_sheets(register: Register) -> None:
    """Raise where two students' numbers have one sheet id, which happens to one class of 300 in 24 million."""
    seen: dict[str, str] = {}
    for sheet in register.sheets:
        other = seen.setdefault(sheet.sheet, sheet.student.number)
        if other != sheet.student.number:
            raise VecpolyError(
                Words(
                    f"学号 {other} 与 {sheet.student.number} 得到同一卷号 {sheet.sheet}；请在作业中写 salt: 另一文本",
                    f"the numbers {other} and {sheet.student.number} give one sheet id {sheet.sheet}; write "
                    f"another salt in the assignment",
                ),
                code="twin",
            )
