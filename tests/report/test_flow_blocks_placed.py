"""Claims about where the parts of a table, a heading, a list, a cover stand."""

from __future__ import annotations

import pytest

from tests.set_blocks import Paper, pairs, paper_of, remembered
from tests.texts import ZH, equation
from vecpoly.algebra.formula import Row, Txt, sym
from vecpoly.drawing.style import LETTER
from vecpoly.report.flow import Callout, DataTable, Divider, Drawing, EquationFlow, Formula, Para, TitleBlock, numbered
from vecpoly.report.flow.base import Tightness
from vecpoly.report.flow.contents import Contents, Entry, page_form
from vecpoly.report.flow.cover import Cover
from vecpoly.report.flow.equation import CAPTIONS
from vecpoly.report.flow.listing import Listing
from vecpoly.report.flow.style import BODY, CAPTION, GREY
from vecpoly.report.plates.sketch import LETTERED
from vecpoly.typeset.box import MM
from vecpoly.words import Lang


def table(count: int, caption: str = "") -> DataTable:
    """Three columns of 30, 40 and 50 mm: left, centred, right."""
    return DataTable(
        ("A", "B", "C"),
        [(f"l{i}", f"m{i}", f"r{i}") for i in range(count)],
        (30, 40, 50),
        "lcr",
        lang="en",
        caption=caption,
    )


def test_a_table_stands_in_the_middle_and_aligns_each_column_as_it_is_told() -> None:
    paper = paper_of(table(3), 160 * MM)
    for i in range(3):
        assert paper.piece(f"l{i}").x == pytest.approx((20 + 1.5) * MM)
        assert paper.piece(f"m{i}").middle == pytest.approx((20 + 30 + 20) * MM)
        assert paper.piece(f"r{i}").right == pytest.approx((140 - 1.5) * MM)
    assert paper.piece("A").x == pytest.approx((20 + 1.5) * MM), "over words their head begins where they do"
    assert [paper.piece(letter).middle / MM for letter in "BC"] == pytest.approx([20 + 50, 20 + 95])


def test_a_table_has_two_heavy_rules_about_it_and_a_fine_one_under_its_header() -> None:
    block = table(3)
    paper = paper_of(block, 160 * MM)
    top, fine, bottom = sorted(paper.rules, key=lambda rule: -rule[1])
    assert all(rule[0] == pytest.approx(20 * MM) and rule[2] == pytest.approx(120 * MM) for rule in paper.rules)
    assert top[3] == bottom[3] == 2 * fine[3]
    assert top[1] + top[3] == pytest.approx(block.height) and bottom[1] == pytest.approx(0.0)
    header, *rows = paper.lines()
    assert fine[1] < header < top[1] and all(bottom[1] + bottom[3] < row < fine[1] for row in rows)


def test_rows_of_a_table_are_equally_far_apart_and_their_text_is_between_their_edges() -> None:
    paper = paper_of(table(4), 160 * MM)
    assert len(paper.lines()) == 5
    assert [*pairs(paper.lines()[1:])] == pytest.approx([13 + 3.2] * 3)
    (_, y, _, _) = min(paper.rules, key=lambda rule: rule[1] if rule[3] < 0.6 else 1e9)
    assert 0.25 * 16.2 < y - paper.lines()[1] < 0.8 * 16.2


def test_the_caption_of_a_table_stands_over_it_in_the_middle_and_takes_its_room() -> None:
    bare, titled = table(3), table(3, "Table 7")
    paper, other = paper_of(titled, 160 * MM), paper_of(bare, 160 * MM)
    title = paper.piece("Table")
    assert (title.x + paper.piece("7").right if title.text == "Table" else 2 * title.middle) == pytest.approx(160 * MM)
    assert title.y > max(rule[1] for rule in paper.rules)
    assert titled.height == pytest.approx(bare.height + 15.0)
    assert [rule[1] for rule in paper.rules] == pytest.approx([rule[1] for rule in other.rules])


