"""Beside a vector equation of a solution stands the small polygon that it draws, on paper that was blank."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from tests.studies import solved
from tests.texts import equation
from vecpoly.algebra.formula import row
from vecpoly.report.document import markup
from vecpoly.report.flow.base import Tightness
from vecpoly.report.flow.blocks import Drawing
from vecpoly.report.flow.equation import EquationFlow
from vecpoly.report.flow.formula import Formula
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.flow.results.illustrated import CLEAR, LOW, NARROW, WIDE, Beside, illustrated
from vecpoly.report.flow.xml import to_flowables
from vecpoly.solution import Solution
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

NAMES = ("3-9", "3-12", "A-27", "4-3a", "5-5")
TOLD = {"en": "beside the equations are sketches, not to scale", "zh": "方程旁的小图为示意图，不按比例"}


def story(some: Sequence[Solution], lang: Lang = "en", style: str = "solution") -> tuple[list[Any], str]:
    """The flowables of a report, and its markup."""
    xml, objects = markup(some, lang, style, {}, None, None)
    return to_flowables(xml, objects.named, lang), xml


def figured(name: str, lang: Lang = "en") -> list[Beside]:
    """The displays of a solution beside which a figure stands."""
    blocks, _ = story([solved(name)], lang)
    return [one for one in blocks if isinstance(one, Beside) and one.figure is not None]


@pytest.mark.parametrize("name", NAMES)
def test_the_figure_ends_at_the_right_margin_and_no_display_comes_near_it(name: str) -> None:
    found = figured(name)
    assert found
    for one in found:
        assert one.figure is not None
        wide, high = (side / MM for side in one.figure.size)
        _, whole = one.wrap(COLUMN, 0.0)
        assert wide <= WIDE + 1e-6 and high <= whole / MM + 1e-6
        for display in one.displays:
            left, right = display.reach
            assert left - one.aside >= 0.0
            assert right - one.aside + CLEAR <= COLUMN / MM - wide + 1e-6


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_it_is_said_once_that_the_figures_are_sketches_where_there_are_any(lang: Lang) -> None:
    assert story([solved("3-9"), solved("3-12")], lang)[1].count(TOLD[lang]) == 1
    assert TOLD[lang] not in story([solved("2-6")], lang)[1]


def test_question_sheets_have_none() -> None:
    blocks, xml = story([solved("3-9")], style="question")
    assert blocks and not any(isinstance(one, Beside | EquationFlow) for one in blocks)
    assert TOLD["en"] not in xml


def test_it_tells_what_it_shows_to_whoever_cannot_see_it() -> None:
    velocity, _ = figured("3-9")
    assert velocity.figure is not None
    said = velocity.figure.tag.alt
    assert said.startswith("The polygon of this equation (sketch)") and "v_C2B" not in said
    assert said.count("v sub") == 3 and "mm" not in said, said
    zh = figured("3-9", "zh")[0].figure
    assert zh is not None and zh.tag.alt.startswith("本方程的矢量多边形（示意）")


def test_a_wide_equation_has_its_figure_beside_the_lines_worked_out_under_it() -> None:
    blocks, _ = story([solved("3-9")])
    at = max(n for n, one in enumerate(blocks) if isinstance(one, Beside))
    assert isinstance(blocks[at - 1], EquationFlow) and not blocks[at].aside
    assert not any(isinstance(one, EquationFlow) for one in blocks[at].displays)


@pytest.mark.parametrize(("wide", "aside"), [(44.0, True), (30.0, True), (18.0, False)])
def test_an_equation_too_wide_with_few_lines_under_it_moves_left_with_them_as_far_as_it_must(
    wide: float, aside: bool
) -> None:
    figure = Drawing(wide, 15.0, lambda canvas, x, y: None, "a polygon")
    flow = EquationFlow(equation(6), "en", inset=lambda width, height: figure if width >= wide else None)
    lines = [Formula(row(f"v_C = {n} m/s")) for n in range(2)]
    beside, *behind = illustrated([flow, *lines])
    assert behind and isinstance(beside, Beside) and bool(beside.aside) == aside
    assert all(isinstance(one, Beside) == aside for one in behind)
    shown = [display for one in (beside, *behind) for display in (one.displays if isinstance(one, Beside) else [one])]
    assert len(shown) == 3
    _, right = beside.displays[0].reach
    assert right - beside.aside + CLEAR <= COLUMN / MM - wide + 1e-6
    assert not aside or right - beside.aside + CLEAR == pytest.approx(COLUMN / MM - wide)
    assert {getattr(one, "aside", 0.0) for one in behind} <= {beside.aside}


def test_the_place_is_as_high_as_the_displays_and_a_narrow_one_is_left_blank() -> None:
    blocks, _ = story([solved("3-9")])
    flow = next(one for one in blocks if isinstance(one, Beside)).displays[0]
    assert isinstance(flow, EquationFlow)
    asked = list[tuple[float, float]]()

    def refuses(width: float, height: float) -> None:
        asked.append((width, height))

    alone = EquationFlow(flow.table, "en", inset=refuses)
    assert [type(one) for one in illustrated([alone])] == [EquationFlow]
    assert asked and all(NARROW <= width <= WIDE and height == LOW for width, height in asked)


def test_set_more_tightly_its_displays_come_closer_and_the_figure_stays() -> None:
    loose = figured("3-9")[-1]
    tight = loose.undrawn()
    tight.tighten(Tightness(white=0.4, figures=0.7))
    assert tight.wrap(COLUMN, 0.0)[1] < loose.wrap(COLUMN, 0.0)[1]
    assert tight.figure is loose.figure
