"""Sheets of a ten-bar and of chains of four-bars, how they grow, and the plan of thirty dyads:
ratios to laying out the same marks without letters."""

from __future__ import annotations

from math import log

from vecpoly.board.construction import Construction
from vecpoly.drawing.figure import drawn_anew, unique
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.drawing.symbols.around import Surroundings
from vecpoly.drawing.symbols.marks import draw
from vecpoly.mechanism.groups import assur
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

from .chain import chain
from .timing import best


def run() -> str:
    """One line of the report."""
    ten, short, long = (_sheets(problem) for problem in (load("A-30"), chain(5), chain(15)))
    thirty = chain(30).mechanism
    (plan,) = best(lambda: _planned(thirty), runs=5)
    growth = log(long[0] / short[0]) / log(3)
    return (
        f"sheets: A-30 {ten[0] * 1e3:.0f} ms = {ten[0] / ten[1]:.0f} × its lines without letters, 15 dyads "
        f"{long[0] * 1e3:.0f} ms = {long[0] / long[1]:.0f} ×; from 5 to 15 dyads as n^{growth:.2f} (aim ≤ 1.6); "
        f"plan of 30 dyads {plan * 1e3:.0f} ms (aim ≤ 60)"
    )


def _sheets(problem: Problem) -> list[float]:
    construction = solve(problem, repeats=0, precise=False).construction
    return best(lambda: _lettered(construction), lambda: _bare(construction), runs=5)


def _planned(mech: Mechanism) -> None:
    """Taken apart anew: what was taken apart last is kept."""
    assur._decomposed.cache_clear()
    assur.decompose(mech)


def _lettered(construction: Construction) -> None:
    drawn_anew()
    sheets(construction)


def _bare(construction: Construction) -> None:
    for figure in construction.figures:
        around = Surroundings.of(figure.view, figure.marks, "zh")
        unique(tuple(item for mark in figure.marks for item in draw(mark, around)))


if __name__ == "__main__":
    print(run())
