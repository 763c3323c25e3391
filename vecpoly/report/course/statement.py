"""Chapter 1, the task: the statement, what is given and asked, the mechanism in its given position."""

from __future__ import annotations

from typing import Any

from ...drawing.figure import draw_figure
from ...mechanism.mobility import mobility
from ...words import Words
from ..content import statement
from ..picture import picture
from .numbering import Press
from .study import Study

_PICTURE = (130.0, 80.0)  # mm


def task(study: Study, press: Press) -> dict[str, Any]:
    """The words of the statement, and the sketch."""
    press.chapter = "1"
    figure = picture(study.problem, study.solution.construction, *_PICTURE)
    scene = draw_figure(figure, lang=press.lang, caption=False) if figure else None
    title = Words(f"{study.problem.title.zh}（{study.where(study.mech.drive.position)}）", f"{study.problem.title.en} ({study.where(study.mech.drive.position)})")
    return {**statement(study.solution, press.lang), "picture": press.figure(scene, title) if scene else "", "freedom": mobility(study.mech).freedom}
