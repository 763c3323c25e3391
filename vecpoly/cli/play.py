"""vecpoly play: the construction step by step in a browser, as one HTML file that loads nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .draw import Id
from .errors import about
from .files import put, spared
from .jobs import problems
from .options import HandOption, LangOption, OutOption, OutsideOption, SeedOption
from .terminal import warn

HTML = (".html", ".htm")
Places = Annotated[int, typer.Option("--places", min=0, max=360, help="Places of the crank over its turn; 0 leaves its slider away.")]


def play(
    name: Id,
    output: OutOption = None,
    lang: LangOption = "zh",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    places: Places = 72,
    allow_outside: OutsideOption = False,
) -> None:
    """Write a step player: one HTML file for class, phone or desktop, in both languages.

    It shows the construction line by line with the sentence of each step beside it, and the finished figures for every place of the crank.
    """
    (problem,) = problems([name], allow_outside)
    path = output or Path(f"{problem.id}.html")
    path = spared(path / f"{problem.id}.html" if path.is_dir() else path, HTML, [problem]) or path
    from ..player.page import player_html
    from ..solution import solve

    with about(problem.id):
        solution = solve(problem, by=hand, seed=seed, repeats=0)
        page = player_html(solution, lang=lang, places=places, seed=seed)
    warn(problem.id, solution.warnings, lang)
    put(path, page.encode())
