"""vecpoly variants: what becomes of `vary` and `gate`: yield, what is demoted, some variants."""

from __future__ import annotations

from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...errors import ArgumentError
from ...limits import ROSTER
from ...words import Words
from ..completion import ids
from ..errors import Tally, about
from ..jobs import jobs
from ..options import LangOption, OutsideOption, place
from .propose import propose as proposed

if TYPE_CHECKING:
    from ...problem.problem import Problem
    from ...variants.pilot import Pilot
    from ...words import Lang

Names = Annotated[
    list[str],
    typer.Argument(
        metavar="ID_OR_FILE...", help="Problems or assignments with `vary`.", show_default=False, autocompletion=ids
    ),
]
Count = Annotated[int, typer.Option("--count", "-n", min=0, max=1000, help="How many variants to draw.")]
ProposeOption = Annotated[
    bool, typer.Option("--propose", help="Find ranges for problems that have none: an assignment to start from.")
]
Students = Annotated[
    int, typer.Option("--students", min=1, max=ROSTER, help="How many students the proposed ranges shall tell apart.")
]
Assigned = Annotated[
    Path | None,
    typer.Option(
        "-o", "--output", metavar="FILE", parser=place, help="The assignment to write, YAML.", show_default=False
    ),
]
Salt = Annotated[str, typer.Option("--salt", metavar="TEXT", help="Another text gives other numbers.")]


def variants(
    names: Names,
    count: Count = 5,
    salt: Salt = "",
    propose: ProposeOption = False,
    students: Students = 60,
    output: Assigned = None,
    lang: LangOption = "en",
    allow_outside: OutsideOption = False,
) -> None:
    """Try what `vary` and `gate` of a problem give: how many draws pass, what fails, what is demoted, and some
    variants.

    With --propose, ranges are found for problems that have none: numbers that the text does not tell, in round steps,
    as many of them as a class needs. -o HW.yaml writes the assignment for 'vecpoly class'.
    """
    if output is not None and not propose:
        raise ArgumentError(
            Words("-o 写出的是 --propose 得到的作业；请加上 --propose", "-o writes what --propose finds; add --propose")
        )
    tally = Tally()
    found = jobs(names, tally, allow_outside)
    if propose:
        proposed([problem for job in found for problem in job.problems], students, output, lang, tally)
    for job in () if propose else found:
        for problem in job.problems:
            with tally.job(), about(problem):
                _tell(problem, Path(job.name).stem, count, salt, lang)
    tally.settle()


def _tell(problem: Problem, assignment: str, count: int, salt: str, lang: Lang) -> None:
    from ...variants.draw import variants as drawn
    from ...variants.pilot import pilot
    from ...variants.seeds import Seed
    from ...variants.told import asks_otherwise, demoted, said_already, told

    for line in asks_otherwise(problem):
        typer.echo(line.of(lang))
    if not problem.ranges:
        typer.echo(
            Words(
                f"{problem.id}：没有 vary，所有学生的数据相同；--propose 可给出取值范围",
                f"{problem.id}: no vary, the same numbers for everybody; --propose finds ranges",
            ).of(lang)
        )
        return
    first: Pilot = pilot(problem)
    for line in (*told(problem.id, first), *demoted(first), *said_already(problem)):
        typer.echo(line.of(lang))
    for number in range(1, count + 1):
        seed = Seed(assignment=assignment, problem=problem.id, student=f"{number}", salt=salt)
        for one in islice(drawn(problem, seed, first.standard), 1):
            typer.echo(f"  {number}: " + ", ".join(f"{name} = {_degrees(value)}" for name, value in one.values.items()))


def _degrees(value: str) -> str:
    """A value of a problem file as it is printed: 55 deg is 55°."""
    return value.replace(" deg", "°")
