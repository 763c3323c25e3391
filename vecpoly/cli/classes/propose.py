"""vecpoly variants --propose: ranges for problems that have none, and an assignment with them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from ...words import Words
from ..errors import Tally, about
from ..files import STDOUT, put, spared
from ..terminal import say
from ..tongue import told_in

if TYPE_CHECKING:
    from ...problem.problem import Problem
    from ...variants.proposing.chosen import Proposal
    from ...words import Lang


def propose(problems: list[Problem], students: int, output: Path | None, lang: Lang, tally: Tally) -> None:
    """Find ranges for each, tell what they give; and write the assignment, or its entries to standard output."""
    from ...variants.proposing.assignment import assignment, entry, lies_outside
    from ...variants.proposing.chosen import proposal

    spared(output, (".yaml", ".yml"), problems)
    found: list[tuple[Problem, Proposal]] = []
    for problem in problems:
        with tally.job(), about(problem):
            found.append((problem, proposal(problem, students)))
            _tell(*found[-1], lang)
    if not found:
        return
    if output is None:
        for one in found:
            typer.echo("\n".join(entry(*one)))
        return
    name = "hw" if output == STDOUT else output.stem
    put(output, assignment(name, found, output.parent).encode())
    if output != STDOUT:
        outside = any(lies_outside(problem, output.parent) for problem, _ in found)
        command = f"vecpoly class {output} --roster 名单.xlsx -o {name}/" + " --allow-outside" * outside
        say(told_in(Words(f"可接着运行：{command}", f"now try: {command}")))


def _tell(problem: Problem, found: Proposal, lang: Lang) -> None:
    from ...variants.told import demoted, told

    for line in (*told(problem.id, found.pilot), *demoted(found.pilot)):
        typer.echo(f"# {line.of(lang)}", err=True)
