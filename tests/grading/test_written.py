"""What people write is read in all its usual ways; what could mean two things is not guessed."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.errors import UnknownNameError
from vecpoly.grading.reading.characters import plain
from vecpoly.grading.reading.direction import Pointing, as_direction
from vecpoly.grading.reading.sense import as_sense
from vecpoly.grading.reading.symbol import keyed
from vecpoly.grading.reading.written import State, written

WIDE = str.maketrans("0123456789.-+ ", "０１２３４５６７８９．－＋　")


@pytest.mark.parametrize(
    ("text", "si"),
    [
        ("0.49", 0.49),
        ("４．７２", 4.72),
        ("≈0.49 米/秒", 0.49),
        ("0.49m·s⁻¹", 0.49),
        ("49 cm/s", 0.49),
        ("1.5×10^3 N", 1500),
        ("1.5x10³ N", 1500),
        ("1.5·10^-3", 0.0015),
        ("1.5e3", 1500),
        ("−12 rad/s²", -12),
        ("–12 rad/s2", -12),
        ("30 r/min", pi),
        ("30rpm", pi),
        ("30 转/分", pi),
        ("180°", pi),
        ("180 度", pi),
        ("2 m/s/s", 2),
        ("2 米每二次方秒", 2),
        ("64 N.m", 64),
        ("64 牛·米", 64),
        ("64 牛米", 64),
        ("2 m/sec", 2),
        ("2 m/second", 2),
        ("2 m/sec²", 2),
        ("1.5 弧度/秒", 1.5),
        ("79.5%", 0.795),
        ("3.5 1/s", 3.5),
        ("12,5", 12.5),
        ("0,123", 0.123),
        ("1,234.5", 1234.5),
        ("1.234,5", 1234.5),
        ("1,234,567", 1234567),
        ("约 3.2。", 3.2),
        ("3.2 左右", 3.2),
        ("—3.2", -3.2),
        ("1.5 KN", 1500),
        ("1.5 KN·m", 1500),
        ("1.5 KNm", 1500),
        ("2 Kg", 2),
        ("64 N-m", 64),
        ("2 m·s-2", 2),
        ("0.5m.s-1", 0.5),
        ("4.7/s", 4.7),
        ("4.7/s²", 4.7),
        ("0.0331×100", 3.31),
        ("0.331×10 1/s", 3.31),
        ("331×10^{-2} rad/s", 3.31),
        ("0.00331×103", 3.31),
        ("33.1×10⁻¹", 3.31),
    ],
)
def test_a_number_with_its_unit_is_read_however_it_is_written(text: str, si: float) -> None:
    found = written(text)
    assert found.state is State.READ and found.raw == text
    assert found.value * (found.unit.factor if found.unit else 1.0) == pytest.approx(si, rel=1e-12)


NUMBERS = ("{:.4f}", "{:.3e}", "{:.2E}", "{}×10^{}", "{}x10^{}", "{} × 10^{}", "{}*10^({})", "{}·10**{}")
SPELT = {
    1.0: ("m/s", "rad/s", "米/秒", "m·s⁻¹", "N", "牛", "kg", "/s", "m/s²", "N·m", "Nm", "弧度/秒", ""),
    1e-3: ("mm/s", "mm", "毫米", "mm/s2", "g"),
    1e3: ("kN", "kN·m", "km"),
}


@given(
    st.integers(100, 9999),
    st.sampled_from(NUMBERS),
    st.sampled_from([(factor, unit) for factor, units in SPELT.items() for unit in units]),
    st.sampled_from(["", " "]),
    st.booleans(),
)
def test_any_way_to_write_a_number_goes_with_any_way_to_write_a_unit(
    size: int, way: str, spelt: tuple[float, str], blank: str, wide: bool
) -> None:
    """2.5e+02N, without a blank, had no unit that was known."""
    value = size / 1000 if "." in way else size / 1000 * 100
    text = (way.format(value) if "." in way else way.format(size / 1000, 2)) + blank + spelt[1]
    if wide:
        text = "".join(chr(ord(one) + 0xFEE0) if "!" <= one <= "~" else one for one in text)
    found = written(text)
    assert found.state is State.READ, text
    assert found.value * (found.unit.factor if found.unit else 1.0) == pytest.approx(value * spelt[0], rel=5e-3)


@pytest.mark.parametrize(
    ("text", "sense"),
    [
        ("12 rad/s² 顺", -1),
        ("12 rad/s² 顺时针", -1),
        ("12 rad/s^2 CW", -1),
        ("12 rad/s2（逆时针）", 1),
        ("12 ccw", 1),
        ("12 ↻", -1),
        ("12↺", 1),
        ("逆 12", 1),
        ("12 counter-clockwise", 1),
        ("12 anticlockwise", 1),
        ("12 clockwise", -1),
        ("12, 方向：顺时针方向", -1),
        ("12，逆时针转动", 1),
        ("12 rad/s 顺时针方向转动", -1),
        ("12 順時針", -1),
        ("12", 0),
        ("-12 顺", -1),
    ],
)
def test_a_sense_is_read_in_words_letters_and_arrows(text: str, sense: int) -> None:
    found = written(text)
    assert (found.state, found.sense, abs(found.value)) == (State.READ, sense, 12)


@pytest.mark.parametrize(
    "text", ["3/4", "(0.75)", "0.75 ± 0.01", "η = 0.75", "v_B=0.75", "≈0,75", "7.5e-1", "0,750e0", "30/40"]
)
def test_what_leads_to_a_number_or_wraps_it_is_no_part_of_it(text: str) -> None:
    assert written(text).state is State.READ and written(text).value == pytest.approx(0.75)


@pytest.mark.parametrize(
    "cell",
    [
        "315",
        "315°",
        "∠315°",
        "≈315",
        "约 315 左右",
        "315,0",
        "3.15e2",
        "315度",
        "315°0′",
        "-45",
        "315 ± 1",
        "5.49779 rad",
        "右下",
    ],
)
def test_a_column_for_directions_takes_what_people_write_there(cell: str) -> None:
    found = written(f"0.3 {as_direction(cell)}")
    assert found.state is State.READ and found.direction is not None and found.direction.beside(315.0) < 0.01


@pytest.mark.parametrize(
    ("cell", "sense"), [("+", 1), ("-", -1), ("−", -1), ("负", -1), ("c.w.", -1), ("c.c.w.", 1), ("顺时", -1),
                        ("逆", 1), ("clock wise", -1), ("anti clockwise", 1), ("↻", -1)],
)  # fmt: skip
def test_a_column_for_senses_takes_what_people_write_there(cell: str, sense: int) -> None:
    found = written(f"2.0 {as_sense(cell)}")
    assert (found.state, found.sense, found.value) == (State.READ, sense, 2.0)


@pytest.mark.parametrize("text", ["-12 逆", "+12 rad/s² cw", "12 顺 逆"])
def test_a_sign_against_a_sense_is_ambiguous_and_not_wrong(text: str) -> None:
    assert written(text).state is State.AMBIGUOUS and written(text).why is not None


@pytest.mark.parametrize(
    "text",
    [
        "1,234",
        "12 foo",
        "0.5 m/s-1",
        "3 K",
        "abc",
        "1.2.3",
        "12.3.4 mm",
        "3/0",
        "O.49",
        "=cmd|'/c calc'!A1",
        "1 2",
        "x" * 500,
        "1,23,4",
    ],
)
def test_what_cannot_be_read_says_so_and_keeps_its_text(text: str) -> None:
    found = written(text)
    assert found.state is State.UNREADABLE and found.why is not None and found.raw == text


def test_blank_is_not_zero_and_neither_is_a_dash() -> None:
    assert [written(text).state for text in ("", "  ", None, "　")] == [State.BLANK] * 4
    assert [written(text).state for text in ("—", "-", "/", "无", "n/a")] == [State.NONE] * 5
    assert written("0").state is State.READ and written(0.0).value == 0 and written("0").digits == 0


@pytest.mark.parametrize(("text", "factor"), [("12 逆时针转", 1.0), ("12 顺转", 1.0), ("12 逆时针 转/分", pi / 30)])
def test_that_something_turns_is_no_unit_beside_its_sense(text: str, factor: float) -> None:
    """逆时针转 was a number of turns, and cost the points of a unit."""
    found = written(text)
    assert found.sense and (found.unit.factor if found.unit else 1.0) == pytest.approx(factor)


def test_a_direction_and_two_coordinates_stand_beside_a_number() -> None:
    assert written("0.49 m/s ∠ 35°").direction == Pointing(35.0)
    assert written("0.49 m/s，方向 −30.3°").direction == Pointing(-30.3)
    assert written("0.49 m/s 18.1 deg").direction == Pointing(18.1) and written("180 deg").direction is None
    assert written("(−130, 164.4) mm").at == (-130, 164.4)
    assert written("(1 mm, 2 m)").state is State.UNREADABLE
    assert (written("是").yes, written("不自锁").yes, written("无").yes) == (True, False, False)


@pytest.mark.parametrize(
    ("text", "degrees"),
    [
        ("0.49 m/s →", 0), ("0.49（←）", 180), ("0.49 m/s，方向向左", 180), ("0.49 m/s 水平向右", 0),
        ("50 N 竖直向下", 270),
        ("50 N, up", 90), ("50 N to the left", 180), ("50 N ↙", 225), ("50 N 左上方", 135), ("50 N upper right", 45),
    ],
)  # fmt: skip
def test_a_direction_is_read_in_words_and_as_an_arrow(text: str, degrees: float) -> None:
    found = written(text)
    assert found.state is State.READ and found.direction is not None and found.direction.degrees == degrees
    assert found.direction.reach > 0  # no hand is asked to hit it


@pytest.mark.parametrize("text", ["0.49 m/s?", "0.49 m/s §", "0.49 m/s → ccw →", "0.49 m/s#"])
def test_what_stands_behind_a_unit_is_not_passed_over(text: str) -> None:
    assert written(text).state is State.UNREADABLE


@pytest.mark.parametrize(
    ("text", "digits", "last"),
    [("0.490", 3, 0.001), ("12", 2, 1), ("1.50e3", 3, 10), ("0.0049", 2, 0.0001), ("4.72036", 6, 1e-5)],
)
def test_significant_digits_are_those_written(text: str, digits: int, last: float) -> None:
    assert written(text).digits == digits and written(text).last == pytest.approx(last)


@given(st.integers(-(10**6), 10**6).map(lambda x: f"{x / 1000:.4g}"))
def test_full_width_digits_and_chinese_signs_change_nothing(text: str) -> None:
    narrow, wide = written(text), written(text.replace("e", "E").translate(WIDE) if "e" not in text else text)
    assert narrow.state is State.READ and narrow.value == float(text)
    assert (wide.value, wide.digits, wide.last) == (narrow.value, narrow.digits, narrow.last)


@given(st.text(max_size=60))
def test_no_text_whatever_breaks_the_reader(text: str) -> None:
    found = written(text)
    assert found.raw == text
    assert (found.why is None) == (found.state in (State.READ, State.BLANK, State.NONE))


KEYS = ("v_D", "v_C2B", "omega_5", "an_CB", "alpha_3", "eta", "R_12", "bc2", "n2'c2'", "P_14", "P_34")


@pytest.mark.parametrize(
    ("typed", "key"),
    [
        ("ω5", "omega_5"),
        ("ω_5", "omega_5"),
        ("ω₅", "omega_5"),
        ("$\\omega_{5}$", "omega_5"),
        ("w5", "omega_5"),
        ("omega5", "omega_5"),
        ("vD", "v_D"),
        ("v_{D}", "v_D"),
        ("VD", "v_D"),
        ("a^n_CB", "an_CB"),
        ("anCB", "an_CB"),
        ("α３", "alpha_3"),
        ("ε3", "alpha_3"),
        ("η", "eta"),
        ("R12", "R_12"),
        ("bc_2", "bc2"),
        ("n2′c2′", "n2'c2'"),
        ("Vc2b", "v_C2B"),
        ("P_41", "P_14"),
        ("p43", "P_34"),
    ],
)
def test_a_symbol_is_known_however_it_is_typed(typed: str, key: str) -> None:
    assert keyed(typed, KEYS) == key


def test_an_unknown_symbol_is_refused_with_the_nearest_and_one_of_two_with_both() -> None:
    with pytest.raises(UnknownNameError, match="v_D"):
        keyed("v_Q", KEYS)
    with pytest.raises(UnknownNameError, match="v_D, v_d"):
        keyed("V_D", ("v_D", "v_d"))


def test_full_width_letters_are_ordinary_ones() -> None:
    assert plain("　ＡＢ＝１．２×１０²　") == "AB=1.2×10^2"


@pytest.mark.parametrize(
    ("text", "deg"),
    [("63°12′", 63.2), ("63°12′30″", 63.208333), ("63度12分30秒", 63.208333), ("−16° 30'", -16.5), ("36°", 36.0)],
)
def test_minutes_and_seconds_of_arc_are_parts_of_a_degree(text: str, deg: float) -> None:
    found = written(text)
    assert found.state is State.READ and found.unit is not None
    assert found.value * found.unit.factor * 180 / pi == pytest.approx(deg, abs=5e-5)
    assert found.digits == (2 if text == "36°" else 0)  # minutes of arc are not counted as digits


def test_minutes_beyond_sixty_are_no_angle() -> None:
    assert written("63°72′").state is State.UNREADABLE


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("=40+6.42", "it is a formula"),
        ("=B3/2", "it is a formula"),
        ("=SUM(B3:B5)", "it is a formula"),
        ("2026-03-02 00:00:00", "made a date or a time of it"),
        ("2026-03-10 00:00:00 ∠ 172.1°", "made a date or a time of it"),
        ("01:30:00", "made a date or a time of it"),
    ],
)
def test_what_a_spreadsheet_spoilt_is_told_as_that(text: str, told: str) -> None:
    found = written(text)
    assert found.state is State.UNREADABLE and found.why is not None and told in found.why.en


@pytest.mark.parametrize("text", ["=0.3", "= 1.5*10^3", "=12 1/s", "=-3 rad/s"])
def test_an_equals_sign_before_an_answer_makes_no_formula_of_it(text: str) -> None:
    assert written(text).state is State.READ


@pytest.mark.parametrize(
    ("typed", "key"),
    [("θ", "theta"), ("θ_b", "theta_b"), ("ψ", "psi"), ("β", "beta"), ("ΔW_max", "dW_max"), ("θ_bL", "theta_bL")],
)
def test_every_greek_letter_that_is_printed_can_be_typed(typed: str, key: str) -> None:
    assert keyed(typed, ["theta", "theta_b", "psi", "beta", "dW_max", "m_b", "theta_bL"]) == key


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("0.32 ∠ 北偏西", "'北偏西' is no direction that is known"),
        ("0.32 m/s ∠ 北偏西", "'北偏西' is no direction that is known"),
        ("59.9 kgf", "'kgf' is no unit that is known"),
        ("2.49 rad/s 逆 顺", "two senses are written"),
        ("-2.49 rad/s 逆", "its sign and its sense contradict each other"),
    ],
)
def test_what_cannot_be_read_beside_a_number_is_called_what_it_is(text: str, told: str) -> None:
    found = written(text)
    assert found.state in (State.UNREADABLE, State.AMBIGUOUS) and found.why is not None and told in found.why.en
