"""vecpoly report: one PDF for a problem, an assignment, or each of many files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import NoMethodError, VecpolyError
from ...foundation.files import is_special
from ...foundation.running.spread import spread
from ...foundation.slotted import dataclass, replace
from ...words import Words
from ..errors import Tally, about
from ..files import STDOUT, put, spared
from ..jobs import Job, jobs
from ..letters import warn_of_letters
from ..onward import Then, ThenOption, onward
from ..options import (
    Documents,
    Hand,
    HandOption,
    JobsOption,
    Lang,
    LangOption,
    OutOption,
    OutsideOption,
    PaperOption,
    PlainOption,
    SeedOption,
    Style,
    StyleOption,
)
from ..terminal import progress, warn

if TYPE_CHECKING:
    from ...problem.problem import Problem
    from ...solution import Solution


PDF = (".pdf",)


def report(
    names: Documents,
    output: OutOption = None,
    lang: LangOption = "zh",
    style: StyleOption = "solution",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    processes: JobsOption = 1,
    plain: PlainOption = False,
    paper: PaperOption = None,
    allow_outside: OutsideOption = False,
    then: ThenOption = None,
) -> None:
    """Write reports as PDF.

    With -o FILE.pdf everything goes into this one file; with -o FOLDER, every problem or assignment gets a file there.
    Without -o the files are written here.
    """
    tally = Tally()
    found = [job.on(paper) for job in jobs(names, tally, allow_outside)]
    if then is not None:
        found = [_gone_on(job, then, tally, lang, style, hand, seed) for job in found]
        found = [job for job in found if job.problems]
    plan = _plan(found, output, lang, style)
    orders = [_Order(job, lang, style, hand, seed, plain, alone=len(plan) == 1) for job, _ in plan]
    waiting = spread(_drawn_up, orders, processes or os.cpu_count() or 1)
    for (_, path), made in zip(progress(plan, Words("写入", "writing")), waiting, strict=True):
        with tally.job():
            drawn_up = made()
            put(path, drawn_up.pdf)
            for name, warnings, alarm, conclusion in drawn_up.notes:
                warn(name, warnings, lang)
                tally.weigh(name, alarm, lang, conclusion)
    tally.settle()


def _gone_on(job: Job, then: Then, tally: Tally, lang: Lang, style: Style, hand: Hand, seed: int) -> Job:
    """The document of the linkages that were found; in a solution each stands behind its synthesis."""
    made = tuple(
        one
        for problem in job.problems
        for one in (*([problem] if style == "solution" else []), *onward([problem], then, tally, lang, hand, seed))
    )
    return replace(job, name=made[-1].id if made and job.path is None else job.name, problems=made)


@dataclass(frozen=True, slots=True)
class _Order:
    """A document to be made; alone: the only one, so that its problems are told as they are drawn."""

    job: Job
    lang: Lang
    style: Style
    hand: Hand
    seed: int
    plain: bool
    alone: bool


@dataclass(frozen=True, slots=True)
class _DrawnUp:
    """A document, and of each of its problems the id, what is to be noted, the alarm, and that it has no solution."""

    pdf: bytes
    notes: tuple[tuple[str, tuple[Words, ...], Words | None, Words | None], ...]


def _drawn_up(order: _Order) -> _DrawnUp:
    """Solve the problems of a document and set it: by this process, or by another."""
    job = order.job
    inner = progress(job.problems, Words("作图", "drawing")) if order.alone else iter(job.problems)
    solutions = draw(inner, order.hand, order.seed, order.style)
    pdf = document(job, solutions, order.lang, order.style, order.plain)
    drawn = ((one.problem.id, tuple(one.warnings), one.construction) for one in solutions)
    notes = ((name, warnings, made.warning, made.conclusion) for name, warnings, made in drawn)
    return _DrawnUp(pdf, tuple(notes))


def draw(problems: Iterable[Problem], hand: Hand, seed: int, style: Style = "solution") -> list[Solution]:
    """Solve these problems by one hand; a course report also goes without drawings where no method draws them."""
    from ...solution import solve

    solutions = []
    for problem in problems:
        with about(problem):
            try:
                solutions.append(solve(problem, by=hand, seed=seed))
            except NoMethodError as error:
                if style != "course":
                    raise
                from ...report.course.structure.undrawn import undrawn

                solutions.append(undrawn(problem, error, by=hand))
    return solutions


def document(job: Job, solutions: Sequence[Solution], lang: Lang, style: Style, plain: bool = False) -> bytes:
    """The document of a job as a PDF."""
    from ...report.document import report_bytes

    block = labelled(job.fields or {}, lang)
    warn_of_letters(job.problems, lang, (*block.values(), job.title.of(lang) if job.title else ""))
    return report_bytes(solutions, lang=lang, style=style, fields=block, title=job.title, plain=plain)


def labelled(block: Mapping[str, str], lang: Lang) -> dict[str, str]:
    """The title block of an assignment under the labels of the report's language."""
    from ...problem.assignment import FIELDS
    from ...report.document import FIELDS as LABELS

    label = dict(zip(LABELS["zh"], LABELS[lang], strict=True))
    return {label[FIELDS[key]]: value for key, value in block.items() if FIELDS[key] in label}


def _plan(found: Sequence[Job], output: Path | None, lang: Lang, style: Style) -> list[tuple[Job, Path]]:
    """Which document goes where: all into one file, or into the standard output, or each into a folder."""
    files = [file for job in found for file in job.files]
    if output is not None and (
        output == STDOUT or is_special(output) or (output.suffix[1:2].isalpha() and not output.is_dir())
    ):
        spared(output, PDF, more=files)
        return [(found[0] if len(found) == 1 else _joined(found), output)]
    ending = f".{lang}.pdf" if style == "solution" else f".{style}.{lang}.pdf"
    plan: dict[Path, Job] = {}
    for job in found:
        path = (output or Path()) / f"{job.name}{ending}"
        if path in plan:
            raise VecpolyError(
                Words(
                    f"有两份文档都要写入 {path}；请更改其中一题的 id",
                    f"two of the documents would be written to {path}; change the id of one of the problems",
                )
            )
        spared(path, PDF, more=files)
        plan[path] = job
    return [(job, path) for path, job in plan.items()]


def _joined(found: Sequence[Job]) -> Job:
    """All in one document; title block and title are those of the first assignment among them."""
    first = next((job for job in found if job.fields is not None), found[0])
    everything = tuple(problem for job in found for problem in job.problems)
    return Job(name=first.name, problems=everything, title=first.title, fields=first.fields)