def test_a_cell_of_two_lines_makes_its_row_higher_and_its_neighbours_stand_in_the_middle() -> None:
    block = DataTable(("A", "B"), [("one two three four five six seven", "x")], (30, 30), "ll", lang="en")
    paper = paper_of(block, 160 * MM)
    long = sorted({round(piece.y, 3) for piece in paper.texts if piece.text not in ("A", "B", "x")}, reverse=True)
    (x,) = (piece for piece in paper.texts if piece.text == "x")
    assert len(long) > 1
    assert x.y == pytest.approx((long[0] + long[-1]) / 2, abs=0.01)
    one = DataTable(("A", "B"), [("one", "x")], (30, 30), "ll", lang="en")
    one.wrap(160 * MM, 1000)
    assert block.height - one.height == pytest.approx((len(long) - 1) * 13.0)


def test_narrow_columns_keep_their_width_and_wide_ones_share_what_is_left() -> None:
    wide = DataTable(("a", "b", "c"), [("x", "word " * 60, "word " * 30)], lang="en")
    alone = DataTable(("a",), [("x",)], lang="en")
    narrow, long, half = wide.set_in(100 * MM).widths
    assert narrow == pytest.approx(alone.set_in(100 * MM).widths[0])
    assert narrow + long + half == pytest.approx(100.0)
    assert long / half == pytest.approx(2.0, rel=0.05)


def test_a_wide_column_is_as_wide_as_its_longest_word_where_others_can_give_way() -> None:
    """best-gamma in English: a type of one word ran into the column beside it."""
    word, many = "crank-rocker-with-a-slotted-lever", ("word " * 60).strip()
    long = DataTable(("b",), [(word,)], lang="en").set_in(100 * MM).widths[0]
    crowded = DataTable(("a", "b", "c"), [(many, word, many)], lang="en").set_in(100 * MM).widths
    assert long > 100 / 3 and crowded[1] == pytest.approx(long) and sum(crowded) == pytest.approx(100.0)
    none = DataTable(("a", "b"), [(word * 2, word * 2)], lang="en").set_in(60 * MM).widths
    assert sum(none) == pytest.approx(60.0)


@pytest.mark.parametrize(("whole", "least"), [(False, 3), (True, 4)])
@pytest.mark.parametrize("height", range(20, 600, 30))
def test_a_page_break_leaves_enough_rows_of_a_table_on_both_pages(whole: bool, least: int, height: int) -> None:
    block = table(30, "Table 7")
    block.whole = whole
    parts = [part for part in block.split(160 * MM, height) if isinstance(part, DataTable)]
    block.wrap(160 * MM, 1000)
    fits = int((height - (block.height - 30 * 16.2)) / 16.2 + 1e-9)  # rows beside caption, header and rules
    assert [len(part.rows) for part in parts] == ([min(fits, 27), 30 - min(fits, 27)] if fits >= least else [])
    if parts:
        head, tail = parts
        assert (
            head.rows + tail.rows == block.rows
            and head.header == tail.header == block.header
            and head.align == tail.align
        )
        assert (head.caption, tail.caption) == ("Table 7", "")
        assert (head.spaceBefore, head.spaceAfter, tail.spaceBefore, tail.spaceAfter) == (
            block.spaceBefore,
            0.0,
            0.0,
            block.spaceAfter,
        )


def test_a_chinese_paragraph_begins_two_em_in_and_an_english_one_at_the_edge() -> None:
    cases: tuple[tuple[Lang, str, float], ...] = (
        ("zh", "构件的速度" * 30, 2 * 10.5),
        ("en", "the velocity of a link " * 12, 0.0),
    )
    for lang, text, first in cases:
        paper = paper_of(Para(text, lang=lang), 300)
        top, *rest = paper.lines()
        starts = {line: min(piece.x for piece in paper.texts if round(piece.y, 3) == line) for line in paper.lines()}
        assert starts[top] == pytest.approx(first)
        assert rest and [starts[line] for line in rest] == pytest.approx([0.0] * len(rest))
        assert [*pairs(paper.lines())] == pytest.approx([17.0 if lang == "zh" else 15.0] * len(rest))


