"""vecpoly grade: the answers of a class, marked with reasons."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...errors import ArgumentError, VecpolyError
from ...words import Lang, Words, many
from ..errors import REFUSED, tell
from ..options import JobsOption, place
from ..terminal import say, wrote
from ..tongue import told_in
from .classes import progress_bar

if TYPE_CHECKING:
    from ...marked.graded import Graded

KEY = "key.xlsx"
Class = Annotated[
    Path, typer.Argument(metavar="FOLDER", help="The folder that 'vecpoly class' wrote.", show_default=False)
]
Files = Annotated[
    list[Path], typer.Argument(metavar="ANSWERS...", help="Answers: the form, CSV, YAML or JSON.", show_default=False)
]
OutOption = Annotated[
    Path,
    typer.Option("-o", "--output", metavar="FOLDER", parser=place, help="The folder to write to.", show_default=False),
]
RulesOption = Annotated[
    Path | None, typer.Option("--rules", metavar="FILE", help="Rules and points, as YAML.", show_default=False)
]
DiffOption = Annotated[
    Path | None,
    typer.Option("--diff", metavar="FOLDER", help="Tell what is marked otherwise than there.", show_default=False),
]
DrawingsOption = Annotated[
    Path | None,
    typer.Option(
        "--drawings",
        metavar="FOLDER",
        help="Drawings (DXF, SVG, PDF, GGB) named NUMBER_PROBLEM, graded vector by vector.",
        show_default=False,
    ),
]
ClassLang = Annotated[
    Lang | None,
    typer.Option(
        "--lang", envvar="VECPOLY_LANG", help="Chinese or English; that of the class where nothing is said.",
        show_default=False,
    ),
]  # fmt: skip
FeedbackOption = Annotated[bool, typer.Option("--feedback/--no-feedback", help="Write a feedback sheet for everybody.")]


def grade(
    folder: Class,
    answers: Files,
    output: OutOption,
    rules: RulesOption = None,
    diff: DiffOption = None,
    drawings: DrawingsOption = None,
    feedback: FeedbackOption = True,
    lang: ClassLang = None,
    jobs: JobsOption = 0,
) -> None:
    """Mark the answers of a class: grades, a feedback sheet for everybody, item analysis, a queue for a person.

    Right within what a drawing may be off by, or right by one's own earlier values; each mistake costs once, and is
    named where one slip alone explains it. Marked again, the same answers have the same marks; --diff tells what
    changed.

    Exit code: 0 all was read (what waits for a person is counted, and stands in queue.csv), 2 a file, a row or a
    drawing could not be read (the rest is marked all the same).
    """
    from ...batch.register import read_register
    from ...marked.graded import Order
    from ...marked.graded import grade as graded
    from ...marked.scheme import read_scheme

    register = read_register(folder)
    _no_key(folder, answers)
    order = Order(
        register=register, files=tuple(answers), out=output, scheme=read_scheme(rules, register),
        lang=lang or ("zh" if register.lang == "zh" else "en"),
        jobs=jobs or os.cpu_count() or 1, feedback=feedback, before=diff, drawings=drawings,
    )  # fmt: skip
    with progress_bar() as told:
        done = graded(order, told)
    _report(done, output)
    errors = [VecpolyError(fault.words, code=fault.code, faults=(fault,)) for fault in done.faults]
    for error in errors:
        tell(error)
    if errors:
        raise typer.Exit(REFUSED)


def _no_key(folder: Path, answers: list[Path]) -> None:
    """Raise ArgumentError where the key of the class is handed in for its answers: everybody would have all points."""
    key = folder / KEY
    if any(one.exists() and key.exists() and one.samefile(key) for one in answers):
        raise ArgumentError(
            Words(
                f"{key} 是这次作业的标准答案，不是学生的作答；请给出填好的 answers.xlsx",
                f"{key} is the key of this class, not its answers; name the answers.xlsx that was filled in",
            )
        )


def _report(done: Graded, output: Path) -> None:
    for path in done.files:
        if path.parent == output:
            wrote(path)
    count = len(done.results)
    missing = sum(not (one.returned or one.aside) for one in done.results)
    waiting = sum(one.waiting for one in done.results)
    say(
        told_in(
            Words(
                f"{count} 人，{missing} 人没有交，{waiting} 处待人工批改",
                f"{many(count, 'students')}, {missing} returned nothing, {many(waiting, 'answers or rows')} "
                f"{'waits' if waiting == 1 else 'wait'} for a person",
            )
        )
    )
    if done.changed is not None:
        changed = len(done.changed)
        are = "is" if changed == 1 else "are"
        say(told_in(Words(f"与前次相比有 {changed} 处不同", f"{many(changed, 'answers')} {are} marked otherwise")))
