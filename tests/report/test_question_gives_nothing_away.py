"""A question sheet tells no criterion and no step of its answer, and leaves no white that could be worked on."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from tests.studies import solved
from vecpoly import loads
from vecpoly.board.construction import Construction, Figure
from vecpoly.board.paper.marks import Note, Point
from vecpoly.designs.base import Design
from vecpoly.problem.load import load
from vecpoly.problem.values.made import problem
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.framed.readings import Blank, readings
from vecpoly.report.question.sketch import sketched
from vecpoly.report.question.working import LEAST_ROOM, Spare, working
from vecpoly.report.statement.asked import asked
from vecpoly.solution import YES_NO, solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

COLUMN = 170.0 * MM
TRACED = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [92 mm, 0 mm]}
links:
  1: {AB: 33 mm}
  2: {BC: 87 mm, E: {along: BC, at: 30 mm, left: 21 mm}}
  3: {CD: 89 mm}
input: {link: 1, phi: 231 deg, omega: 10 rad/s ccw}
branch: [C left of BD]
find: [v_C]
"""
CRITERION = re.compile(r"[（(]\$[^$]*[<>≤≥=][^$]*\$[)）]")


@each(IDS)
def test_what_is_answered_by_yes_or_no_is_asked_without_its_criterion(name: str) -> None:
    solution = drawn(name).solution
    if not any(one.reading.unit == YES_NO for one in solution.answers.values()):
        return
    langs: tuple[Lang, ...] = ("zh", "en")
    for lang in langs:
        cells = [
            cell for row in empty_table(solution, lang).rows for cell in row if "是/否" in cell or "yes or" in cell
        ]
        assert cells and not [cell for cell in cells if CRITERION.search(cell) or ") (" in cell]
        assert not CRITERION.search(asked(solution, lang))


@pytest.mark.parametrize(("name", "acted_on"), [("3-10", False), ("4-7", True)])
def test_a_sketch_has_the_inks_of_the_solution_where_it_shows_what_they_tell_apart(name: str, acted_on: bool) -> None:
    one = solved(name)
    figure = sketched(one.problem, one.construction, 120.0, 70.0)
    assert figure is not None and one.construction.tones and bool(figure.tones) is acted_on


def test_a_chain_that_is_judged_by_its_lengths_is_sketched_as_one() -> None:
    """Its lengths laid off one behind the other would tell which are added up."""
    one = solved("8-1")
    figure = sketched(one.problem, one.construction, 120.0, 70.0)
    assert figure is not None
    assert {"A", "B", "C", "D"} <= {mark.label for mark in figure.marks if isinstance(mark, Point)}


def test_which_link_is_the_frame_of_a_double_rocker_is_told_by_no_symbol() -> None:
    """l_CD min and l_CD max told that it is CD."""
    one = solved("8-1")
    langs: tuple[Lang, ...] = ("zh", "en")
    for lang in langs:
        cells = " ".join(row[0] for row in empty_table(one, lang).rows)
        blanks = [blank.symbol for figure in one.construction.figures for blank in asked_on(one.construction, figure)]
        told = re.sub("[{}]", "", " ".join([asked(one, lang), cells, *blanks]))
        assert "l_f min" in told and len(blanks) == 4 and not re.search("AB|BC|CD|AD", told)


def asked_on(construction: Construction, figure: Figure) -> tuple[Blank, ...]:
    """The lines of a frame."""
    found = readings(construction, figure)
    return () if found is None else found.blanks


def test_a_chain_that_does_not_reach_the_position_of_the_sketch_has_none_of_it() -> None:
    data = {"AB": "100 mm", "BC": "300 mm", "CD": "150 mm", "AD": "110 mm"}
    told = {"id": "g", "title": {"zh": "甲", "en": "a"}, "synthesis": "grashof", "data": data, "find": ["ends"]}
    one = solve(problem(told))
    figure = sketched(one.problem, one.construction, 120.0, 70.0)
    assert figure is None or "D" not in {mark.label for mark in figure.marks if isinstance(mark, Point)}