def test_lines_of_a_paragraph_end_at_the_edge_but_for_the_last() -> None:
    paper = paper_of(Para(ZH.replace("$", "").replace("*", ""), lang="zh"), 300)
    ends = [max(piece.right for piece in paper.texts if round(piece.y, 3) == line) for line in paper.lines()]
    assert len(ends) > 3
    assert all(295.0 < end < 305.5 for end in ends[:-1])  # a mark that ends a line may hang over by half an em
    assert ends[-1] < 300.5


def test_a_number_hangs_before_its_paragraph() -> None:
    paper = paper_of(numbered("7.", "word " * 60, "en"), 300)
    label, body = paper.piece("7."), [piece for piece in paper.texts if piece.text != "7."]
    assert min(piece.x for piece in body) == pytest.approx(2 * 10.5)
    assert label.right == pytest.approx(2 * 10.5 - 0.5 * 10.5) and label.y == pytest.approx(paper.lines()[0])


def test_a_tall_formula_pushes_the_lines_of_its_paragraph_apart() -> None:
    plain, tall = (
        Para("word " * 40, lang="en"),
        Para("word " * 20 + "$\\frac{a_{B_2}^2}{b^2}$ " + "word " * 20, lang="en"),
    )
    gaps = [max(pairs(paper_of(para, 300).lines()), default=0.0) for para in (plain, tall)]
    assert gaps[0] == pytest.approx(15.0)
    assert tall.height >= plain.height


def test_a_paragraph_leaves_two_lines_on_each_page() -> None:
    para = Para("构件" * 150, lang="zh", label="1.")
    count = len(para.lines(300))
    assert count >= 6
    for height in range(0, 17 * count, 8):
        parts = para.split(300, height)
        fits = int(height / 17)
        if fits < 2:
            assert parts == []
            continue
        head, tail = parts
        assert isinstance(head, Para) and isinstance(tail, Para)
        assert [len(head.lines(300)), len(tail.lines(300))] == [min(fits, count - 2), count - min(fits, count - 2)]
        assert [*head.lines(300), *tail.lines(300)] == para.lines(300)
        assert (head.spaceBefore, head.spaceAfter, tail.spaceBefore, tail.spaceAfter) == (
            para.spaceBefore,
            0.0,
            0.0,
            para.spaceAfter,
        )
        assert "1." in {piece.text for piece in paper_of(head, 300).texts} and "1." not in {
            piece.text for piece in paper_of(tail, 300).texts
        }


def test_the_rows_of_an_equation_stand_under_each_other_with_their_captions_before_them() -> None:
    for lang in ("zh", "en"):
        flow = EquationFlow(equation(3), lang)
        paper = paper_of(flow, 160 * MM)
        first, second = (paper.piece(caption.of(lang)) for caption in CAPTIONS)
        assert first.x == second.x and first.y > second.y
        guide, question = paper.piece("导路" if lang == "zh" else "guide"), paper.piece("?")
        assert (guide.y, question.y) == pytest.approx((first.y, second.y))
        assert min(piece.x for piece in paper.texts) == first.x
        assert first.x + max(piece.right for piece in paper.texts) == pytest.approx(160 * MM, abs=0.3 * 10.5)
        assert second.y > 0 and max(piece.y for piece in paper.texts) < flow.height


def test_an_equation_that_is_too_wide_is_set_smaller_before_it_is_broken() -> None:
    sizes, groups = [], []
    for width in (160, 120, 100, 60, 40):
        grid = EquationFlow(equation(5)).set_in(width * MM)
        sizes.append(grid.em * MM)
        groups.append(len(grid.groups))
    assert sizes[0] == 10.5 and sizes == sorted(sizes, reverse=True) and min(sizes) >= 0.75 * 10.5 * 0.9
    assert groups[0] == 1 and groups == sorted(groups) and groups[-1] > 1
    assert all(size < 0.8 * 10.5 for size, count in zip(sizes, groups, strict=True) if count > 1)


