"""A chapter on the motion of a mechanism: two positions drawn, and the whole cycle."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from ...board.construction import Pane, Step, View
from ...names import Rel
from ...project.part import Part
from ...solution import Solution
from ...words import Words
from ..content import scales, sections
from ..course.modelling.dimensions import dimensions
from ..course.numbering import SMALL
from ..course.results.chapter import sections as over_the_cycle
from ..course.results.drawn_views import drawn_views
from ..course.results.extreme_values import extremes
from ..flow.table import DataTable
from ..tables import readings_table
from .binder import Binder, Drawn
from .task import scene, sketch

_CHOSEN = {"zh": ["位置", "比例尺", "图号"], "en": ["Position", "Scales", "Sheets"]}


def chapter(part: Part, binder: Binder) -> dict[str, Any]:
    """Diagram, steps of the first position, readings of all, cycle."""
    press, study, drawn = binder.press, part.study, binder.drawn[part.name]
    figure = sketch(part, binder)
    where = drawn[0].where
    title = Words(f"机构运动简图（{where}）", f"Kinematic diagram ({where})")
    return {
        "picture": press.figure(scene(figure, binder), title) if figure else "",
        "dimensions": dimensions(study, press, figure),
        "positions": _positions(binder, drawn),
        "views": drawn_views(part.solution.construction).of(binder.lang),
        "where": where,
        "sections": sections(moving(part.solution), binder.lang, press.objects),
        "table": _readings(binder, drawn),
        "extremes": extremes(study, press),
        "cycle": over_the_cycle(study, press),
        "base": part.base.problem.title.of(binder.lang) if part.base else "",
    }


def _positions(binder: Binder, drawn: tuple[Drawn, ...]) -> str:
    rows = [
        (one.where, scales(one.solution, binder.lang), binder.listed([name.of(binder.lang) for name in one.names]))
        for one in drawn
    ]
    return binder.press.table(
        Words("作图的位置", "The positions drawn"), _CHOSEN[binder.lang], rows, "lll", style=SMALL
    )


def _readings(binder: Binder, drawn: tuple[Drawn, ...]) -> str:
    title = Words("图解值与精确值：速度和加速度", "Drawn and exact values: velocities and accelerations")
    return readings(binder, drawn, True, title)


def readings(binder: Binder, drawn: tuple[Drawn, ...], motion: bool, title: Words) -> str:
    """The readings of all positions, of motion or of forces, in one table; without expected errors."""
    made = [(one.where.split(" = ")[1], _of(one.solution, motion, binder)) for one in drawn]
    header = list(dict.fromkeys(name for _, table in made for name in table.header))[:-1]
    rows = []
    for where, table in made:
        for n, row in enumerate(table.rows):
            cells = dict(zip(table.header, row, strict=True))
            rows.append(("" if n else where, *(cells.get(name, "—") for name in header)))
    drive = drawn[0].where.split(" = ")[0]
    return binder.press.table(title, [drive, *header], rows, "ll" + "c" * (len(header) - 3) + "rr", style=SMALL)


def _of(solution: Solution, motion: bool, binder: Binder) -> DataTable:
    answers = {key: one for key, one in solution.answers.items() if isinstance(one.rel, Rel) == motion}
    return readings_table(replace(solution, answers=answers), binder.lang)


def moving(solution: Solution) -> Solution:
    """The solution with the steps up to the forces."""
    return _with_steps(solution, forces=False)


def pressing(solution: Solution) -> Solution:
    """The solution with the steps of the forces."""
    return _with_steps(solution, forces=True)


def _with_steps(solution: Solution, *, forces: bool) -> Solution:
    steps = solution.construction.steps
    first = next((one.section for one in steps if _of_forces(one)), None)
    at = next((i for i, one in enumerate(steps) if one.section == first), len(steps))
    kept = steps[at:] if forces else steps[:at]
    return replace(solution, construction=replace(solution.construction, steps=kept))


def _of_forces(step: Step) -> bool:
    view = step.view.view if isinstance(step.view, Pane) else step.view
    return view in (View.FORCE, View.BODY)
