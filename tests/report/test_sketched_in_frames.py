"""Question sheets about the structure of a mechanism have frames to sketch in: what replaces it, its groups."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO

import pdfplumber
import pytest

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from tests.laws import few
from vecpoly.devices.structure import Structure
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.blocks import Heading
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.sketches import LOWEST, Frames, Sketching, sketching, to_sketch
from vecpoly.report.question.working import LITTLE
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

STRUCTURES = Later(lambda: few([name for name in LIBRARY if isinstance(given(name).subject, Structure)], 3))
_PAGE = 240.0 * MM
FEW = 6  # counts that stand in one block


@each(STRUCTURES)
def test_who_is_to_replace_higher_pairs_or_to_detach_groups_has_a_frame_to_sketch_them_in(name: str) -> None:
    """2-11 asked for the equivalent linkage and its groups and had two pages of squares and a table."""
    answer = drawn(name).solution
    titles, names = to_sketch(answer, "en"), [one.name for one in answer.construction.figures]
    assert ("Equivalent lower-pair linkage" in titles) is ("low" in names)
    drivers = {one.split()[1] for one in names if one.startswith("left ")}
    assert sum("Assur groups" in one for one in titles) == len(drivers)


@pytest.mark.parametrize(
    ("name", "titles"),
    [("2-10", ["Driver and Assur groups (driver 1)", "Driver and Assur groups (driver 5)"]), ("3-9", [])],
)
def test_the_frames_do_not_tell_how_many_groups_there_are(name: str, titles: list[str]) -> None:
    assert to_sketch(drawn(name).solution, "en") == titles


def test_all_corrections_of_a_draft_have_one_frame() -> None:
    assert to_sketch(drawn("2-5").solution, "en") == ["Equivalent lower-pair linkage", "Corrections"]


@pytest.mark.parametrize(("count", "height"), [(1, 62.0), (2, 62.0), (2, 150.0), (3, 130.0), (4, 140.0)])
def test_frames_are_of_one_size_with_room_for_a_linkage_and_for_their_titles(count: int, height: float) -> None:
    frames = Frames(["title"] * count, height * MM)
    frames.wrap(COLUMN, 0.0)
    places = frames.places()
    assert len({(round(wide, 6), round(high, 6)) for _, _, wide, high in places}) == 1
    for left, foot, wide, high in places:
        assert wide > 80.0 * MM and high > 50.0 * MM and foot > 5.0 * MM
        assert left >= 0.0 and left + wide <= COLUMN + 1e-6 and foot + high <= height * MM + 1e-6
    for n, (left, foot, wide, high) in enumerate(places):
        for other, below, *_ in places[n + 1 :]:
            assert other >= left + wide or below + high < foot or below > foot + high


@pytest.mark.parametrize("room", [60.0, 140.0])
def test_squares_stand_on_what_is_left_of_a_page_and_the_frames_overleaf_with_the_results(room: float) -> None:
    foot = [Heading("Results", 3, "en")]
    (block,) = sketching("Working", 30.0, ["groups"], foot, "en")
    first, rest = block.split(COLUMN, room * MM)
    assert first.wrap(COLUMN, room * MM)[1] <= room * MM and isinstance(rest, Sketching)
    assert rest.wrap(COLUMN, _PAGE)[1] <= _PAGE and not rest.split(COLUMN, LOWEST)
    assert not block.split(COLUMN, LITTLE)


@pytest.mark.parametrize(("name", "lang"), [("2-1", "en"), ("2-6", "en"), ("2-7", "zh"), ("2-11", "zh")])
def test_a_question_about_a_structure_fills_two_pages(name: str, lang: Lang) -> None:
    data = report_bytes([drawn(name).solution], lang=lang, style="question")
    with pdfplumber.open(BytesIO(data)) as document:
        assert len(document.pages) == 2
        for page in document.pages:
            assert max([*_feet(page.lines), *_feet(page.rects)]) > 0.85 * float(page.height)


def _feet(ink: Sequence[dict[str, float]]) -> list[float]:
    return [one["bottom"] for one in ink]


@each(STRUCTURES)
def test_counts_stand_in_two_blocks_side_by_side_and_every_rule_between_them_is_fine(name: str) -> None:
    """A cell that was left over looked like the head of a group: every third rule was heavy. A few rows stand alone."""
    table = empty_table(drawn(name).solution, "en")
    assert len(table.header) == (4 if len(drawn(name).solution.answers) > FEW else 2)
    assert not any(table._ruling.over(n, row) for n, row in enumerate(table.rows))
