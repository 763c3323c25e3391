"""All that the course template may say: the chapters in order, each made by its own file."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from ...findings.study.study import Study, study
from ...foundation.same import Same
from ...solution import REPEATS, Solution
from ...words import Lang, Words, label
from ..content import Objects
from ..picture import picture
from ..printed_tables import printed_tables
from . import appendix, statement
from .analysis import chapter as analysis
from .checks import book, comparison
from .checks import chapter as checking
from .machine import chapters as machine
from .modelling import axes, example
from .modelling import formulas as modelling
from .numbering import Press, drawn
from .results import chapter as results
from .results import drawings
from .spoken_symbols import words_in
from .structure import chapter as structure
from .symbols import symbols

_COVER = (130.0, 95.0)  # mm
KIND = Words("机械原理课程大作业", "Theory of machines: course assignment")


@lru_cache(maxsize=2)
def _studied(key: Same[Solution]) -> tuple[Study, comparison.Compared, machine.Machine]:
    """What is found before it is told: the same in both languages."""
    subject = study(key.it)
    return subject, comparison.compared(subject), machine.found(subject)


def course(solution: Solution, lang: Lang, objects: Objects) -> dict[str, Any]:
    """The chapters of one problem's course report. Raises NotAskedError for a device, NoMethodError for a group without
    a closed form."""
    subject, stations, running = _studied(Same(solution))
    press = Press(lang, objects)
    told = {
        "id": subject.problem.id,
        "label": label(subject.problem.id).of(lang),
        "assumed": statement.assumed(subject).of(lang),
        "whole": subject.whole.whole,
        "title": subject.problem.title.of(lang),
        "kind": KIND.of(lang),
        "cover": cover(solution, lang, objects),
        "hand": solution.construction.hand,
        "repeats": REPEATS,
        "drive": subject.where(subject.mech.drive.position).split(" = ")[0],
        "task": statement.task(subject, press),
        "structure": structure.chapter(subject, press),
        "axes": axes.chapter(subject, press),
        "model": modelling.chapter(subject, press) | {"example": example.section(subject, press)},
        "results": results.chapter(subject, press),
        "drawings": drawings.chapter(subject, press, drawings.chosen(subject, lang)),
        "comparison": comparison.chapter(subject, press, stations),
        "checking": checking.chapter(subject, press),
        "book": book.chapter(subject, press),  # within chapter 7
        "tables": (tables := printed_tables(subject.problem, lang, press.table)),  # within chapter 7
        "analysis": analysis.chapter(subject, press, stations, tables, found=machine.conclusion(subject, running)),
        "machine": machine.chapters(subject, press, running),
        "appendix": appendix.chapter(subject, press),
    }
    words = words_in([told, *objects.named.values()])
    return told | {"symbols": symbols(subject, press, words), "called": press.called}


def cover(solution: Solution, lang: Lang, objects: Objects) -> str:
    """The drawing on the first page; empty where there is none."""
    from ...drawing.figure import draw_figure

    figure = picture(solution.problem, solution.construction, *_COVER)
    return (
        objects.add("cover", drawn(draw_figure(figure, lang=lang, caption=False), "", figure.title.of(lang)))
        if figure
        else ""
    )
