"""Problems solved and studied for the course report, once for all files that make claims about them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

import pytest
from matplotlib.figure import Figure

from vecpoly.curves import plot
from vecpoly.drawing.scene import Rect, Scene
from vecpoly.findings.study.study import Study, study
from vecpoly.problem.load import load
from vecpoly.report import document as reports
from vecpoly.report.content import Objects
from vecpoly.report.course import document
from vecpoly.report.course.checks import comparison
from vecpoly.report.course.checks.comparison import Compared, compared
from vecpoly.report.course.machine.chapters import Machine
from vecpoly.report.course.machine.chapters import found as found_of
from vecpoly.report.course.results import drawings
from vecpoly.report.document import report_bytes
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

FEW = 4  # positions at which drawings are compared, where a claim is about words


@cache
def solved(name: str) -> Solution:
    """The problem of the library, drawn once and not repeated."""
    return solve(load(name), repeats=0, precise=False)


@cache
def studied(name: str) -> Study:
    """What the course report of this problem is about."""
    return study(solved(name))


@cache
def stations(name: str) -> Compared:
    """Its drawings over the cycle beside the exact values."""
    return compared(studied(name))


@cache
def machine(name: str) -> Machine:
    """What is found of it as a machine."""
    return found_of(studied(name))


@cache
def course_text(name: str, lang: Lang) -> tuple[str, Objects]:
    """The filled template of its course report and the things it names: about one study in both languages."""
    it = studied(name)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(document, "_studied", lambda _: (it, stations(name), machine(name)))
        return reports.markup([it.given], lang, "course", {}, None, None)


@cache
def course_words(name: str, lang: Lang) -> tuple[str, Objects]:
    """The same for claims about what is said and listed: drawn in few positions, and its curves are blank."""
    return words_of(studied(name), lang)


def words_of(it: Study, lang: Lang) -> tuple[str, Objects]:
    """The same of what has been studied already, so that it is not studied again."""
    with in_small() as patch:
        patch.setattr(document, "study", lambda _: it)
        return reports.markup([it.given], lang, "course", {}, None, None)


@contextmanager
def in_small(blank: bool = True) -> Iterator[pytest.MonkeyPatch]:
    """Course reports are drawn in few positions, and their curves are blank, if nobody says otherwise."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(comparison, "STATIONS", FEW)
        patch.setattr(drawings, "POSITIONS", 2)
        patch.setattr(drawings, "LOADED", 2)
        if blank:
            patch.setattr(plot, "record", _blank)
        yield patch


def _blank(figure: Figure) -> Scene:
    """Nothing, as large as the figure: its pixels are millimetres."""
    return Scene((), Rect(0.0, 0.0, figure.bbox.width, figure.bbox.height))


@cache
def course_report(name: str, lang: Lang) -> bytes:
    """The course report of this problem, as a PDF."""
    made = course_text(name, lang)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reports, "markup", lambda *_: made)
        return report_bytes([solved(name)], lang=lang, style="course")
