"""vecpoly play: the construction step by step in a browser, as one HTML file that loads nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ..errors import UnknownNameError
from ..words import Words
from .draw import Id
from .errors import Tally, about
from .files import write_text
from .jobs import each, problems
from .options import HandOption, LangOption, OutOption, SeedOption
from .terminal import wrote

ENDINGS = (".html", ".htm")
Places = Annotated[int, typer.Option("--places", min=0, max=360, help="Places of the crank over its turn; 0 leaves its slider away.")]


def play(
    name: Id,
    output: OutOption = None,
    lang: LangOption = "zh",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    places: Places = 72,
) -> None:
    """Write a step player: one HTML file for class, phone or desktop, in both languages.

    It shows the construction line by line with the sentence of each step beside it, and the finished figures for every place of the crank.
    """
    tally = Tally()
    found = problems([name], tally)
    from ..player.page import player
    from ..solution import solve

    for problem in found:
        path = _place(output, problem.id, len(found))
        with tally.job(), about(problem.id):
            page = player(solve(problem, by=hand, seed=seed, repeats=0), lang=lang, places=places, seed=seed)
            wrote(write_text(path, page.html))
            tally.weigh(problem.id, page.warning, lang)
    tally.settle()


def _place(output: Path | None, name: str, count: int) -> Path:
    """The file of a problem's player: the one named, or one in the folder named; refuses endings that are no web page."""
    if output is None or output.is_dir() or not output.suffix[1:2].isalpha():
        return (output or Path()) / f"{name}.html"
    if output.suffix.lower() not in ENDINGS:
        raise UnknownNameError(Words(
            f"{output}：演示是网页；请用 .html 结尾的文件名，或已有的文件夹",
            f"{output}: a player is a web page; end the file's name with .html, or name a folder that exists"))
    return each(output, name, count)
