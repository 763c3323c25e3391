"""What is said once of how a solution is drawn and told; a template asks whether it holds."""

from __future__ import annotations

import re

from ...algebra.formula import plain
from ...board.paper.marks import Role, Segment
from ...drawing.beside import beside as drawn_apart
from ...printed.midway import some_go_down
from ...solution import Solution

_PRIMED = re.compile(r"[A-Z]′(?:_\d)?")


def conventions(solution: Solution) -> dict[str, str]:
    """Each by the name that a template gives it; empty where it does not hold."""
    held = {
        "hued": _has_hues(solution),
        "dashed": _has_dashes(solution),
        "unsolvable": solution.construction.conclusion is not None,
        "doubled": _has_doubled(solution),
        "coriolis": any(key.startswith("ak_") for key in solution.construction.readings),
        "placed": any(one.is_place for one in solution.answers.values()),
        "to_even": some_go_down(solution.construction),
        "superscripts": _has_numbers(solution),
    }
    return {name: name if holds else "" for name, holds in held.items()} | {"primed": _primed(solution)}


def _has_numbers(solution: Solution) -> bool:
    """Whether the number of a solution stands above the symbol of what a line tells, l_AB^(1): beside one solution the
    lines of rejected candidates are not printed, and that of a centre point, M^(1), is told by its step."""
    if sum(one.reason is None for one in solution.construction.candidates) == 1:
        return False
    lines = (line for step in solution.construction.steps for line in step.formulas)
    return any("^(" in plain(line).partition(" = ")[0] for line in lines)


def _primed(solution: Solution) -> str:
    """A point by whose prime the second solution is known on the sheet, while its quantities have a number; "" where
    none is named."""
    lines = (plain(line) for step in solution.construction.steps for line in step.formulas)
    named = (_PRIMED.search(line.partition(" = ")[2]) for line in lines if "^(2)" in line)
    return next((f"${found[0]}$" for found in named if found is not None), "")


def _has_hues(solution: Solution) -> bool:
    """Whether vectors have hues, in equations and figures alike."""
    construction = solution.construction
    return bool(construction.tones) and any(step.equation is not None for step in construction.steps)


def _has_dashes(solution: Solution) -> bool:
    """Whether the construction without friction stands beside that with it."""
    marks = (mark for figure in solution.construction.figures for mark in figure.marks)
    return any(isinstance(mark, Segment) and mark.role is Role.IDEAL for mark in marks)


def _has_doubled(solution: Solution) -> bool:
    """Whether vectors that lie on one line are drawn side by side."""
    polygons = (figure for figure in solution.construction.figures if not figure.view.bodies)
    return any(drawn_apart(figure.view, figure.marks) is not figure.marks for figure in polygons)
