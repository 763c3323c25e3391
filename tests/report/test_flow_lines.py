"""Claims about lines, and what is set on them."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.texts import ZH, equation
from vecpoly.algebra.formula import Row, Txt, row, sym
from vecpoly.report.flow import DataTable, EquationFlow, Para
from vecpoly.report.flow.cells import NO_END, NO_START, Cell, Kind, cells, gap
from vecpoly.report.flow.formula import lines as formula_lines
from vecpoly.report.flow.lines import fit
from vecpoly.report.flow.results.grid import sentence
from vecpoly.report.flow.text.breaks import Line, break_lines
from vecpoly.typeset.box import MM, Glyphs

EM = 10.5 / MM


PIECES = st.sampled_from(
    [*"构件的速度，。（）、“”《》；", "AB", " $v_B$ ", "$ω_1 = 3$", "word ", "——", "12.5 mm", "(a)"]
)


@settings(max_examples=often(150))
@given(st.lists(PIECES, min_size=1, max_size=150), st.floats(30.0, 120.0))
def test_no_line_starts_or_ends_with_what_may_not(pieces: list[str], width: float) -> None:
    found = cells("".join(pieces), EM, True)
    broken = break_lines(found, width, EM)
    assert _said(cell for line in broken for cell in line.cells) == _said(found)
    for before, after in pairwise(broken):
        runs_on = _unbreakable(before.cells) or _unbreakable((*before.cells, after.cells[0]))
        assert runs_on or after.cells[0].text not in NO_START
        assert runs_on or before.cells[-1].text not in NO_END


def _said(row: Iterable[Cell]) -> str:
    """What the cells say, whether or not a formula is cut in two."""
    return "".join(cell.source.piece if cell.source else cell.text for cell in row).replace(" ", "")


LONG = ("$F = 3n − 2p_L − p_H$", "$δ = (ω_max − ω_min) / |ω_m| = 1.66$", "$φ$ = 191.5°", "（$l_AB + l_BC = l_AD$）")


@settings(max_examples=often(40))
@given(st.integers(40, 120), st.sampled_from(LONG))
def test_a_formula_is_not_broken_and_the_lines_before_it_share_what_room_it_leaves(count: int, formula: str) -> None:
    text = "构件上各点的速度方向与其到瞬心的连线垂直故可由" * 6
    found = cells(f"{text[:count]}{formula}。{text[:60]}", EM, True)
    lines = break_lines(found, 155.0, EM)
    assert tuple(cell for line in lines for cell in line.cells) == found, "no piece is cut"
    for line in lines:
        assert line.last or 0.0 < fit(line, 155.0, "justify").unit + 1e-9 < 0.14 * EM


def test_a_line_before_a_formula_goes_on_behind_it_and_not_within() -> None:
    text = "其中一处把自由度公式印成一个等式如下所示的式子，由此可知"
    for formula in ("$F = 3n − 2p_L − p_H$", "$l_CE$ = 65 mm", "$C$ = (46 mm, 9 mm)", "$ω_1$ 逆时针"):
        told = [_line_text(line) for line in break_lines(cells(f"{text}{formula}。{text}", EM, True), EM * 30, EM)]
        plain_ = formula.replace("$", "").replace(" ", "")
        assert sum(plain_ in one for one in told) == 1, told


def _line_text(line: Line) -> str:
    return _said(line.cells)


def test_a_long_formula_is_cut_behind_a_sign_where_one_line_would_have_to_be_stretched_far() -> None:
    text = "由此可知，自由度为"
    formula = "$F = 3n − 2p_L − p_H + F_local − p_redundant + 3n − 2p_L − p_H$"
    first, *_ = break_lines(cells(f"{text}{formula}。", EM, True), EM * 24, EM)
    ends = first.cells[-1].source
    assert ends is not None and ends.piece.endswith(("=", "−", "+"))


def test_no_character_stands_alone_in_the_last_line() -> None:
    text = "构件上各点的速度方向与其到瞬心的连线垂直故可由各项"
    for room in range(6, 24):
        *_, last = break_lines(cells(f"{text}。", EM, True), room * EM + 0.1, EM)
        assert sum(cell.kind is Kind.HAN for cell in last.cells) > 1


def _unbreakable(row: tuple[Cell, ...]) -> bool:
    """A line of nothing but marks offers no better place."""
    return not any(gap(a, b, EM).breakable for a, b in pairwise(row))


@settings(max_examples=often(100))
@given(st.integers(20, 150), st.floats(60.0, 170.0))
def test_lines_fill_the_measure_and_never_exceed_it(count: int, width: float) -> None:
    for line in break_lines(cells((ZH * 3)[:count].replace("$", ""), EM, True), width, EM, 2 * EM):
        setting = fit(line, width, "justify")
        added = sum(g.stretch * setting.unit for g in line.gaps)
        removed = sum(g.width * setting.shrink for g in line.gaps if g.stretch > 1.0)
        total = line.indent + line.width + added - removed
        assert total <= width + 1e-6
        loose = setting.unit == 0.0 and sum(g.stretch for g in line.gaps) * 0.1 * EM < width - total
        assert line.last or loose or total == pytest.approx(width)


def test_bold_is_set_in_hei() -> None:
    (bold,) = [c for c in cells("由**极**点", EM, True) if c.text == "极"]
    assert bold.box.items[0].font == "VPHeiBold"  # type: ignore[union-attr]


def test_neighbouring_punctuation_is_drawn_together() -> None:
    apart = break_lines(cells("图）图。", EM, True), 100, EM)[0].width
    close = break_lines(cells("图图）。", EM, True), 100, EM)[0].width
    assert close < apart - 0.3 * EM


def test_a_word_wider_than_the_line_is_cut() -> None:
    para = Para("x" * 500, None, "en")
    para.wrap(300, 1000)
    assert all(line.width <= 300 / MM + 1e-6 for line in para.lines(300)) and len(para.lines(300)) > 5


def test_a_long_inline_formula_breaks_after_its_equality_sign() -> None:
    kinds = [c.kind for c in cells("$v_C = μ_v pc = 0.01 × 31.9 + 0.02 × 47.3$", EM, True)]
    assert kinds == [Kind.FORMULA] * 3


def test_a_wide_formula_breaks_before_equality_signs() -> None:
    term = (sym("ω_3"), Txt(" + 12.5"))
    node = Row((*term, *(Txt(" = "), *term) * 11))
    broken = formula_lines(node, EM, 100.0)
    assert len(broken) > 1
    assert all(x + box.width <= 100.0 for x, box in broken)
    assert all(box.items[0].text == "=" for _, box in broken[1:])  # type: ignore[union-attr]


def test_a_wide_equation_stays_inside_the_column() -> None:
    for terms in (3, 8, 14):
        grid = EquationFlow(equation(terms)).set_in(160 * MM)
        for group in grid.groups:
            assert grid.margin + sum(c.sign.width + c.width for c in group) <= 160.0


def test_a_wide_table_fits_the_column() -> None:
    table = DataTable(("a", "b"), [("x", "很长的文字" * 60)])
    assert sum(table.set_in(400).widths) <= 400 / MM + 1e-6


def test_the_exponent_of_a_unit_is_raised_in_running_text() -> None:
    (_, unit) = cells("3.5 m/s^2", EM, True)
    assert [(item.text, item.y > 0) for item in unit.box.items] == [("m/s", False), ("2", True)]  # type: ignore[union-attr]


def test_a_long_address_breaks_after_a_stroke() -> None:
    para = Para("见 https://example.com/a/long/address/that/goes/on/and/on/index.html 一文", None, "zh")
    first, *_ = para.lines(200)
    assert len(para.lines(200)) > 1 and first.cells[-1].text.endswith("/")


@settings(max_examples=often(50))
@given(st.lists(st.text("abcdefgh", min_size=1, max_size=9), min_size=5, max_size=60), st.floats(40.0, 120.0))
def test_a_sentence_in_the_box_of_answers_stays_within_its_frame(words: list[str], room: float) -> None:
    assert max(box.width for box in sentence(" ".join(words), EM, room, False)) <= room + 1e-6


@pytest.mark.parametrize("width", [25.0, 40.0, 60.0])
def test_a_sum_without_a_relation_is_broken_before_its_signs(width: float) -> None:
    broken = formula_lines(row(" + ".join("ABCDEFGHIJKLMN")), EM, width)
    first, *later = ("".join(one.text for one in box.items if isinstance(one, Glyphs)) for _, box in broken)
    assert later and first.startswith("A") and all(line.startswith("+") for line in later)
