"""Claims about formulas as they are read out, and as they are copied."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.drawn_library import drawn
from vecpoly.algebra.formula import Frac, Node, Over, Power, Root, Row, Sym, Txt, Vec, row
from vecpoly.board.construction import View
from vecpoly.report.plates.shown import shown
from vecpoly.tagging.copied import copied
from vecpoly.tagging.speech import equation_said, said, spoken, words_said
from vecpoly.tagging.units_said import unit_said

LAW = Row((Sym("ω", "2"), Txt(" = "), Frac(Row((Sym("μ", "v"), Txt(" "), Over(row("bc")))), Sym("l", "BC"))))


@pytest.mark.parametrize(
    ("text", "zh", "en"),
    [
        ("v_{C2B}", "v 下标 C 2 B", "v sub C 2 B"),
        ("a^n_CB", "a 上标 n 下标 C B", "a super n sub C B"),
        ("ω_1^2 l_AB", "欧米伽 下标 1 的平方 l 下标 A B", "omega sub 1 squared l sub A B"),
        ("φ_1 = −45°", "斐 下标 1 等于 负 45 度", "phi sub 1 equals minus 45 degrees"),
        ("μ_a = 0.03 (m/s^2)/mm", "缪 下标 a 等于 0.03 米每二次方秒每毫米",
         "mu sub a equals 0.03 metres per second squared per millimetre"),
        ("M = 64.26 N·m", "M 等于 64.26 牛米", "M equals 64.26 newton metres"),
        ("μ_J = 4×10^{-6} kg·m", "缪 下标 J 等于 4 乘 10 的负 6 次方 千克米",
         "mu sub J equals 4 times 10 to the power of minus 6 kilogram metres"),
        ("(ω_i/ω)^2", "( 欧米伽 下标 i 除以 欧米伽 ) 的平方", "( omega sub i over omega ) squared"),
        ("m_5 g", "m 下标 5 g", "m sub 5 g"),
        ("pb ⊥ AB", "p b 垂直于 A B", "p b perpendicular to A B"),
    ],
)  # fmt: skip
def test_a_formula_is_read_out_in_words(text: str, zh: str, en: str) -> None:
    assert (spoken(text, "zh"), spoken(text, "en")) == (zh, en)


def test_a_fraction_says_where_it_begins_and_ends() -> None:
    assert said(LAW, "en") == "omega sub 2 equals the fraction mu sub v the length b c over l sub B C end"
    assert said(Frac(Txt("1"), Txt("2")), "zh") == "分子为 1 分数线，分母为 2"


def test_an_equation_is_followed_by_what_is_known_of_its_terms() -> None:
    told = equation_said(("v_C", "v_B"), ("", "="), (("∥导路", "⊥$AB$"), ("?", "")), "zh")
    assert told == "v 下标 C 等于 v 下标 B. 方向: v 下标 C: 平行于 导路; v 下标 B: 垂直于 A B. 大小: v 下标 C: 未知"


def test_what_is_no_unit_is_not_read_as_one() -> None:
    assert unit_said("kg·m²", "en") == "kilogram metres squared" and unit_said("rad/s", "zh") == "弧度每秒"
    assert unit_said("xyz", "en") is None and unit_said("m/q", "zh") is None


def test_a_formula_is_copied_with_the_brackets_that_it_needs() -> None:
    assert copied(LAW) == "ω_2 = (μ_v bc)/l_BC"
    assert copied(Frac(Txt("0.3"), Txt("0.006"))) == "0.3/0.006" and copied(Root(Sym("x"))) == "√x"
    assert copied(Sym("b", "2", "′")) == "b′_2"


def nodes() -> st.SearchStrategy[Node]:
    subs, sups = st.sampled_from(["", "B", "C2"]), st.sampled_from(["", "n", "2"])
    symbols = st.builds(Sym, st.sampled_from("avωμφ"), subs, sups)
    leaves = symbols | st.sampled_from(["1", " = ", " + ", "0.5 m/s"]).map(Txt) | symbols.map(Vec)
    return st.recursive(
        leaves,
        lambda inner: (
            st.builds(Frac, inner, inner)
            | inner.map(Root)
            | inner.map(Over)
            | st.builds(Power, inner, st.sampled_from(["2", "n"]))
            | st.lists(inner, min_size=1, max_size=3).map(lambda items: Row(tuple(items)))
        ),
        max_leaves=8,
    )


@given(nodes())
def test_every_formula_is_said_in_its_own_language_without_a_sign(node: Node) -> None:
    zh, en = said(node, "zh"), said(node, "en")
    assert en.isascii() and zh and not set("=+/^_√ωμφ") & set(zh + en) and "  " not in zh + en


def test_words_in_a_subscript_and_a_question_are_read_as_words() -> None:
    assert spoken("ω_{max}", "en") == "omega sub max" and spoken("W_{bII}", "zh") == "W 下标 b II"
    assert words_said("Is it undercut? $x$ = ?", "en") == "Is it undercut? x = unknown"


def test_a_figure_is_told_with_the_letters_of_its_points_as_they_are_read_out() -> None:
    figure = drawn("3-9").construction.figure(View.VELOCITY)
    assert figure is not None
    assert shown(figure, "en").endswith("points: b, p, c sub 2, d, e")
    assert shown(figure, "zh").endswith("点：b、p、c 下标 2、d、e")
