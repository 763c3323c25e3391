"""vecpoly play: the construction step by step in a browser, as one HTML file that loads nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .draw import Id
from .errors import Tally, about
from .files import write_text
from .jobs import problems
from .options import HandOption, LangOption, OutOption, SeedOption
from .terminal import say

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
    (problem,) = problems([name])
    from ..player.page import player
    from ..solution import solve

    tally = Tally()
    with about(problem.id):
        page = player(solve(problem, by=hand, seed=seed, repeats=0), lang=lang, places=places, seed=seed)
    path = output or Path(f"{problem.id}.html")
    if path.is_dir():
        path = path / f"{problem.id}.html"
    say(f"wrote {write_text(path, page.html)}")
    tally.weigh(problem.id, page.warning, lang)
    tally.settle()
