"""Claims about set type."""

from __future__ import annotations

import re
import subprocess
import sys
from xml.etree import ElementTree

import pytest

from vecpoly.algebra.formula import Frac, Node, Over, Power, Root, Row, Sym, Txt, Vec, adjoined, plain, row, sym
from vecpoly.report.flow.cells import Kind, cells, joined
from vecpoly.typeset import Box, Glyphs, Rule, layout, layout_words, svg_group
from vecpoly.typeset.box import MM
from vecpoly.typeset.fonts import MISSING, Face, glyph, load, missing
from vecpoly.typeset.layout import segments
from vecpoly.typeset.runs import latin

EM = 4.0


def runs(box: Box) -> list[Glyphs]:
    return [item for item in box.items if isinstance(item, Glyphs)]


def rules(box: Box) -> list[Rule]:
    return [item for item in box.items if isinstance(item, Rule)]


def text(box: Box) -> str:
    return "".join(run.text for run in runs(box))


def face_of(char: str, box: Box) -> str:
    return next(run.font for run in runs(box) if char in run.text)


def test_letters_are_italic_and_digits_upright() -> None:
    box = layout(sym("v_B3B2"), EM)
    assert [(r.text, r.font) for r in runs(box)] == [
        ("v", Face.ITALIC), ("B", Face.ITALIC), ("3", Face.STIX), ("B", Face.ITALIC), ("2", Face.STIX),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("symbol", "upright", "italic"),
    [("J_rim", "rim", "J"), ("ω_{max}", "max", "ω"), ("ρ_{a min}", "min", "a"), ("v_B3", "3", "B")],
)
def test_words_in_an_index_are_upright_and_letters_of_points_and_quantities_italic(
    symbol: str, upright: str, italic: str
) -> None:
    box = layout(sym(symbol), EM)
    assert any(run.text == upright and run.font == Face.STIX for run in runs(box))
    assert face_of(italic, box) == Face.ITALIC


@pytest.mark.parametrize(
    ("symbol", "upright", "italic"),
    [
        ("I", "I", ""),
        ("W_bII", "II", "b"),
        ("W_bI", "I", "b"),
        ("F_{I5}", "5", "I"),
        ("M_{I2}", "2", "I"),
        ("I_1", "1", "I"),
        ("W_1I", "I", "W"),
        ("m_{12I}", "I", "m"),
        ("θ_MI", "I", "M"),
        ("v_{BI}", "", "I"),
        ("v_{C2I}", "2", "I"),
    ],
)
def test_roman_numbers_are_upright_and_the_index_of_inertia_slants_beside_a_number_as_a_point_i_does(
    symbol: str, upright: str, italic: str
) -> None:
    box = layout(sym(symbol), EM)
    assert not upright or any(run.text == upright and run.font == Face.STIX for run in runs(box))
    assert not italic or face_of(italic, box) == Face.ITALIC
    assert face_of("I", layout(Sym("II", "", ""), EM)) == Face.STIX


def test_a_factor_after_a_number_is_a_quantity_and_no_unit() -> None:
    product = Row((Txt("0.5"), Txt("\u2009"), sym("m"), Txt("\u2009"), sym("v")))
    assert face_of("m", layout(product, EM)) == Face.ITALIC
    assert face_of("m", layout(row("0.5 m"), EM)) == Face.STIX


def test_letters_of_similar_triangles_stand_close_about_a_sign_of_their_size() -> None:
    together = row(f"△{adjoined('f', 's_3', 'c')} ∽ △FSC")
    apart = row("△f s_3 c ∽ △FSC")
    assert layout(together, EM).width < layout(apart, EM).width - 0.2 * EM
    assert plain(together) == "△fs_3c ∽ △FSC"
    sign = next(run for run in runs(layout(together, EM)) if run.text == "∽")
    assert sign.size > 1.2 * next(run for run in runs(layout(together, EM)) if run.text == "△").size


def test_two_primes_are_one_sign() -> None:
    assert text(layout(sym("γ''"), EM)) == "γ″"


@pytest.mark.parametrize("letter", "μωαφρθβγλvaΩΔ")
def test_greek_and_latin_symbols_are_italic(letter: str) -> None:
    assert face_of(letter, layout(Sym(letter), EM)) == Face.ITALIC


def test_pi_is_upright() -> None:
    assert face_of("π", layout(sym("π"), EM)) == Face.STIX


def test_a_greek_subscript_stands_low_as_any_other() -> None:
    assert layout(sym("μ_γ"), EM) == layout(sym("μ_{γ}"), EM)
    assert "_" not in text(layout(row("μ_ψ, μ_φ"), EM))


def test_a_prime_is_a_prime() -> None:
    assert text(layout(sym("n'"), EM)) == "n′"


def test_a_hyphen_before_a_number_is_a_minus() -> None:
    assert text(layout(Txt("-3.5"), EM)) == "−3.5"


