"""A cam that is designed, all through its inversion: the follower walks round the standing cam, station by station."""

from __future__ import annotations

from dataclasses import dataclass

from ..answer import Answer
from ..board.construction import Figure
from ..foundation.slotted import replace
from ..problem.asked.asks import AskNamed
from ..problem.problem import Problem
from ..solution import Solution, solve

READ = ("s", "psi", "r", "alpha")  # what is told at a station, as keys of a cam: s_45
SYMBOLS = {"s": "s", "psi": "ψ", "r": "r", "alpha": "α"}


@dataclass(frozen=True, slots=True)
class Turned:
    """The solution with the drive at another place, and what the drive's datum reads there: 75°, 120 mm."""

    shown: str
    solution: Solution


def inverted(solution: Solution) -> tuple[Turned, ...]:
    """The stations of a cam, each with its figure and what was read there; nothing for anything else."""
    from ..methods.devices.cam.walk import stations_walked, walked  # late: no other subject needs the cams

    stations = stations_walked(solution.problem)
    if not stations:
        return ()
    whole = solve(_all(solution.problem), by=solution.construction.hand, repeats=0, precise=False)
    figures = walked(solution.problem)
    return tuple(_at(whole, figure, phi) for figure, phi in zip(figures, stations, strict=True) if phi)


def _all(problem: Problem) -> Problem:
    """The problem with everything asked that there is."""
    return replace(problem, asks=tuple(AskNamed(rel=named) for named in problem.device.quantities()))


def _at(whole: Solution, figure: Figure, phi: float) -> Turned:
    """One station: its figure, and its own answers by short names."""
    found = {stem: whole.answers.get(f"{stem}_{phi:g}") for stem in READ}
    answers = {stem: _called(answer, stem) for stem, answer in found.items() if answer is not None}
    return Turned(
        f"{phi:g}°", replace(whole, construction=replace(whole.construction, figures=(figure,)), answers=answers)
    )


def _called(answer: Answer, stem: str) -> Answer:
    return replace(answer, reading=replace(answer.reading, symbol=SYMBOLS[stem]))