@pytest.mark.parametrize("room", [60.0, 100.0])
def test_what_the_page_leaves_below_the_results_is_squared_if_it_is_no_strip(room: float) -> None:
    foot = [empty_table(solved("8-2e"), "en")]
    (block,) = working("Working", 0.0, foot, "en")
    assert isinstance(block, Spare)
    alone = block.wrap(COLUMN, 0.0)[1]
    height = block.wrap(COLUMN, alone + room * MM)[1]
    assert (height > alone + 1.0) == (room * MM >= LEAST_ROOM + block._other(COLUMN) - alone)
    assert alone <= height <= alone + room * MM and block.split(COLUMN, alone / 2) == foot


@pytest.mark.parametrize(
    ("name", "lengths"),
    [("8-17", {"l_AB", "l_AC", "l_CD", "l_DE", "h"}), ("whitworth-by-K", {"l_AB", "l_AC", "l_CD", "l_DE"})],
)
def test_a_quick_return_that_is_to_be_found_is_sketched_in_proportions_that_are_no_answer(
    name: str, lengths: set[str]
) -> None:
    """Its statement alone told how crank, lever, rod and ram hang together."""
    figures = []
    for time_ratio in ("2", "1.5"):
        text = re.sub(r"\bK: [\d.]+", f"K: {time_ratio}", load(name).text)
        one = solve(loads(text), repeats=0, precise=False)
        figures.append(sketched(one.problem, one.construction, 120.0, 70.0))
    first, second = figures
    assert first is not None and second is not None and first.marks == second.marks and "示意图" in first.title.zh
    labels = {re.sub("[${}]", "", getattr(mark, "label", "") or "") for mark in first.marks}
    told = {re.sub("[${}]", "", mark.words.zh) for mark in first.marks if isinstance(mark, Note)}
    assert lengths <= labels | told and set("ABCDE") <= labels


DESIGNS = Later(lambda: [name for name in IDS if isinstance(given(name).subject, Design)])


@each(DESIGNS)
def test_no_letter_stands_twice_on_the_sketch_of_what_is_given(name: str) -> None:
    """The stroke H of K-slider-crank-BC stood at its line, and once more where the drawing letters another."""
    figure = sketched(given(name), drawn(name).construction, 120.0, 70.0)
    letters = [label for mark in (figure.marks if figure else ()) if (label := getattr(mark, "label", ""))]
    assert len(letters) == len({*letters}), letters


def test_which_link_is_varied_is_told_where_it_is_not_the_only_frame_of_a_double_rocker() -> None:
    """The question had the frame AD drawn and asked for bounds of l_f: nobody could know that CD was meant."""
    text = "id: t\ntitle: t\nsynthesis: grashof\ndata: {AB: 116 mm, BC: 180 mm, CD: 122 mm, AD: 208 mm}\n"
    cells = " ".join(row[0] for row in empty_table(solve(loads(text + "find: [CD_min, CD_max]\n")), "en").rows)
    assert "lower bound of $CD$ as the frame" in cells and "upper bound of $CD$" in cells


def test_a_sketch_has_nothing_by_which_a_path_is_compared() -> None:
    """The foot T_0 of the greatest deviation from a curve, which is found, stood on the sketch of the question."""
    target = "target: {point: E, through: [[48 mm, 21 mm], [-34 mm, -5 mm], [38 mm, 64 mm]]}\n"
    one = solve(loads(TRACED + target))
    figure, drawn = sketched(one.problem, one.construction, 120.0, 70.0), one.construction.figures[0]
    assert figure is not None and "T_0" in {mark.label for mark in drawn.marks if isinstance(mark, Point)}
    assert not {"T", "T_0"} & {mark.label for mark in figure.marks if isinstance(mark, Point)}
