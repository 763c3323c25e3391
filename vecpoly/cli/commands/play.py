"""vecpoly play: the construction step by step in a browser, as one HTML file that loads nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ...foundation.files import is_special
from ..errors import Tally, about
from ..files import STDOUT, put, spared
from ..jobs import each, problems
from ..onward import ThenOption, onward
from ..options import HandOption, LangOption, OutOption, OutsideOption, PlainOption, SeedOption
from ..terminal import warn
from .draw import Id

ENDINGS = (".html", ".htm")
Places = Annotated[
    int, typer.Option("--places", min=0, max=360, help="Places of the crank over its turn; 0 leaves its slider away.")
]

Check = Annotated[
    bool, typer.Option("--check", help="With a box for one's own answers: right, close, or wrong and why.")
]


def play(
    name: Id,
    output: OutOption = None,
    lang: LangOption = "zh",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    places: Places = 36,
    check: Check = False,
    plain: PlainOption = False,
    allow_outside: OutsideOption = False,
    then: ThenOption = None,
) -> None:
    """Write a step player: one HTML file for class, phone or desktop, in both languages.

    It shows the construction line by line with the sentence of each step beside it,
    and the finished figures for every place of the crank.
    """
    tally = Tally()
    found = onward(problems([name], tally, allow_outside), then, tally, lang, hand, seed)
    from ...player.page import player
    from ...solution import solve

    for problem in found:
        path = _place(output, problem.id, len(found))
        spared(path, ENDINGS, found)
        with tally.job(), about(problem):
            solution = solve(problem, by=hand, seed=seed, repeats=0)
            solution = solution.toned({}) if plain else solution
            page = player(solution, lang=lang, places=places, seed=seed, check=check)
            put(path, page.html.encode())
            warn(problem.id, solution.warnings, lang)
            tally.weigh(problem.id, page.warning, lang, solution.construction.conclusion)
    tally.settle()


def _place(output: Path | None, name: str, count: int) -> Path:
    """The file of a problem's player: the one named, or one in the folder named."""
    if output is not None and (output == STDOUT or is_special(output)):
        return output
    if output is None or output.is_dir() or not output.suffix[1:2].isalpha():
        return (output or Path()) / f"{name}.html"
    return each(output, name, count)
