"""The numbered steps under their headings, each with its equation, formulas and table."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import groupby
from typing import Any

from ...algebra.formula import Node
from ...board.construction import Step
from ...solution import Solution
from ...words import Lang
from ..answers.alike import lines_of_twins
from ..content import Objects
from ..flow.equation import EquationFlow
from ..flow.results.abreast import abreast
from ..on_paper import on_paper
from ..tables import listed
from .inset import equation_of
from .lines import chained, displayed, measured_once, together, with_results
from .pointing import pointed
from .rows import in_runs, lead_of, rows_table


def sections(solution: Solution, lang: Lang, objects: Objects) -> list[dict[str, Any]]:
    """The numbered steps under their headings; like steps in a row are one item with a table."""
    out, same = [], lines_of_twins(solution, lang)
    for title, steps in groupby(solution.construction.steps, key=lambda s: s.section.of(lang)):
        told = [
            _step(run[0], solution, lang, objects, same) if len(run) == 1 else _run(run, lang, objects)
            for run in in_runs(steps)
        ]
        out.append({"title": title, "steps": told, "insets": any(one["inset"] for one in told)})
    return out


def _run(steps: tuple[Step, ...], lang: Lang, objects: Objects) -> dict[str, Any]:
    table = objects.add("tab", rows_table(steps, lang))
    return {
        "n": steps[0].number,
        "words": lead_of(steps, lang),
        "equation": "",
        "table": table,
        "formulas": [],
        "inset": False,
    }


def _step(step: Step, solution: Solution, lang: Lang, objects: Objects, same: Mapping[int, Node]) -> dict[str, Any]:
    once = measured_once([same.get(id(node), node) for node in displayed(step, solution)])
    told = together([*chained([*once])])
    lines = abreast([pointed(line, lang) for line in told])
    equation = equation_of(step, lines, solution, lang)
    return {
        "n": step.number,
        "words": with_results(on_paper(step.words.of(lang), solution), step, solution, lang),
        "equation": objects.add("eq", equation) if equation else "",
        "table": objects.add("tab", listed(step.listing, lang)) if step.listing else "",
        "formulas": [objects.add("f", one) for one in lines],
        "inset": isinstance(equation, EquationFlow),
    }
