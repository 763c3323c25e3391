"""Everything that is written once all sheets are there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from ..foundation.files import write_whole
from ..words import Words
from .bundles import merged, zipped
from .forms.profile import Profile, table_bytes
from .forms.workbooks import answers_bytes, key_bytes
from .moodle.quiz import Quizzes
from .register import NAME, Register
from .run.store import Store, bytes_digest, file_digest
from .run.tasks import question_file, solution_file

Told = Callable[[Words, int, int], None]
FORM, BESIDE = "answers.xlsx", "answers.new.xlsx"
_FORMS = "forms"  # where the digests of the blank forms are kept that were written so far


def outputs(register: Register, out: Path, profile: Profile | None, told: Told) -> Iterator[Path]:
    """Write the forms and bundles, and name each file when it is there."""
    quizzes = Quizzes(register)
    plan: list[tuple[str, Callable[[], bytes]]] = [
        ("key.xlsx", lambda: key_bytes(register)),
        ("moodle-cloze.xml", quizzes.cloze),
        ("moodle-numerical.xml", quizzes.numerical),
        ("questions.pdf", lambda: merged(register, out)),
        ("solutions.pdf", lambda: merged(register, out, solutions=True)),
        ("questions.zip", lambda: zipped([out / question_file(sheet.student) for sheet in register.sheets], out)),
    ]
    if profile is not None:
        plan.append((profile.file, lambda: table_bytes(register, profile)))
    doing = Words("汇总", "bundling")
    yield _form(answers_bytes(register), out)
    for count, (name, made) in enumerate(plan):
        told(doing, count, len(plan))
        yield write_whole(out / name, made())
    told(doing, len(plan), len(plan))
    yield out / NAME


def _form(blank: bytes, out: Path) -> Path:
    """Write the blank form for answers; where somebody has typed into the one that lies there, beside it."""
    form, store, mine = out / FORM, Store(out), bytes_digest(blank)
    known = dict.fromkeys([*(store.get(_FORMS) or ()), mine])
    typed = form.exists() and file_digest(form) not in known
    store.put(_FORMS, list(known), {})
    return write_whole(out / BESIDE if typed else form, blank)


def left_over(register: Register, out: Path) -> tuple[Path, ...]:
    """Sheets in the folder that are nobody's on the register: of who left, or under a name that was corrected."""
    theirs = {
        out / file for sheet in register.sheets for file in (question_file(sheet.student), solution_file(sheet.student))
    }
    there = (path for folder in ("questions", "solutions") for path in sorted((out / folder).glob("*.pdf")))
    return tuple(path for path in there if path not in theirs)