def test_a_sign_is_tight_and_a_minus_between_terms_is_not() -> None:
    signed, binary = layout(Txt("-3"), EM), layout(Txt("2-3"), EM)
    digit = glyph("3", Face.STIX).width * EM
    assert binary.width - signed.width - digit == pytest.approx(2 * 4 / 18 * EM)


def test_scripts_are_smaller_and_stacked() -> None:
    box = layout(sym("a^n_CB"), EM)
    a, n, cb = runs(box)
    assert n.size == cb.size == pytest.approx(0.7 * a.size)
    assert n.y > 0 > cb.y and abs(n.x - cb.x) < 0.2 * EM


def test_a_squared_symbol_with_subscript_is_stacked() -> None:
    assert layout(Power(sym("ω_2"), "2"), EM) == layout(sym("ω_2^2"), EM)


def test_the_square_in_a_unit_is_raised() -> None:
    box = layout(Txt("3.2 m/s^2"), EM)
    assert text(box) == "3.2m/s2"
    assert runs(box)[-1].y > 0 and runs(box)[-1].size < runs(box)[0].size


def test_a_unit_after_a_number_is_upright_inside_dollars() -> None:
    box = layout(row("ω_1 = 10 rad/s^2"), EM)
    assert face_of("rad", box) == Face.STIX
    assert face_of("l", layout(row("2 l_AB"), EM)) == Face.ITALIC


def test_there_is_a_space_between_number_and_unit() -> None:
    number, unit = runs(layout(Txt("10 mm"), EM))
    assert unit.x - number.x == pytest.approx((1.0 + 0.2) * EM)


def test_a_fraction_bar_lies_on_the_axis() -> None:
    box = layout(Frac(Txt("1"), Txt("2")), EM)
    (bar,) = rules(box)
    minus = glyph("−", Face.STIX)
    assert (bar.y + bar.height / 2) / EM == pytest.approx((minus.top + minus.bottom) / 2, abs=0.02)


def test_nothing_in_a_fraction_touches_its_bar() -> None:
    box = layout(Frac(row("μ_v pg"), row("l_BC")), EM)
    (bar,) = rules(box)
    for item in runs(box):
        inked = [glyph(char, Face(item.font)) for char in item.text]
        size = item.size / MM
        low = item.y + min(g.bottom for g in inked) * size
        high = item.y + max(g.top for g in inked) * size
        assert low > bar.y + bar.height or high < bar.y


def test_a_length_on_paper_is_overlined_across_its_letters() -> None:
    box = layout(Over(row("pb")), EM)
    (bar,) = rules(box)
    assert bar.width == pytest.approx(layout(row("pb"), EM).width)
    assert bar.y > layout(row("pb"), EM).ascent


def test_the_arrow_of_a_vector_stands_over_the_base_only() -> None:
    box = layout(Vec(sym("v_CB")), EM)
    base, arrow, _ = runs(box)
    assert arrow.text == "\u20d7"
    mark = glyph("\u20d7", Face.STIX)
    middle = arrow.x + (mark.left + mark.right) / 2 * EM
    assert 0 < middle < layout(sym("v"), EM).width
    assert arrow.y + mark.bottom * EM > glyph("v", Face.ITALIC).top * EM
    assert base.x == 0.0


def test_a_root_covers_its_body() -> None:
    box = layout(Root(row("x^2 + y^2")), EM)
    (bar,) = rules(box)
    last = runs(box)[-1]
    assert bar.x + bar.width >= last.x + glyph("2", Face.STIX).width * last.size / MM - 1e-9


def test_a_relation_between_symbols_is_spaced_and_a_prefix_is_not() -> None:
    between, before = layout(row("pb⊥AB"), EM), layout(row("⊥AB"), EM)
    pb = layout(row("pb"), EM).width
    assert between.width - pb - before.width == pytest.approx((2 * 5 / 18 - 0.08) * EM)


def test_a_wide_formula_is_cut_before_its_equality_signs() -> None:
    assert [text(s)[0] for s in segments(row("a = b = c"), EM, before=True)] == ["a", "=", "="]


def test_brackets_grow_with_the_fraction_inside() -> None:
    plain, tall = (layout(Row((Txt("("), node, Txt(")"))), EM) for node in (Txt("1"), Frac(Txt("1"), Txt("2"))))
    assert runs(plain)[0].size < runs(tall)[0].size == runs(tall)[-1].size


def test_chinese_in_a_formula_is_set_in_song() -> None:
    assert face_of("导", layout(Txt("∥ 导路"), EM)) == Face.SONG


def test_a_rare_name_comes_from_the_extension() -> None:
    assert face_of("喆", layout_words("陈喆", EM)) == Face.SONG_EXT


def test_latin_in_chinese_text_is_stix_and_punctuation_song() -> None:
    box = layout_words("点B，见“图2”", EM)
    assert face_of("B", box) == Face.STIX
    assert face_of("，", box) == face_of("“", box) == Face.SONG
    assert face_of("“", layout_words("the “image”", EM)) == Face.STIX


