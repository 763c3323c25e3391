"""vecpoly demo: the exercises of chapters 2 to 5 (structure, kinematics, forces, efficiency), an assignment a chapter,
a course report and a step player."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ...words import Words
from ..files import put
from ..jobs import job
from ..options import Lang, place
from ..terminal import progress
from .play import play
from .report import document, draw, report

ASSIGNMENTS = ("assignment-ch2", "assignment-ch3", "assignment-ch4", "assignment-ch5")
COURSE, PLAYED = "A-27", "3-9"
LANGS: tuple[Lang, ...] = ("zh", "en")
Folder = Annotated[Path, typer.Option("-o", "--output", parser=place, help="The folder to write to.")]


def demo(output: Folder = Path("out")) -> None:
    """Render chapters 2 to 5 as assignments and one course report, in both languages, and one step player."""
    from ...foundation.data import data_dir

    for name in ASSIGNMENTS:
        sheet = job(str(data_dir("problems") / f"{name}.yaml"))
        solutions = draw(progress(sheet.problems, Words(f"作图 {name}", f"drawing {name}")), "drafting", 0)
        for lang in LANGS:
            put(output / f"{name}.{lang}.pdf", document(sheet, solutions, lang, "solution"))
    for lang in LANGS:
        report([COURSE], output / f"course-{COURSE}.{lang}.pdf", lang, "course")
    play(PLAYED, output / f"play-{PLAYED}.html")
