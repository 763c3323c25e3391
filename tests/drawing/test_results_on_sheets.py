"""A sheet says what came out of it where it has room, and a red box over it hides nothing."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import pairwise

import pytest

from tests.drawn_library import DRAFTED, drafted
from tests.drawn_sheets import laid
from tests.each import each
from tests.laws import few
from vecpoly.algebra.formula import plain
from vecpoly.drawing.scene import Item, Rect, Stroke, TextBox, rect_of
from vecpoly.drawing.sheets.boxes.results import CLEAR, MARGINS, SIZES
from vecpoly.drawing.sheets.sheet import Sheet, sheets
from vecpoly.drawing.sheets.space import FRAME, STRIP
from vecpoly.printed.digits import drawn_number
from vecpoly.problem.load import load
from vecpoly.report.answers.line import named_line, short_line
from vecpoly.report.plates.results import SHORT, _listed, concluded
from vecpoly.solution import YES_NO, solve
from vecpoly.typeset import Glyphs, layout
from vecpoly.typeset.box import MM
from vecpoly.words import Lang, Words

SUSPECT = Words("存疑：与独立求得的结果不符", "Suspect: disagrees with the independent result")


@cache
def _laid(name: str, *, plates: bool = True, warned: bool = False) -> tuple[Sheet, ...]:
    solution = drafted(name)
    if solution is None:
        return ()
    if plates and not warned:
        return concluded(laid(name, bands=True), solution, "zh")
    construction = solution.construction
    shown = replace(construction, warning=SUSPECT) if warned else construction
    made = sheets(shown, lang="zh", on=solution.problem.paper, plates=plates)
    return concluded(made, solution, "zh")


def _block(sheet: Sheet) -> Rect:
    frame = next(item for item in sheet.results if isinstance(item, Stroke))
    return rect_of(frame)


@each(DRAFTED)
def test_results_on_a_sheet_stand_on_nothing_and_within_its_frame(name: str) -> None:
    for sheet in _laid(name):
        if not sheet.results:
            continue
        block = _block(sheet)
        assert block.x0 > FRAME and block.x1 < sheet.size[0] - FRAME
        assert block.y0 > FRAME + STRIP and block.y1 < sheet.size[1] - FRAME
        assert all(not one.extents.overlaps(block) or _apart(sheet, block) for one in sheet.figures)
        assert all(rect_of(item).grown(-0.2).overlaps(block) for item in sheet.results)
        sizes = {
            g.size
            for item in sheet.results
            if isinstance(item, TextBox)
            for g in item.box.items
            if isinstance(g, Glyphs)
        }
        assert max(sizes) <= max(SIZES) * MM + 1e-6


def _apart(sheet: Sheet, block: Rect) -> bool:
    """Whether no type and no end of a line stands in the block."""
    inside = block.grown(CLEAR - 0.1)
    texts = [item.rect for item in sheet.drawn if isinstance(item, TextBox)]
    ends = [z for item in sheet.drawn if not isinstance(item, TextBox) for z in item.points]
    return not any(one.overlaps(inside) for one in texts) and not any(
        inside.x0 < z.real < inside.x1 and inside.y0 < z.imag < inside.y1 for z in ends
    )


def test_results_stand_as_a_rule_over_the_right_end_of_the_title_strip() -> None:
    blocks = [(sheet, _block(sheet)) for name in DRAFTED for sheet in _laid(name) if sheet.results]
    low = [r.y0 < FRAME + STRIP + 5.0 and r.x1 > sheet.size[0] - FRAME - 5.0 for sheet, r in blocks]
    assert sum(low) >= 0.75 * len(low)


def test_results_keep_four_millimetres_to_the_frame_wherever_the_sheet_has_room_for_them() -> None:
    blocks = [(sheet, _block(sheet)) for name in DRAFTED for sheet in _laid(name) if sheet.results]
    white = [
        min(r.x0 - FRAME, r.y0 - FRAME - STRIP, s.size[0] - FRAME - r.x1, s.size[1] - FRAME - r.y1) for s, r in blocks
    ]
    assert min(white) >= MARGINS[-1] - 0.1 and sum(one > 4.0 for one in white) > 0.95 * len(white)


@pytest.mark.parametrize("name", ["4-2", "4-7", "A-27", "8-15", "rotor-dalby"])
def test_figures_that_moved_together_for_the_results_are_true_to_scale_where_they_were_drawn(name: str) -> None:
    """Each item is that of the figure at its origin."""
    solution = drafted(name)
    assert solution is not None
    for before, after in zip(laid(name, bands=True), _laid(name), strict=True):
        for (one, scene), (other, moved) in zip(before.parts, after.parts, strict=True):
            by = other.origin - one.origin
            pairs = zip(scene.items, moved.items, strict=True)
            assert all(abs(_at(b) - _at(a) - by) < 1e-6 for a, b in pairs)


def _at(item: Item) -> complex:
    return complex(item.x, item.y) if isinstance(item, TextBox) else item.points[0]


_CLASSES = {0.0: "none", 2.0: "class II", 3.0: "class III"}


@each(DRAFTED)
def test_a_line_on_a_sheet_ends_with_the_number_of_the_answer(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    for answer in solution.answers.values():
        if answer.is_place or answer.undefined or answer.reading.unit == YES_NO:
            continue
        if answer.key.startswith("class_"):
            assert plain(short_line(answer, solution, "en")) == _CLASSES[answer.drawn], answer.key
            continue
        assert drawn_number(answer) in plain(short_line(answer, solution, "en")), answer.key


@pytest.mark.parametrize("name", few(["3-9", "3-7c", "six-bar-dynamic"], 2))
def test_results_on_every_sheet_have_one_form_and_rows_of_one_height(name: str) -> None:
    solution = drafted(name) or solve(load(name), repeats=0, by="exact")
    for answer in solution.answers.values():
        assert " mm = " not in plain(named_line(answer, solution, "zh")), "the way to it stands in the steps"
    made = sheets(solution.construction, on=solution.problem.paper, plates=True)
    told = [sheet.results[2:] for sheet in concluded(made, solution, "zh") if sheet.results]
    for items in told:
        first = items[0]
        assert isinstance(first, TextBox)
        levels = [item.y for item in items if isinstance(item, TextBox) and item.x == first.x]
        gaps = {round(a - b, 6) for a, b in pairwise(levels)}
        assert told and len(gaps) == 1


@pytest.mark.parametrize(
    ("name", "key", "lang", "said"),
    [
        ("6-2", "static", "en", "statically balanced (ΣW = 0): yes"),
        ("6-2", "dynamic", "zh", "动平衡（ΣW l = 0）：否"),
        ("2-10", "class_5", "zh", "机构级别（原动件 5）：Ⅲ 级"),
        ("2-10", "class_1", "en", "class with link 1 as driver: class II"),
    ],
)
def test_what_has_no_number_is_told_on_a_sheet_by_its_name_in_words(name: str, key: str, lang: Lang, said: str) -> None:
    solution = solve(load(name), repeats=0, by="exact")
    assert plain(named_line(solution.answers[key], solution, lang)) == said
    sheets_ = concluded(sheets(solution.construction, on=solution.problem.paper, plates=True), solution, "zh")
    wide = layout(named_line(solution.answers[key], solution, "zh"), SIZES[0]).width
    assert any(isinstance(one, TextBox) and one.box.width == pytest.approx(wide) for one in sheets_[-1].results)


def test_most_problems_that_are_drawn_say_on_a_sheet_what_came_out() -> None:
    made = [sheets_ for name in DRAFTED if (sheets_ := _laid(name))]
    assert len(made) > 0.85 * len(DRAFTED) and sum(any(one.results for one in some) for some in made) > 0.85 * len(made)


@pytest.mark.parametrize("name", few(["3-2", "3-7b", "4-7", "six-bar-dynamic", "scissor-lift", "geared-five-bar"], 3))
@pytest.mark.parametrize("plates", [True, False])
def test_the_red_box_over_a_full_page_lies_over_no_figure(name: str, plates: bool) -> None:
    for sheet in _laid(name, plates=plates, warned=True):
        over = [one for item in sheet.alarm.items if (one := rect_of(item)).height < 20.0]
        assert over and not any(one.overlaps(figure.extents) for one in over for figure in sheet.figures)


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_what_was_read_off_too_short_a_length_has_a_star_and_a_line_that_says_so(lang: Lang) -> None:
    solution = drafted("3-5")
    assert solution is not None
    answers = dict(solution.answers)
    reading = answers["v_F"].reading
    answers["v_F"] = replace(answers["v_F"], reading=replace(reading, mm=0.3))
    assert answers["v_F"].short and not answers["v_B"].short
    (listed,) = _listed((answers["v_B"], answers["v_F"]), solution, lang)
    assert [plain(node).endswith(" *") for node in listed.nodes] == [False, True]
    (told,) = listed.said(3.8)
    assert "3 mm" in SHORT.of(lang) and told.width < 60.0
    assert not any(one.said(3.8) for one in _listed((answers["v_B"],), solution, lang))
