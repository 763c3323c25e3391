"""A chapter on the motion of a mechanism: two positions drawn, and the whole cycle."""

from __future__ import annotations

from typing import Any

from ...board.construction import Pane, Step, View
from ...foundation.slotted import replace
from ...names import Rel
from ...project.part import Part
from ...solution import Answer, Solution
from ...words import Words
from ..answers.tables import readings_at
from ..content import scales
from ..course.modelling.dimensions import dimensions
from ..course.numbering import SMALL
from ..course.results.chapter import sections as over_the_cycle
from ..course.results.drawn_views import drawn_views
from ..course.results.extreme_values import extremes
from ..steps.sections import sections
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
        "results": _readings(binder, drawn),
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


def _readings(binder: Binder, drawn: tuple[Drawn, ...]) -> list[str]:
    title = Words("图解值与精确值：速度和加速度", "Drawn and exact values: velocities and accelerations")
    return readings(binder, drawn, True, title)


def readings(binder: Binder, drawn: tuple[Drawn, ...], motion: bool, title: Words) -> list[str]:
    """The readings of all positions, of motion or of forces; without expected errors."""
    told = [(one.where.split(" = ")[1], one.solution, _of(one.solution, motion)) for one in drawn]
    return binder.press.tabled(title, readings_at(told, drawn[0].where.split(" = ")[0], binder.lang), SMALL)


def _of(solution: Solution, motion: bool) -> list[Answer]:
    return [one for one in solution.answers.values() if isinstance(one.rel, Rel) == motion]


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