def test_the_groups_of_a_broken_equation_lie_apart_and_inside_its_height() -> None:
    flow = EquationFlow(equation(8))
    paper = paper_of(flow, 60 * MM)
    directions = [piece.y for piece in paper.texts if piece.text == "方向"]
    magnitudes = [piece.y for piece in paper.texts if piece.text == "大小"]
    assert len(directions) > 1
    tops = [*pairs(directions)]
    assert all(gap > 1.3 * (a - b) for gap, a, b in zip(tops, directions, magnitudes, strict=False))
    assert min(magnitudes) > 0.0 and min(magnitudes) < 10.5


def test_a_formula_stands_in_the_middle_and_its_number_at_the_edge_beside_its_last_line() -> None:
    term = (sym("ω_3"), Txt(" + 12.5"))
    short, long = Formula(Row(term), "(3)"), Formula(Row((*term, *(Txt(" = "), *term) * 11)), "(3)")
    for flow in (short, long):
        paper = paper_of(flow, 120 * MM)
        number = paper.piece("(3)")
        inside = [piece for piece in paper.texts if piece is not number]
        assert number.right == pytest.approx(120 * MM)
        assert number.y == pytest.approx(min(piece.y for piece in inside if piece.size > 10), abs=1e-6)
        assert min(piece.x for piece in inside) + max(piece.right for piece in inside) == pytest.approx(
            120 * MM, abs=1.0
        )
        assert max(piece.right for piece in inside) < number.x
        assert number.y >= 0.0 and flow.height > max(piece.y for piece in inside)
    lines = {round(piece.y, 3) for piece in paper_of(long, 120 * MM).texts if piece.text == "="}
    assert len(lines) > 1 and long.height > len(lines) * short.height


def test_the_lines_of_the_contents_lead_to_their_pages() -> None:
    entries = [Entry("One", 2, "h1"), Entry("Part", 3, "h2"), Entry("Two", 2, "h3")]
    block = Contents("en", entries)
    paper = paper_of(block, 400)
    one, part, two = (paper.piece(entry.text) for entry in entries)
    assert (one.x, part.x, two.x) == (0.0, 16.0, 0.0) and one.size > part.size
    assert [*pairs([one.y, part.y, two.y])] == pytest.approx([15.5, 19.0]) and block.height == pytest.approx(53.5)
    assert paper.called("doForm") == [(page_form(entry.key),) for entry in entries]
    assert paper.called("translate") == [(400, piece.y) for piece in (one, part, two)]
    for (x0, y0, x1, y1), text in zip(paper.called("line"), (one, part, two), strict=True):
        assert text.right < x0 <= text.right + 5 + 3 and x1 == 400 - 22 and y0 == y1 and 0 < y0 - text.y < 3
        assert (x1 - x0) % 3 == pytest.approx(0, abs=1e-6) or (x1 - x0) % 3 == pytest.approx(3, abs=1e-6)
    for (key, (x0, y0, x1, y1), said, _), text, entry in zip(
        paper.called("link"), (one, part, two), entries, strict=True
    ):
        assert (key, said) == (entry.key, entry.text) and (x0, x1) == (0.0, 400) and y0 < text.y < y1 and y1 - y0 < 15.5


def test_a_heading_as_wide_as_the_column_has_no_leader() -> None:
    assert paper_of(Contents("en", [Entry("word " * 30, 2, "h1")]), 400).called("line") == []


