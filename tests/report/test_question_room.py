"""Squared paper on a question sheet: as much as the work needs, told by what must be worked out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO

import pdfplumber
import pytest

from tests.drawn_library import IDS, LIBRARY, drawn, given
from tests.each import each
from tests.laws import few
from vecpoly.algebra.formula import plain
from vecpoly.problem.load import loads
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.base import Block
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.question.room import EACH, LEAST, MOST, ROOMY, weight, working_room
from vecpoly.report.question.working import LEAST_ROOM, STRIP, TIGHT, Squares, working
from vecpoly.report.tables import given_tables
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

PAGE = 250.0 * MM
PRINTED = re.compile(r"应为 ?50 mm|50 mm when printed")  # under the bar of a sheet to draw on


class Foot(Block):
    """Results of this height, mm."""

    def __init__(self, high: float) -> None:
        super().__init__()
        self.high = high * MM

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """As high as it is."""
        return width, self.high


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """A printed question: the heights (mm) of its squares, and how far down each page of text is filled."""

    squares: Sequence[float]
    reach: Sequence[float]


def sheet(name: str, lang: Lang) -> Sheet:
    """As it is printed."""
    squares, reach = list[float](), list[float]()
    with pdfplumber.open(BytesIO(report_bytes([drawn(name).solution], lang=lang, style="question"))) as pdf:
        for page in (page for page in pdf.pages if not PRINTED.search(page.extract_text())):
            upright = [one for one in page.lines if abs(one["width"]) < 0.1 and abs(one["linewidth"] - 0.25) < 0.01]
            squares += {round((one["bottom"] - one["top"]) / MM, 1) for one in upright if one["height"] > 15 * MM}
            ends = [one["bottom"] for one in (*page.chars, *page.lines) if one["bottom"] < page.height - 50]
            reach.append(max(ends) / page.height)
    return Sheet(squares=squares, reach=reach)


_TONGUES: tuple[Lang, ...] = ("zh", "en")
SHEETS = few(tuple((name, lang) for name in IDS for lang in _TONGUES), 37)


@each(SHEETS)
def test_squares_fill_one_page_at_most_and_no_last_page_is_all_but_empty(case: tuple[str, Lang]) -> None:
    """7-5 had a page and a half of them for seven values."""
    found = sheet(*case)
    assert sum(found.squares) <= 265.0, found.squares
    assert found.reach[-1] >= 0.3 and min(found.reach[:-1], default=1.0) > 0.7, found.reach


@each(IDS)
def test_the_room_for_the_work_grows_with_the_values_that_a_formula_gives(name: str) -> None:
    """Twelve millimetres each at least, until a page is full; half of them for what a scale alone gives."""
    solution = drawn(name).solution
    need = working_room(solution)
    formulas = [one.reading.formula for one in solution.answers.values() if one.reading.formula is not None]
    several = {plain(one) for one in formulas if weight(one) == 1.0}
    assert need == 0.0 or LEAST <= need <= MOST
    assert need >= min(EACH * len(several), MOST)


@pytest.mark.parametrize(
    ("name", "asked", "share"),
    [
        ("3-10", "v_B2", 1.0),
        ("3-10", "omega_3", 1.0),
        ("3-10", "a_B3", 0.5),
        ("7-5", "dW_max", 0.5),
        ("7-5", "phi_max", 0),
    ],
)
def test_a_value_of_a_formula_counts_once_one_of_a_scale_half_and_one_that_is_read_not(
    name: str, asked: str, share: float
) -> None:
    formula = drawn(name).solution.answers[asked].reading.formula
    assert (weight(formula) if formula is not None else 0.0) == share


@pytest.mark.parametrize("need", [60.0, 100.0, 150.0])
def test_squares_over_the_results_fill_the_page_or_stop_at_what_the_work_may_fill(need: float) -> None:
    (block,) = working("Working", need, [Foot(60.0)], "en")
    tallest = max(block.wrap(COLUMN, height * MM)[1] for height in range(150, 260, 10)) / MM
    assert tallest <= ROOMY * need + 60.0 + STRIP / MM + 15.0
    assert block.wrap(COLUMN, 130.0 * MM)[1] >= 60.0 * MM + min(0.7 * need, 40.0) * MM


def test_where_the_rest_of_a_page_is_room_enough_the_results_alone_stand_overleaf() -> None:
    (block,) = working("Working", 100.0, [Foot(110.0)], "en")
    room = 130.0 * MM
    assert block.wrap(COLUMN, room)[1] > room
    first, rest = block.split(COLUMN, room)
    assert first.wrap(COLUMN, room)[1] == pytest.approx(room, abs=0.1)
    assert rest.wrap(COLUMN, PAGE)[1] < 115.0 * MM


def test_low_results_have_squares_over_them_overleaf_and_what_is_lacking_goes_there() -> None:
    (low,) = working("Working", 100.0, [Foot(50.0)], "en")
    _, rest = low.split(COLUMN, 100.0 * MM)
    assert rest.wrap(COLUMN, PAGE)[1] >= 50.0 * MM + LEAST_ROOM
    (much,) = working("Working", 200.0, [Foot(90.0)], "en")
    _, rest = much.split(COLUMN, TIGHT * 150.0 * MM)
    assert rest.wrap(COLUMN, PAGE)[1] >= 90.0 * MM + 60.0 * MM


def test_squares_of_no_height_draw_no_line() -> None:
    (block,) = working("", 0.0, [], "en")
    assert block.wrap(COLUMN, PAGE)[1] == pytest.approx(0.0) and Squares(0.0).wrap(COLUMN, 0.0)[1] == 0.0


@each(LIBRARY)
def test_a_moment_of_three_places_or_more_is_given_by_a_table(name: str) -> None:
    """0 (0°), 200 (20°), 200 (50°), 0 (180°) N·m stood in the line."""
    for datum in given(name).given.data:
        assert datum.of("en").count("°)") < 3 or datum.words is not None, datum.of("en")


def test_a_motor_that_was_measured_at_three_speeds_is_given_by_a_table() -> None:
    text = "id: m\ntitle: t\ndevice: run-up\ndata: {{motor: [{}], load: 20 N*m, J: 2 kg*m^2}}\n"
    rows = "[0 rad/s, 100 N*m], [40 rad/s, 130 N*m], [157 rad/s, 0 N*m]"
    (table,) = given_tables(loads(text.format(rows)), "en")
    assert len(table.rows) == 3
