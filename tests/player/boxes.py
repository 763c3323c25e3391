"""Pages with a box for one's own answers, what is asked in it, and how such a page is opened."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from tests.chromium import Page
from tests.grading.cases import key_of, problem_of
from vecpoly.grading.key import Graded
from vecpoly.player.page import player_html
from vecpoly.player.questions import KINDS
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang


@cache
def solution_of(name: str) -> Solution:
    return solve(problem_of(name), repeats=0)


@cache
def html_of(name: str) -> str:
    return player_html(solution_of(name), places=0, check=True)


@cache
def asked(name: str) -> tuple[Graded, ...]:
    return tuple(one for one in key_of(name).quantities if one.asked and one.kind in KINDS)


def at(page: Page, folder: Path, name: str, lang: Lang = "zh") -> None:
    """Open the page of a problem afresh."""
    file = folder / f"{name}.html"
    if not file.exists():
        file.write_text(html_of(name), encoding="utf-8")
    page.open(f"{file.as_uri()}#lang={lang}")
    page.wait("player.ready")


def judging(page: Page, folder: Path, name: str) -> None:
    """The page of a problem for claims that type nothing into it: opened once for those that follow each other."""
    if not page.url.endswith(f"/{name}.html#lang=en&judging"):
        at(page, folder, name, "en")
        page.url += "&judging"