@pytest.mark.parametrize("height", [0, 18, 19, 40, 76, 95, 200])
def test_contents_are_cut_between_entries(height: float) -> None:
    entries = [Entry(str(i), 2, f"h{i}") for i in range(5)]
    parts = Contents("en", entries).split(400, height)
    fits = int(height / 19)
    assert [len(part.entries) for part in parts if isinstance(part, Contents)] == (
        [fits, 5 - fits] if 0 < fits < 5 else []
    )
    assert [entry for part in parts if isinstance(part, Contents) for entry in part.entries] == (
        entries if parts else []
    )


def cover(
    title: str = "Report", fields: tuple[tuple[str, str], ...] = (("Name", "Wu"), ("Class", ""), ("Date", "May"))
) -> Paper:
    with remembered() as paper:
        Cover("Course", title, "Shaper", fields, None)._page(paper, 0.0, 0.0)
    return paper


def test_the_words_of_a_cover_stand_in_the_middle_of_the_page_title_over_subtitle() -> None:
    paper = cover()
    kind, title, subtitle = (paper.piece(word) for word in ("Course", "Report", "Shaper"))
    assert [piece.middle / MM for piece in (kind, title, subtitle)] == pytest.approx([105.0] * 3)
    assert kind.y > title.y > subtitle.y > 148.5 * MM and title.size > kind.size > subtitle.size
    assert cover("a long title " * 12).piece("title").size < title.size
    long = cover("W" * 80).piece("WW")
    assert long.right - long.x == pytest.approx(136 * MM, rel=1e-3) and long.middle == pytest.approx(105 * MM, rel=1e-3)


def test_the_fields_of_a_cover_stand_on_rules_of_one_length_in_their_order() -> None:
    paper = cover()
    rules = [rule for rule in paper.rules if rule[1] < 148 * MM]
    labels = [paper.piece(word) for word in ("Name", "Class", "Date")]
    assert {(round(rule[0], 3), round(rule[2], 3)) for rule in rules} == {
        (round((105 - 46 + 30) * MM, 3), round(62 * MM, 3))
    }
    assert [*pairs([label.y for label in labels])] == pytest.approx([9.5 * MM] * 2) and labels[-1].y == pytest.approx(
        34 * MM
    )
    assert [label.right for label in labels] == pytest.approx([(105 - 46 + 24) * MM] * 3)
    assert (
        paper.piece("Wu").middle
        == pytest.approx(paper.piece("May").middle)
        == pytest.approx(rules[0][0] + rules[0][2] / 2)
    )
    assert paper.piece("Wu").y == labels[0].y and all(
        label.y - rule[1] == pytest.approx(1.6 * MM) for label, rule in zip(labels, rules, strict=True)
    )
    heads = [rule for rule in paper.rules if rule[1] > 148 * MM]
    assert len(heads) == 2 and all(rule[0] + rule[2] / 2 == pytest.approx(105 * MM) for rule in heads)
    filled = cover(fields=(("Name", "W" * 60),)).piece("WW")
    assert filled.right - filled.x <= 62 * MM + 1e-6


def test_the_figure_of_a_cover_stands_in_the_middle_between_title_and_blanks() -> None:
    where = list[tuple[float, float]]()
    figure = Drawing(80, 60, lambda _, x, y: where.append((x, y)))
    with remembered() as paper:
        Cover("Course", "W" * 80, "", (("Name", ""), ("Class", "")), figure)._page(paper, 0.0, 0.0)
    lowest = min(rule[1] for rule in paper.rules if rule[1] > 148 * MM)
    uppermost = max(rule[1] for rule in paper.rules if rule[1] < 148 * MM) + (1.6 + 8.0) * MM
    assert where == [pytest.approx(((105 - 40) * MM, (lowest + uppermost) / 2 - 30 * MM))]
    assert all(rule[2] >= piece.right - piece.x for rule in paper.rules[:2] for piece in paper.texts[:3])


