"""Sheets that are bound into a course report: their lines and arrows are told by the legend of a solution's sheets."""

from __future__ import annotations

import pytest

from tests.laws import few
from tests.presses import press
from tests.studies import studied
from vecpoly.drawing.legend.legend import TITLE, entries
from vecpoly.drawing.scene import Item, TextBox
from vecpoly.drawing.sheets.boxes.results import TITLE as RESULTS
from vecpoly.drawing.sheets.sheet import Sheet
from vecpoly.report.course.results.drawings import chosen
from vecpoly.report.course.results.elsewhere import own_steps
from vecpoly.typeset.box import Glyphs

SOME = ["3-9", "ex10", "swinging-block-offset-rod", "4-6"]


def _texts(items: tuple[Item, ...]) -> list[tuple[str, TextBox]]:
    """The type of a sheet with its boxes."""
    boxes = [item for item in items if isinstance(item, TextBox)]
    return [("".join(part.text for part in box.box.items if isinstance(part, Glyphs)), box) for box in boxes]


def _sheets(name: str) -> list[Sheet]:
    return [sheet for one in chosen(studied(name), "en") for sheet in one.sheets]


@pytest.mark.parametrize("name", few(SOME, 2))
def test_every_sheet_bound_into_a_report_has_the_legend_of_its_lines_and_arrows(name: str) -> None:
    for sheet in _sheets(name):
        asks = entries([one.figure for one in sheet.figures if one.figure is not None], "en")
        assert (TITLE.en in dict(_texts(sheet.results))) is bool(asks)


@pytest.mark.parametrize("name", few(SOME, 2))
def test_results_stand_over_the_legend_and_neither_on_a_figure(name: str) -> None:
    both = [sheet for sheet in _sheets(name) if {TITLE.en, RESULTS.en} <= {*dict(_texts(sheet.results))}]
    assert both
    for sheet in both:
        written, drawn = _texts(sheet.results), _texts(sheet.drawn)
        boxes = [box.rect.grown(-0.2) for _, box in written]
        assert not any(a.overlaps(b) for n, a in enumerate(boxes) for b in boxes[:n])
        assert not any(box.overlaps(other.rect) for box in boxes for _, other in drawn)


@pytest.mark.parametrize("name", few(["A-27", "4-6"], 2))
def test_the_sheet_of_the_given_position_carries_what_was_asked_beside_its_legend(name: str) -> None:
    drawn = chosen(studied(name), "en")[0]
    assert any({TITLE.en, RESULTS.en} <= {*dict(_texts(sheet.results))} for sheet in drawn.sheets)


@pytest.mark.parametrize("name", few(["3-9", "ex10"], 2))
def test_every_position_that_is_drawn_has_its_results_on_its_sheets(name: str) -> None:
    """Of what was asked at least what is no part of a vector: a long list had no room."""
    for one in chosen(studied(name), "en"):
        assert any(RESULTS.en in dict(_texts(sheet.results)) for sheet in one.sheets), one.phi


def test_what_is_constructed_on_a_mechanism_is_drawn_no_smaller_to_save_a_sheet() -> None:
    given, *others = chosen(studied("curv-1"), "en")
    for one in others:
        own = [
            figure.scale.value for figure in one.solution.construction.figures if figure.name and figure.scale.symbol
        ]
        assert min(own, default=0.0) <= 1.3 * given.solution.construction.figures[0].scale.value


def test_a_position_that_needs_a_step_of_its_own_tells_it() -> None:
    """ω_2 of a four-bar was read off a centre far off its sheet; "the others are drawn in the same way"."""
    it = studied("D-1")
    given, *others = chosen(it, "en")
    there = [(it.where(one.phi), one.solution) for one in others]
    (own,) = own_steps(given.solution, there, press("en"))
    assert own["words"].startswith("At $φ_{1}$ = 114.6°: The centre $P_{24}$ is off the paper") and own["formulas"]
    assert not own_steps(given.solution, [(it.where(given.phi), given.solution)], press("en"))
