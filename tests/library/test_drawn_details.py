"""Nothing of the library is too small to be read without being told: crowded places are drawn apart, and what is too
short is said to be so, in the step, in the box of answers and in the table alike."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from tests.drawn_library import DRAFTED, IDS, drawn
from tests.drawn_sheets import laid
from tests.each import Later, each
from tests.library.test_measured_lettered import letter, overlined
from vecpoly.board.acts import Locate, Measure
from vecpoly.board.paper.marks import Point
from vecpoly.board.ruler import READABLE
from vecpoly.drawing.details.apart import ROMAN, is_detail
from vecpoly.drawing.details.knots import knots
from vecpoly.drawing.scene import Rect, Scene, Stroke, TextBox
from vecpoly.drawing.sheets.sheet import Placed
from vecpoly.report.answers.line import answer_line
from vecpoly.report.answers.tables import readings_tables

NO_ROOM = {"best-gamma", "stephenson-valve-gear", "B-26.5", "B-29.5"}  # one sheet holds them only without details
KNOTTED = Later(lambda: (n for n in DRAFTED if n not in NO_ROOM and any(map(knots, drawn(n).construction.figures))))
SHORT = Later(lambda: (name for name in IDS if any(one.short for one in drawn(name).solution.answers.values())))


def details(name: str) -> list[Placed]:
    """The details on the sheets of a problem."""
    figures = drawn(name).construction.figures
    placed = [one for sheet in laid(name) for one in sheet.figures]
    return [one for one in placed if any(one.view is f.view and is_detail(one.name, f) for f in figures)]


def _rects(ink: Scene) -> Iterator[Rect]:
    """Small rectangles about its lines and letters."""
    for item in ink.items:
        if isinstance(item, Stroke):
            for a, b in pairwise(item.points):
                for at in np.linspace(a, b, max(2, int(abs(b - a)))):
                    yield Rect(at.real, at.imag, at.real, at.imag).grown(0.1)
        elif isinstance(item, TextBox):
            yield item.rect


@each(KNOTTED)
def test_a_figure_with_crowded_places_has_details(name: str) -> None:
    assert details(name)


@each(KNOTTED)
def test_every_ring_of_a_sheet_has_its_detail_there_and_they_are_numbered_through(name: str) -> None:
    rings, titles = list[str](), list[str]()
    for sheet in laid(name):
        for one in sheet.figures:
            assert one.figure is not None
            if one in details(name):
                titles += re.findall(f"[{ROMAN}]", one.figure.title.zh)
            else:
                rings += [m.label for m in one.figure.marks if isinstance(m, Point) and m.label in set(ROMAN)]
        assert rings == titles
    assert rings == list(ROMAN[: len(rings)])


@each(KNOTTED)
def test_details_stand_on_no_other_figure_and_inside_the_frame(name: str) -> None:
    for sheet in laid(name):
        for one, scene in sheet.parts:
            if one not in details(name):
                continue
            box, (wide, high) = one.extents, sheet.size
            assert box.x0 >= 10 and box.y0 >= 26 and box.x1 <= wide - 10 and box.y1 <= high - 10
            others = [rect for other, ink in sheet.parts if other is not one for rect in _rects(ink)]
            assert not any(box.overlaps(rect) for rect in others) and scene.items


def test_most_crowded_places_of_the_library_are_drawn_apart() -> None:
    asked = sum(len(knots(figure)) for name in KNOTTED for figure in drawn(name).construction.figures)
    assert sum(len(details(name)) for name in KNOTTED) >= 0.85 * asked


@each(SHORT)
def test_an_answer_read_off_too_short_a_length_is_told_so_in_box_and_table(name: str) -> None:
    solution = drawn(name).solution
    short = [one for one in solution.answers.values() if one.short]
    for answer in short:
        assert answer.reading.mm is not None and abs(answer.reading.mm) < READABLE
        assert "过短" in answer_line(answer, solution, "zh").after
        assert "too short" in answer_line(answer, solution, "en").after
    rows = [row for table in readings_tables(solution, "zh") for row in table.rows if "过短" in " ".join(row)]
    named = [symbol for row in rows for symbol in row[0].split(" = ")]  # several that are one stand in one row
    assert sorted(named) == sorted(f"${one.reading.symbol}$" for one in short)


@each(IDS)
def test_a_step_says_of_what_it_reads_whether_it_is_too_short_to_be_measured(name: str) -> None:
    """Of an answer, which is read at the end, the step that has its line."""
    construction = drawn(name).construction
    read: dict[int, list[float]] = {}
    points = {act.key for act in construction.acts if isinstance(act, Locate)}  # whose coordinates are read
    lines = {step.number: {letter("".join(one)) for one in overlined((step,))} for step in construction.steps}
    for act in construction.acts:
        if isinstance(act, Measure) and act.key not in points:
            own, key = act.head.step, letter(act.key)
            has_it = own in lines and (key in lines[own] or construction.steps[own - 1].listing is not None)
            later = [] if has_it else [number for number, of_step in lines.items() if key in of_step]
            read.setdefault(max(later, default=own), []).append(abs(act.b - act.a))
    for step in construction.steps:
        short = [mm for mm in read.get(step.number, []) if 0.06 < mm < READABLE - 0.01]
        told = "过短，量取不可靠" in step.words.zh
        assert told == ("too short to be measured" in step.words.en)
        if short and step.formulas:
            assert told, (step.number, short)
        if told:
            assert any(0.04 < mm < READABLE for mm in read[step.number])