def test_a_character_that_no_face_has_is_reported() -> None:
    assert missing("速度\U0001f9ffv\U0001f9ff") == ("\U0001f9ff",)
    assert face_of("\U0001f9ff", layout_words("\U0001f9ff", EM)) == MISSING
    assert "[U+1F9FF]" in svg_group(layout_words("\U0001f9ff", EM), 0, 0)


@pytest.mark.parametrize("face", list(Face))
def test_every_face_opens(face: Face) -> None:
    assert load(face).face.charToGlyph


def test_svg_is_well_formed_and_keeps_the_words() -> None:
    root = ElementTree.fromstring(svg_group(layout_words("由 $v_B < 3$ 知 a&b", EM), 10, 20))
    assert re.sub(r"\s", "", "".join(root.itertext())) == "由vB<3知a&b"


def test_matplotlib_is_not_imported() -> None:
    code = (
        "import sys; from vecpoly.typeset import layout; from vecpoly.algebra.formula import sym;"
        "layout(sym('v_B'), 4.0); assert 'matplotlib' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize(
    ("node", "tex"),
    [
        (sym("ω_2"), r"\omega_2"),
        (sym("v_CB"), r"v_{CB}"),
        (sym("a^n_CB"), r"a^n_{CB}"),
        (row("v_C = v_B + v_CB"), r"v_C = v_B + v_{CB}"),
        (row("ω_3 = -2.5"), r"\omega_3 = -2.5"),
        (Frac(sym("v_CB"), sym("l_BC")), r"\dfrac{v_{CB}}{l_{BC}}"),
        (Over(row("pb")), r"\overline{pb}"),
        (Vec(sym("v_B")), r"\vec{v}_B"),
        (Root(row("x^2 + y^2")), r"\sqrt{x^2 + y^2}"),
        (Row((sym("μ_v"), Txt(" = "), Txt("0.5"))), r"\mu_v = 0.5"),
    ],
)
def test_widths_agree_with_mathtext(node: Node, tex: str) -> None:
    from matplotlib import rc_context
    from matplotlib.font_manager import FontProperties
    from matplotlib.mathtext import MathTextParser

    with rc_context({"mathtext.fontset": "stix"}):
        parsed = MathTextParser("path").parse(f"${tex}$", dpi=72, prop=FontProperties(size=1000))
    assert layout(node, 1000 / MM).width * MM == pytest.approx(parsed[0], rel=0.15)


@pytest.mark.parametrize(
    ("typed", "set_"), [("frame's", "frame’s"), ("'s", "’s"), ("links'", "links’"), ("A'", "A'"), ("'zero'", "'zero'")]
)
def test_an_apostrophe_is_curved_and_other_signs_stay_as_typed(typed: str, set_: str) -> None:
    assert text(latin(typed, EM, False)) == set_


@pytest.mark.parametrize("text", ["80.8 N·m（顺时针，不计摩擦）", "80.8 N·m（顺时针， 不计摩擦）"])
def test_full_width_marks_in_a_formula_bring_their_own_white_and_get_no_more(text: str) -> None:
    """A comma and a bracket between Chinese characters take one em each, however they were written."""
    box = layout(row(text), 10.0)
    found = {item.text: item for item in box.items if isinstance(item, Glyphs)}
    start = min(item.x for text, item in found.items() if "顺" in text or "（" in text)
    assert box.width - start == pytest.approx(10.0 * len("（顺时针，不计摩擦）"), abs=0.1)


def test_the_number_of_a_class_is_a_chinese_character_in_running_text_and_in_a_title() -> None:
    kinds = [cell.kind for cell in cells("含 Ⅲ 级杆组", 10.0, True)]
    assert Kind.WORD not in kinds and joined(cells("含 Ⅲ 级", 10.0, True), 10.0).width == pytest.approx(30.0)
    fonts = {item.font for item in layout_words("含Ⅲ级", 10.0, True).items if isinstance(item, Glyphs)}
    assert len(fonts) == 1


@pytest.mark.parametrize("node", [Root(row("a^2 + b^2")), Frac(sym("v_B"), sym("l_AB")), Power(sym("ω_1"), "2")])
def test_a_formula_in_larger_type_is_the_same_formula_enlarged(node: Node) -> None:
    small, large = layout(node, EM), layout(node, 2.5 * EM)
    pairs = zip(small.items, large.items, strict=True)
    assert all((b.x, b.y) == pytest.approx((2.5 * a.x, 2.5 * a.y)) for a, b in pairs)
    assert (large.width, large.height) == pytest.approx((2.5 * small.width, 2.5 * small.height))


def test_in_a_picture_an_index_stands_below_its_letter_and_a_power_above() -> None:
    """y of SVG goes down the page."""
    group = ElementTree.fromstring(svg_group(layout(Power(body=sym("v_B"), exponent="2"), EM), 10.0, 20.0))
    at = {one.text: float(one.attrib["y"]) for one in group.iter("text")}
    assert at["v"] == pytest.approx(20.0) and at["B"] > 20.4 and at["2"] < 19.6
