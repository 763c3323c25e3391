"""Letters of a figure are named in the text, and letters of the text stand in the figure: designs, cams."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import drawn, given, ids
from tests.each import Later, each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Point
from vecpoly.designs.base import Design
from vecpoly.devices.cams.cam import Cam

MARK = re.compile(r"[MNPQ]_\d")  # points that mark a line or a body, and are no pins
DESIGNS = Later(lambda: (name for name in ids(mechanisms=False) if isinstance(given(name).subject, Design)))
CAMS = Later(lambda: (name for name in ids(mechanisms=False) if isinstance(given(name).subject, Cam)))


def plain(text: str) -> str:
    return text.translate(dict.fromkeys(map(ord, "{}$")))


def letters(name: str) -> set[str]:
    figures = drawn(name).construction.figures
    return {plain(mark.label) for figure in figures for mark in figure.marks if isinstance(mark, Point)}


@each(DESIGNS)
def test_points_that_mark_a_given_line_are_named_where_it_is_laid_out(name: str) -> None:
    first = drawn(name).construction.steps[0]
    figure = drawn(name).construction.figure(View.MECHANISM)
    marks = figure.marks if figure is not None else ()
    there = [plain(one.label) for one in marks if isinstance(one, Point) and one.step == first.number]
    assert {one for one in there if MARK.fullmatch(one)} <= set(MARK.findall(plain(first.words.zh)))


@each(CAMS)
def test_the_start_of_a_cam_has_the_letters_of_its_step(name: str) -> None:
    told = " ".join(step.words.zh for step in drawn(name).construction.steps)
    named = {letter for letter in ("B_0", "C_0", "m_1", "m_2", "m_3") if f"${letter}$" in told}
    assert named <= letters(name) and "$T$" not in told


@pytest.mark.parametrize("name", ["cam-rocker", "cam-roller-offset"])
def test_an_extreme_between_two_stations_has_a_letter_of_its_own(name: str) -> None:
    found = [one for one in letters(name) if one.startswith("m_")]
    told = " ".join(step.words.zh for step in drawn(name).construction.steps)
    assert found and all(f"位移线图上的 ${one}$" in told for one in found)


@each(CAMS)
def test_a_length_between_two_numbered_stations_is_told_by_both_of_them(name: str) -> None:
    """1616′ was printed, which might be one number."""
    for step in drawn(name).construction.steps:
        for text in (step.words.zh, step.words.en):
            assert not re.search(r"(\d+)\1′", plain(text)), text
