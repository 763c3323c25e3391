"""Claims about references in a text, and the places to which they lead."""

from __future__ import annotations

from pathlib import Path

import pikepdf
import pytest

from vecpoly.algebra.formula import sym
from vecpoly.report.flow import DataTable, Formula, Heading, Metadata, Para, ReportDoc
from vecpoly.tagging.references import called, goal_of
from vecpoly.words import Lang


@pytest.mark.parametrize(
    ("text", "goals"),
    [
        ("与第 5 章的表和第 6 章的图解值对照。", ["section 5", "section 6"]),
        ("改进的办法见 8.3。", ["section 8.3"]),
        ("Remedies: see 8.3.", ["section 8.3"]),
        ("as Table 5-1 and figure 6-2 show", ["table 5-1", "figure 6-2"]),
        ("由式（4-12）和表 A-1", ["formula 4-12", "table A-1"]),
        ("the expected error of 6.2, in brackets", ["section 6.2"]),
        ("a length of 6.2 mm, from 3-9 to 4-3", []),
        ("see 6.25 mm of it; chapters end", []),
    ],
)
def test_a_reference_is_known_by_its_words_and_a_number_by_itself_is_none(text: str, goals: list[str]) -> None:
    pieces = list(called(text))
    assert [goal for goal, _ in pieces if goal] == goals and "".join(piece for _, piece in pieces) == text


def test_headings_captions_and_numbers_of_formulas_name_their_places() -> None:
    named = (
        "8.3　杆组方程的性态",
        "5 Results",
        "Table 5-1. Extremes",
        "图 6-1　φ_1 = 60°",
        "(4-12)",
        "Appendix A",
        "30° more",
    )
    goals = ["section 8.3", "section 5", "table 5-1", "figure 6-1", "formula 4-12", "", ""]
    assert [goal_of(text) for text in named] == goals


def document(tmp_path: Path, text: str, lang: Lang) -> pikepdf.Pdf:
    story = [
        Para(text, lang=lang),
        Heading("5 Results", 2, lang),
        DataTable(["a"], [["1"]], lang=lang, caption="Table 5-1. Extremes"),
        Formula(sym("v_B"), "(5-2)"),
    ]
    return pikepdf.open(ReportDoc(story, Metadata(title="t", lang=lang)).write(tmp_path / "a.pdf").path)


def test_a_reference_is_a_link_to_its_place_and_one_that_leads_nowhere_is_text(tmp_path: Path) -> None:
    it = document(tmp_path, "As chapter 5 says, Table 5-1 and (5-2) follow; Table 9-9 does not.", "en")
    notes = it.pages[0].Annots
    assert [str(note.Contents) for note in notes] == ["chapter 5", "Table 5-1", "(5-2)"]
    tops = [float(note.Dest[3]) for note in notes]
    text = float(notes[0].Rect[1])
    assert text > tops[0] > tops[1] > tops[2]


def test_a_reference_that_is_broken_over_two_lines_has_a_link_on_each(tmp_path: Path) -> None:
    rows = []
    for words in range(20, 52):  # "chapter 5" is never broken, 第 5 章 may be
        it = document(tmp_path, f"{'字' * words}第 5 章指出，该机构有确定的运动", "zh")
        rows.append(len({float(note.Rect[1]) for note in it.pages[0].Annots}))
        assert rows[-1] == len(it.pages[0].Annots)
    assert set(rows) == {1, 2}
