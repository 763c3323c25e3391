"""--then analyse: from a synthesis on to the linkage that it found, which is a problem of its own."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from .errors import Tally, about
from .options import Hand, Lang

if TYPE_CHECKING:
    from ..problem.problem import Problem

Then = Literal["analyse"]
ThenOption = Annotated[
    Then | None,
    typer.Option("--then", metavar="analyse", help="Of a synthesis: go on with the linkage that was found, analyse."),
]


def onward(
    found: Iterable[Problem], then: Then | None, tally: Tally, lang: Lang, hand: Hand = "drafting", seed: int = 0
) -> list[Problem]:
    """The problems as they are; where one goes on, the linkage that each of them found, drawn by this hand.

    What is no synthesis, or found nothing, is refused; an alarm of the synthesis is one of what goes on from it.
    """
    if then is None:
        return list(found)
    from ..solution import solve

    linkages: list[Problem] = []
    for problem in found:
        with tally.job(), about(problem):
            solution = solve(problem, by=hand, seed=seed, repeats=0)
            linkages.append(solution.linkage)
            tally.weigh(problem.id, solution.construction.warning, lang)
    return linkages
