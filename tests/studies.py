"""Problems solved and studied for the course report, once for all files that make claims about them."""

from __future__ import annotations

from functools import cache

import pytest

from vecpoly.findings.study.study import Study, study
from vecpoly.problem.load import load
from vecpoly.report.course import document
from vecpoly.report.document import report_bytes
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang


@cache
def solved(name: str) -> Solution:
    """The problem of the library, drawn once and not repeated."""
    return solve(load(name), repeats=0)


@cache
def studied(name: str) -> Study:
    """What the course report of this problem is about."""
    return study(solved(name))


@cache
def course_report(name: str, lang: Lang) -> bytes:
    """The course report of this problem, as a PDF."""
    return course_of(studied(name), lang)


def course_of(it: Study, lang: Lang) -> bytes:
    """The course report of what has been studied already, so that it is not studied again."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(document, "study", lambda _: it)
        return report_bytes([it.given], lang=lang, style="course")