def test_a_listing_numbers_its_lines_and_folds_long_ones_at_a_blank() -> None:
    text = "id: x\nlinks:\n  1: {AB: 30 mm} # " + "word " * 40 + "end\n"
    block = Listing(text)
    paper = paper_of(block, 400)
    numbers = [piece for piece in paper.texts if piece.x < 22 - 5]
    assert [piece.text for piece in numbers] == ["1", "2", "3"] and len(
        {round(piece.right, 3) for piece in numbers}
    ) == 1
    body = [piece for piece in paper.texts if piece.x >= 22]
    assert all(piece.x == 22 and piece.right <= 400 for piece in body)
    assert [*pairs([piece.y for piece in body])] == pytest.approx([11.2] * (len(body) - 1)) and len(body) > 4
    assert all(piece.text.startswith("    ") for piece in body[3:]), (
        "the rest of a line stands two further in than the line"
    )
    assert [piece.text for piece in body[:2]] == ["id: x", "links:"]
    assert (
        "".join(piece.text if i == 0 else piece.text.removeprefix("    ") for i, piece in enumerate(body[2:]))
        == text.splitlines()[2]
    )
    assert all(piece.text.endswith(" ") for piece in body[2:-1])
    assert body[-1].y > 0 and body[0].y < block.height and block.height == pytest.approx(11.2 * len(body) + 4)
    assert [rule[0] for rule in paper.rules] == [17.0] and paper.rules[0][3] == block.height


@pytest.mark.parametrize("height", [0, 30, 38, 60, 100, 110, 200])
def test_a_listing_leaves_three_lines_on_each_page(height: float) -> None:
    lines = [f"key{i}: value" for i in range(60)]
    parts = Listing("\n".join(lines)).split(400, height)
    fits = min(int((height - Listing("line").getSpaceBefore() - 4) / 11.2), 57)  # the part on the next page asks for it
    assert [len(part._lines) for part in parts if isinstance(part, Listing)] == ([fits, 60 - fits] if fits >= 3 else [])
    assert [text for part in parts if isinstance(part, Listing) for _, text in part._lines] == (lines if parts else [])


def test_a_listing_for_which_a_page_has_room_is_parted_only_where_it_would_leave_a_gap() -> None:
    listing = Listing("\n".join(f"key{i}: value" for i in range(50)))
    assert listing.split(400, 200) == [] and len(listing.split(400, 300)) == 2


def test_chinese_letters_take_more_of_a_folded_line() -> None:
    block = Listing("字" * 100)
    paper = paper_of(block, 400)
    ends = [
        max(piece.right for piece in paper.texts if piece.y == y)
        for y in sorted({piece.y for piece in paper.texts}, reverse=True)
    ]
    assert len(ends) > 2 and all(380 < end <= 400 for end in ends[:-1])


def test_blanks_of_a_title_block_are_ruled_and_values_stand_behind_their_labels() -> None:
    block = TitleBlock([("Class", "M1"), ("Name", "Wu"), ("No", "7"), ("Mark", ""), ("Teacher", "Li"), ("Date", "May")])
    paper = paper_of(block, 450)
    assert block.height == pytest.approx(16 * MM)
    upper, lower = 12 * MM, 4 * MM
    for label, value, row in (
        ("Class", "M1", upper),
        ("Name", "Wu", upper),
        ("No", "7", upper),
        ("Teacher", "Li", lower),
        ("Date", "May", lower),
    ):
        assert (
            paper.piece(label).y == paper.piece(value).y
            and abs(paper.piece(label).y - row) < 5
            and paper.piece(label).right < paper.piece(value).x
        )
    columns = sorted(x0 for x0, y0, x1, y1 in paper.called("line") if x0 == x1)
    across = [(x0, x1, y0) for x0, y0, x1, y1 in paper.called("line") if y0 == y1]
    assert across == [(0.0, 450, pytest.approx(8 * MM))] and paper.called("rect") == [(0.0, 0.0, 450, block.height)]
    assert len(columns) == 5 and columns[1] == 150 and columns[3] == 300
    for edge, left, labels in (
        (columns[0], 0, ("Class", "Mark")),
        (columns[2], 150, ("Name", "Teacher")),
        (columns[4], 300, ("No", "Date")),
    ):
        widest = max(paper.piece(label).right - paper.piece(label).x for label in labels)
        assert edge - left == pytest.approx(widest + 4 * MM)
        assert all(paper.piece(label).middle == pytest.approx((left + edge) / 2) for label in labels)
    assert paper.piece("Wu").x == pytest.approx(columns[2] + 2 * MM)
    long = paper_of(TitleBlock([("Class", "W" * 60)]), 450).piece("WW")
    assert long.right <= 150 - MM + 1e-6


