"""Claims about the spaces between the cells of running text, the markup of templates,
and what stands at the foot and head of pages."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import pdfplumber
import pytest
from reportlab.platypus.flowables import PageBreak

from tests.set_blocks import paper_of
from vecpoly.algebra.formula import Row, Txt, Vec, sym
from vecpoly.report.flow import (
    Callout,
    DataTable,
    Divider,
    Drawing,
    Heading,
    Metadata,
    Para,
    ReportDoc,
    SheetPage,
    TitleBlock,
    to_flowables,
)
from vecpoly.report.flow.cells import AUTO, BLANK, Kind, cells, chopped, gap
from vecpoly.report.flow.contents import Contents, tell_contents
from vecpoly.report.flow.doc import _expanded, _first
from vecpoly.report.flow.equation import vector
from vecpoly.report.flow.style import CAPTION, NOTE
from vecpoly.typeset.box import MM

EM = 10.5 / MM


@pytest.mark.parametrize(
    ("text", "width", "breakable"),
    [
        ("构件", 0.0, True),
        ("构AB", AUTO * EM, True),
        ("AB构", AUTO * EM, True),
        ("构$v_B$", AUTO * EM, True),
        ("AB BC", BLANK * EM, True),
        ("AB$v_B$", 0.0, False),
        ("AB $v_B$", BLANK * EM, True),
        ("构。", 0.0, False),
        ("（构", 0.0, False),
        ("AB，", 0.0, False),
        ("（AB", 0.0, False),
        ("，AB", 0.0, True),
        ("AB（", 0.0, True),
        ("构)", 0.0, False),
        ("(构", 0.0, False),
        ("构(a", AUTO * EM, True),
    ],
)
def test_chinese_and_latin_stand_a_fifth_of_an_em_apart_and_marks_stand_close(
    text: str, width: float, breakable: bool
) -> None:
    a, b = cells(text, EM, True)
    between = gap(a, b, EM)
    assert between.width == pytest.approx(width) and between.breakable is breakable


def test_two_marks_together_lose_half_an_em_and_a_dash_is_not_torn() -> None:
    for text in ("）。", "（《", "。（"):
        a, b = cells(text, EM, True)
        assert -0.51 * EM <= gap(a, b, EM).width < -0.2 * EM
    a, b = cells("——", EM, True)
    assert gap(a, b, EM).stretch == 0.0 and not gap(a, b, EM).breakable


def test_the_pieces_of_a_formula_may_part_and_it_belongs_to_the_words_about_it() -> None:
    found = cells("因 $v_{C2B} = ω_2 l_{BC}/(μ_v k) + ω_3 l_{CD}/(μ_v k)$ 而", EM, True)
    assert [cell.kind for cell in found] == [Kind.HAN, Kind.FORMULA, Kind.FORMULA, Kind.HAN]
    assert [gap(a, b, EM).breakable for a, b in pairwise(found)] == [True, True, True]
    assert [cell.spaced for cell in cells("a b", EM, False)] == [False, True] and [
        cell.spaced for cell in cells("a $v$ b", EM, False)
    ] == [False, True, True]


def test_quotes_and_dashes_are_full_width_in_chinese_and_narrow_in_english() -> None:
    assert [cell.kind for cell in cells("“构”", EM, True)] == [Kind.OPEN, Kind.HAN, Kind.CLOSE]
    assert [cell.text for cell in cells("“a” b", EM, False)] == ["“a”", "b"]


def test_only_what_is_between_stars_is_bold() -> None:
    fonts = [cell.box.items[0].font for cell in cells("由**极**点 a **b**", EM, True)]  # type: ignore[union-attr]
    assert [("Hei" in font or "Bold" in font) for font in fonts] == [False, True, False, False, True]
    assert all("Bold" in cell.box.items[0].font for cell in cells("a b", EM, False, True))  # type: ignore[union-attr]


def test_a_long_word_is_cut_into_pieces_that_lose_nothing_and_fit() -> None:
    (word,) = cells("x" * 200, EM, False)
    parts = chopped(word, 40.0, EM, False)
    assert (
        "".join(part.text for part in parts) == "x" * 200
        and len(parts) > 3
        and all(0.5 * 40 < part.box.width <= 40 for part in parts[:-1])
    )
    assert (
        not parts[0].joined
        and all(part.joined for part in parts[1:])
        and gap(parts[0], parts[1], EM).width == 0.0
        and gap(parts[0], parts[1], EM).breakable
    )
    (short,) = cells("short", EM, False)
    assert chopped(short, 40.0, EM, False) == [short]


def test_an_english_text_is_justified_by_its_blanks_alone_and_the_last_line_is_not() -> None:
    paper = paper_of(Para("the crank turns counter clockwise and drives the coupler " * 6, lang="en"), 300)
    ends = [max(piece.right for piece in paper.texts if round(piece.y, 3) == line) for line in paper.lines()]
    assert ends[:-1] == pytest.approx([300.0] * (len(ends) - 1), abs=0.1) and ends[-1] < 299


def read(inside: str, lang: str = "en", **objects: object) -> list[Any]:
    return to_flowables(f'<doc lang="{lang}">{inside}</doc>', objects)


def test_markup_becomes_what_it_says() -> None:
    story = read(
        '<h1>A</h1><h2>B</h2><h3>C</h3><p>x</p><p keep="yes">y</p><note>n</note><caption>c</caption><callout '
        'kind="warn">w</callout><callout>v</callout><contents/><pagebreak/><rule/>'
    )
    assert [one.level for one in story[:3]] == [1, 2, 3] and all(isinstance(one, Heading) for one in story[:3])
    assert [one.keepWithNext for one in story[3:5]] == [0, 1]
    assert (story[5].style, story[6].style) == (NOTE, CAPTION) and [one.kind for one in story[7:9]] == ["warn", "note"]
    assert (
        isinstance(story[9], Contents)
        and isinstance(story[10], PageBreak)
        and isinstance(story[11], Divider)
        and isinstance(story[7], Callout)
    )
    assert {one.lang for one in story if isinstance(one, Para | Contents)} == {"en"} and read("<p>x</p>", "zh")[
        0
    ].lang == "zh"
    assert (
        to_flowables("<doc><p>x</p></doc>", {})[0].lang == "zh"
        and to_flowables('<doc lang="en"><p>x</p></doc>', {}, "zh")[0].lang == "zh"
    )


def test_steps_are_numbered_from_one_and_stay_with_what_belongs_to_them() -> None:
    table = DataTable(("a",), [("b",)])
    first, second, inside, fifth = read(
        '<steps><step>x</step><step>y<table ref="t" whole="yes"/></step><step n="5">z</step></steps>', t=table
    )
    labels = ["".join(cell.text for cell in one._label) for one in (first, second, fifth)]
    assert labels == ["1.", "2.", "5."] and [one.keepWithNext for one in (first, second, fifth)] == [0, 1, 0]
    assert inside is table and table.whole and not read('<table ref="t"/>', t=table)[0].whole


def test_blanks_of_a_title_block_and_of_a_cover_are_read_from_their_fields() -> None:
    block, cover = read(
        '<titleblock><field label="Name" value="Wu"/><field label="Class"/></titleblock><cover kind="K" '
        'title="T" subtitle="S"><field label="Name" value="Wu"/></cover>'
    )
    assert isinstance(block, TitleBlock) and block.fields == (("Name", "Wu"), ("Class", ""))
    assert (cover.kind, cover.title, cover.subtitle, cover.fields, cover.figure) == (
        "K",
        "T",
        "S",
        (("Name", "Wu"),),
        None,
    )
    figure = Drawing(1, 1, lambda *_: None)
    assert read('<cover ref="f"/>', f=figure)[0].figure is figure


def test_blanks_in_markup_are_folded_but_not_the_ideographic_one() -> None:
    assert [one.text for one in read("<p>  a \n\t b\u3000c </p>")] == ["a b\u3000c"]


def sheet(wide: bool = False) -> SheetPage:
    return SheetPage(lambda *_: None, wide=wide, title="s")


def turns(story: list[Any]) -> str:
    """B for a page break, t p l for the template that follows, x for text, s for a sheet."""
    letter = {"PageBreak": "B", "SheetPage": "s", "Para": "x"}
    return "".join(
        one.action[1][0] if hasattr(one, "action") else letter[type(one).__name__] for one in _expanded(story)
    )


def test_a_sheet_has_its_own_page_and_no_page_is_left_empty() -> None:
    text = Para("x")
    assert (
        turns([text, sheet(), text]) == "xpBstBx"
        and turns([sheet(), text]) == "pstBx"
        and turns([text, sheet(True)]) == "xlBs"
    )
    assert (
        turns([sheet(), sheet()]) == "pspBs"
        and turns([text, PageBreak(), PageBreak(), text]) == "xttBx"
        and turns([text, PageBreak()]) == "x"
    )
    assert turns([text, PageBreak(), sheet()]) == "xtpBs" and turns([]) == ""
    assert [_first(story) for story in ([text], [sheet()], [sheet(True)], [])] == [0, 1, 2, 0]


def test_contents_list_the_headings_of_two_levels_that_follow_under_the_bookmarks_of_all() -> None:
    contents, later = Contents(), Contents()
    tell_contents(
        [
            Heading("T", 1),
            Heading("Before", 2),
            contents,
            Heading("A", 2),
            sheet(),
            Heading("B $v_C$", 3),
            later,
            Heading("C", 2),
        ]
    )
    assert [(one.text, one.level, one.key) for one in contents.entries] == [
        ("A", 2, "h3"),
        ("B $v_C$", 3, "h5"),
        ("C", 2, "h6"),
    ]
    assert [one.text for one in later.entries] == ["C"]


def test_pages_have_their_title_at_the_right_edge_their_number_in_the_middle_and_the_contents_their_pages(
    tmp_path: Path,
) -> None:
    story = [Contents("en"), Heading("One", 2), Para("x", lang="en"), PageBreak(), Heading("Two", 2), sheet()]
    written = ReportDoc(
        story, Metadata(title="Shaper", author="Wu", lang="en", keywords=("a", "b"), subject="S")
    ).write(tmp_path / "a.pdf")
    with pdfplumber.open(written.path) as pdf:
        assert written.pages == len(pdf.pages) == 3 and pdf.doc.catalog["Lang"] == b"en-GB"
        assert [pdf.metadata[key] for key in ("Title", "Author", "Subject", "Keywords", "Producer", "Creator")] == [
            "Shaper",
            "Wu",
            "S",
            "a, b",
            "vecpoly",
            "vecpoly",
        ]
        for number, page in enumerate(pdf.pages, 1):
            words = page.extract_words()
            foot = [word for word in words if word["top"] > 780]
            assert " ".join(word["text"] for word in foot) == f"{number} / 3"
            assert abs((foot[0]["x0"] + foot[-1]["x1"]) / 2 - page.width / 2) < 6
            head = [word for word in words if word["text"] == "Shaper"]
            assert [round(word["x1"], 1) for word in head] == ([round(page.width - 20 * MM, 1)] if number == 2 else [])
            assert all(word["bottom"] < 20 * MM for word in head)
            assert all(char["non_stroking_color"] == (0.35, 0.35, 0.35) for char in page.chars if char["top"] > 780)
        listed = [
            word["text"]
            for word in pdf.pages[0].extract_words()
            if word["x1"] > pdf.pages[0].width - 20 * MM - 1 and word["text"] != "Shaper"
        ]
        assert listed == ["1", "2"]
    chinese = ReportDoc([Para("x")], Metadata(title="t")).write(tmp_path / "b.pdf")
    with pdfplumber.open(chinese.path) as pdf:
        assert pdf.doc.catalog["Lang"] == b"zh-CN" and pdf.metadata["Subject"] == "t"


@pytest.mark.parametrize(
    ("word", "told"), [("m/s^2", "m/s²"), ("R-24m/s^2", "R-24m/s²"), ("10^{-15}", "10⁻¹⁵"), ("mm^4", "mm⁴")]
)
def test_a_word_is_copied_with_its_exponent_alone_raised(word: str, told: str) -> None:
    (cell,) = cells(word, 3.5, chinese=False)
    assert cell.source is not None and cell.source.piece == told


def test_each_vector_of_a_bracket_has_its_arrow() -> None:
    assert vector("(v_E + v_{S3E})") == Row((Txt("("), Vec(sym("v_E")), Txt(" + "), Vec(sym("v_{S3E}")), Txt(")")))
