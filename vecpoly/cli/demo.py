"""vecpoly demo: the velocity and acceleration exercises of chapter 3 as one assignment, in both languages."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .jobs import job
from .options import Lang
from .report import draw, write
from .terminal import progress, say

ASSIGNMENT = "assignment-ch3"
LANGS: tuple[Lang, ...] = ("zh", "en")
Folder = Annotated[Path, typer.Option("-o", "--output", help="The folder to write to.")]


def demo(output: Folder = Path("out")) -> None:
    """Render chapter 3 as an assignment, in both languages."""
    from ..data import data_dir

    sheet = job(str(data_dir("problems") / f"{ASSIGNMENT}.yaml"))
    solutions = draw(progress(sheet.problems, "drawing"), "drafting", 0)
    for lang in progress(LANGS, "writing"):
        say(f"wrote {write(sheet, solutions, output / f'{ASSIGNMENT}.{lang}.pdf', lang, 'solution')}")