def test_a_verdict_has_the_colour_of_its_kind_and_its_text_within() -> None:
    grounds = {}
    for kind in ("pass", "warn", "fail", "note"):
        block = Callout("word " * 40, kind, "en")
        drawn = list[tuple[float, float]]()
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(block._para, "drawOn", lambda _, x, y, drawn=drawn: drawn.append((x, y)))
            paper = paper_of(block, 300)
        ground, bar = paper.called("setFillColorRGB")
        grounds[kind] = bar
        assert all(0.92 < part <= 1.0 for part in ground) and min(ground) < 1.0
        assert paper.called("rect") == [(0.0, 0.0, 300, block.height), (0.0, 0.0, 2.4, block.height)]
        assert [named for call, named in paper.told if call == "rect"] == [{"stroke": 0, "fill": 1}] * 2, "no edges"
        assert drawn == [(11.0, 3.5)] and block._para.width == 300 - 18 and block.height == block._para.height + 7
    assert (
        len(set(grounds.values())) == 4
        and grounds["pass"][1] > grounds["pass"][0]
        and grounds["fail"][0] > grounds["fail"][1]
    )


def test_a_figure_stands_in_the_middle_over_its_caption() -> None:
    where = list[tuple[float, float]]()
    block = Drawing(60, 40, lambda _, x, y: where.append((x, y)), caption="Figure")
    paper = paper_of(block, 100 * MM)
    assert where == [pytest.approx((20 * MM, block.height - 40 * MM))] and block.height == pytest.approx(40 * MM + 18.5)
    assert paper.piece("Figure").middle == pytest.approx(50 * MM) and 0 < paper.piece("Figure").y < 15 - 9
    bare = Drawing(60, 40, lambda *_: None)
    assert bare.wrap(100 * MM, 1000) == pytest.approx((100 * MM, 40 * MM))


def test_a_divider_is_a_grey_rule_across_the_column_and_text_is_set_in_its_own_colour() -> None:
    paper = paper_of(Divider(), 300)
    assert paper.called("rect") == [(0.0, 0.0, 300, 0.4)] and paper.called("setFillColorRGB") == [GREY]
    assert paper_of(Para("x", BODY), 300).called("setFillColorRGB") == [BODY.colour]
    assert paper_of(Para("x", BODY), 300).called("setStrokeColorRGB") == [BODY.colour]


def test_a_caption_stands_clear_of_its_drawing() -> None:
    """The hatched ground of a sketch ended a millimetre over it."""
    where: list[tuple[float, float]] = []
    block = Drawing(60, 40, lambda _, x, y: where.append((x, y)), caption="Figure")
    block.wrap(400.0, 400.0)
    assert block.height - block.size[1] - CAPTION.size >= 2.5 * MM


def test_the_letters_of_a_sketch_are_as_large_as_those_of_the_text_on_pages_closed_up_or_opened() -> None:
    sketch = Drawing(60, 40, lambda *_: None, sketch=True)
    for figures in (0.7, 1.0, 1.45):
        sketch.tighten(Tightness(figures=figures))
        sketch.wrap(400.0, 400.0)
        assert 9.0 <= LETTERED * LETTER * MM * sketch.height / sketch.size[1] <= 12.5
