"""Claims about what is said of a printed table:
each sentence on columns made by hand, where the right words are known."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi, radians

import numpy as np
import pytest

from vecpoly.check.slips.explain import Explanation
from vecpoly.check.slips.guess import Slip
from vecpoly.check.table.columns import Table, shown_position
from vecpoly.check.table.quantity_names import read_target
from vecpoly.check.table.sheet import last_unit
from vecpoly.check.table.target import Reals
from vecpoly.check.table.told.amounts import amount, rows_at
from vecpoly.check.table.told.column import causes, of_column
from vecpoly.check.table.told.whole import in_short, of_whole
from vecpoly.check.table.weigh import Column, Level, Weighing, scale_of, weigh
from vecpoly.words import Words

DEG = np.arange(0.0, 360.0, 30.0)
TRUE = 10.0 + 5.0 * np.sin(np.radians(DEG))  # rad/s


def column(
    values: Sequence[float] | Reals,
    symbol: str = "omega3",
    *,
    decimals: int = 3,
    unit: str = "rad/s",
    factor: float = 1.0,
    renumbered: str = "",
) -> Column:
    texts = tuple("" if np.isnan(value) else f"{value / factor:.{decimals}f}" for value in values)
    target = read_target(symbol)
    assert target is not None
    return Column(
        header=symbol,
        target=target,
        values=np.array([float(text or "nan") for text in texts]) * factor,
        half=np.array([last_unit(text) for text in texts]) / 2 * factor,
        texts=texts,
        unit=unit,
        factor=factor,
        renumbered=renumbered,
    )


def table(*columns: Column, degrees: Reals = DEG, slide: bool = False) -> Table:
    return Table(
        name="t", positions=np.radians(degrees), printed=degrees, columns=columns, notes=(), left_out=(), slide=slide
    )


def weighed(one: Column, expected: Reals = TRUE) -> Weighing:
    return weigh(one, expected, np.full(len(expected), scale_of(one.target, expected)))


def said(
    *columns: Column, expected: Sequence[Reals] = (), told: Sequence[tuple[Explanation, ...]] = ()
) -> tuple[Words, ...]:
    """The sentence on each column, then the verdict on the whole."""
    made, found = (
        table(*columns),
        [weighed(one, true) for one, true in zip(columns, expected or [TRUE] * len(columns), strict=True)],
    )
    slips = list(told) or [()] * len(columns)
    return (*(of_column(made, i, found, slips) for i in range(len(columns))), *of_whole(made, found, slips))


def spoilt(rows: dict[int, float], of: Reals = TRUE) -> Reals:
    return np.array([value + rows.get(i, 0.0) for i, value in enumerate(of)])


def test_a_right_column_is_reproduced_in_all_its_rows() -> None:
    of_one, whole = said(column(TRUE))
    assert of_one.en == "$ω_{3}$: in agreement, all 12 rows within half a unit of the last digit."
    assert of_one.zh == "$ω_{3}$：正确，12 行全部在末位半个单位以内。"
    assert whole == Words("全部各列正确。", "All columns agree.")


def test_of_a_partly_wrong_table_the_right_columns_are_told_to_be_reproduced() -> None:
    right, wrong, low = (
        column(TRUE),
        column(np.roll(TRUE, 5), "alpha3"),
        column(TRUE + 0.0031 * np.cos(3 * np.radians(DEG)), "omega5", decimals=5),
    )
    *_, first, second, third = said(right, wrong, low)
    assert first == Words("$ω_{3}$：正确。", "$ω_{3}$: correct.")
    assert second == Words("$ω_{5}$：正确但精度低。", "$ω_{5}$: correct, with low accuracy.")
    assert (
        third.en.startswith("$α_{3}$: wrong in")
        and "no usual slip explains it" in third.en
        and "常见错误均不能解释" in third.zh
    )
    *_, both, rest = said(right, column(TRUE, "omega5"), wrong)
    assert both == Words("$ω_{3}$、$ω_{5}$：正确。", "$ω_{3}$, $ω_{5}$: correct.") and rest.en.startswith(
        "$α_{3}$: wrong"
    )


def test_a_row_typed_over_is_told_with_the_number_that_belongs_there() -> None:
    of_one, *whole = said(column(spoilt({4: 2.0})))
    assert weighed(column(spoilt({4: 2.0}))).level is Level.ROWS
    assert (
        of_one.en
        == "$ω_{3}$: wrong in 1 row (120°, off by 2 rad/s); all other rows are within 0.00013 rad/s: 16.330 for "
        "14.330 at 120°."
    )
    assert (
        of_one.zh == "$ω_{3}$：有 1 行错误（120°，偏差 2 rad/s），其余行最大偏差 0.00013 rad/s：120° 处印作 16.330，"
        "应为 14.330。"
    )
    assert [words.en for words in whole] == ["$ω_{3}$: wrong in 1 row (120°)."] and whole[
        0
    ].zh == "$ω_{3}$：有 1 行错误（120°）。"


def test_up_to_three_wrong_numbers_are_told_one_by_one_and_more_by_their_places_only() -> None:
    three, four = (said(column(spoilt(dict.fromkeys(rows, 2.0))))[0] for rows in ((2, 5, 9), (2, 5, 7, 9)))
    assert three.en.count(" for ") == 3 and "wrong in 3 rows (60°, 150°, 270°, off by" in three.en
    assert " for " not in four.en and "wrong in 4 rows (60°, 150°, 210°, 270°, off by" in four.en


def test_wrong_rows_off_by_different_amounts_are_told_from_the_least_to_the_largest() -> None:
    words = said(column(spoilt({2: 1.0, 5: -3.0})))[0]
    assert "off by 1 rad/s to 3 rad/s" in words.en and "偏差 1 rad/s 至 3 rad/s" in words.zh


def test_a_number_typed_over_is_known_by_the_right_column_of_the_same_link() -> None:
    speeds, rates = spoilt({4: 2.0}), np.cos(np.radians(DEG))
    first = said(column(speeds), column(rates, "alpha3"), expected=(TRUE, rates))[0]
    assert (
        "The $α_{3}$ of these rows belongs to the exact values, so these numbers were typed over." in first.en
        and "只是这几个数被改写或抄错" in first.zh
    )
    other = said(column(speeds), column(rates, "alpha5"), expected=(TRUE, rates))[0]
    assert "typed over" not in other.en
    both = said(column(speeds), column(spoilt({4: 1.0}, rates), "alpha3"), expected=(TRUE, rates))[0]
    assert "typed over" not in both.en


def test_a_column_wrong_throughout_says_by_how_much_and_where_it_is_right() -> None:
    values = TRUE * 1.3
    none = said(column(values))[0]
    assert (
        "wrong in all 12 rows, by up to 4.5 rad/s; no usual slip explains it." in none.en
        and "12 行全部错误，最大偏差 4.5 rad/s" in none.zh
    )
    crossing = values.copy()
    crossing[[3, 7]] = TRUE[[3, 7]]
    some = said(column(crossing))[0]
    assert "wrong in 10 of 12 rows, right only at 90°, 210°" in some.en and "(where the two curves cross)" in some.en
    assert "12 行中有 10 行错误，仅在 90°、210° 相符" in some.zh and "两条曲线在此相交" in some.zh


def test_a_smooth_deviation_is_told_from_one_that_jumps() -> None:
    phi = np.radians(np.arange(0.0, 360.0, 10.0))
    true = 10 + 5 * np.sin(phi)
    for off, smooth in ((2 + np.sin(phi), True), (2 * (-1.0) ** np.arange(36), False)):
        one = column(true + off)
        words = of_column(table(one, degrees=np.degrees(phi)), 0, [weighed(one, true)], [()])
        assert ("changes smoothly" in words.en) == smooth == ("偏差随转角连续变化" in words.zh)


def test_a_right_integral_beside_a_wrong_derivative_contradicts_the_table() -> None:
    rates = 5 * np.cos(np.radians(DEG))
    words = said(column(TRUE), column(rates * 1.4, "alpha3"), expected=(TRUE, rates))[1]
    assert (
        "The printed $ω_{3}$ is right, and its derivative is not this column" in words.en
        and "所列 $ω_{3}$ 正确，它的导数并不是这一列" in words.zh
    )
    assert "contradict" not in said(column(TRUE * 1.4), column(rates * 1.4, "alpha3"), expected=(TRUE, rates))[1].en
    assert "contradict" not in said(column(TRUE, "omega5"), column(rates * 1.4, "alpha3"), expected=(TRUE, rates))[1].en


def test_rows_one_whole_turn_apart_must_agree() -> None:
    degrees = np.arange(0.0, 361.0, 30.0)
    true = 10 + 5 * np.sin(np.radians(degrees))
    for row, told in ((12, True), (5, False)):
        one = column(spoilt({row: 0.7}, true))
        words = of_column(table(one, degrees=degrees), 0, [weighed(one, true)], [()])
        assert (
            ("The rows 0° and 360° must agree, and differ by 0.7 rad/s." in words.en)
            == told
            == ("0° 与 360° 两行本应相同，表中却差 0.7 rad/s。" in words.zh)
        )
    slid = column(spoilt({12: 0.7}, true))
    assert "must agree" not in of_column(table(slid, degrees=degrees, slide=True), 0, [weighed(slid, true)], [()]).en


def test_a_column_printed_with_the_last_digit_unsure_or_with_low_accuracy_says_so() -> None:
    unsure = said(column(TRUE + 0.002))[0]
    assert weighed(column(TRUE + 0.002)).level is Level.LAST_DIGIT
    assert (
        "in agreement: 0 of 12 rows within half a unit of the last digit, the others but for the last digit (at "
        "most 0.002" in unsure.en
    )
    worst = spoilt({7: 0.004}) + 0.001 * np.cos(np.radians(DEG))
    low = said(column(worst, decimals=6))[0]
    assert (
        weighed(column(worst, decimals=6)).level is Level.LOW
        and "in agreement with low accuracy" in low.en
        and "(at 210°)" in low.en
        and "正确但精度低" in low.zh
    )


def test_rows_printed_with_few_digits_are_counted() -> None:
    one = column(TRUE, decimals=5)
    texts = tuple("15" if i == 3 else text for i, text in enumerate(one.texts))
    short = Column(
        header="w",
        target=one.target,
        values=np.where(DEG == 90, 15.3, one.values),
        half=np.where(DEG == 90, 0.5, one.half),
        texts=texts,
        unit="rad/s",
        factor=1.0,
    )
    words = of_column(table(short), 0, [weighed(short)], [()])
    assert "(1 of them printed with 2 digits only)" in words.en and "（其中 1 行只印了 2 位有效数字）" in words.zh


def explanation(slip: Slip, words: str, after: Weighing, **more: object) -> Explanation:
    return Explanation(slip=slip, words=Words.same(words), after=after, **more)  # type: ignore[arg-type]


def test_an_explained_column_names_its_cause_and_how_right_it_is_then() -> None:
    after = weighed(column(TRUE))
    slip = explanation(Slip.FACTOR, "twice", after)
    of_one, *whole = said(column(2 * TRUE), told=[(slip,)])
    assert (
        of_one.en
        == "$ω_{3}$: wrong in all 12 rows, by up to 15 rad/s. Explained: twice. Then it is in agreement, all 12 "
        "rows within half a unit of the last digit."
    )
    assert (
        of_one.zh == "$ω_{3}$：12 行全部错误，最大偏差 15 rad/s。原因：twice。此时正确，12 行全部在末位半个单位以内。"
    )
    assert [words.en for words in whole] == ["$ω_{3}$: twice."]


def test_explanations_that_fit_equally_are_all_told_and_a_consequence_as_one() -> None:
    after = weighed(column(TRUE))
    one, two = explanation(Slip.LENGTH, "l = 3", after), explanation(Slip.SIGN, "minus", after)
    assert (
        causes([one]).en == "l = 3"
        and causes([one, two]).en == "l = 3; or minus (these fit equally well, the likeliest first)"
    )
    assert causes([one, two]).zh == "l = 3；或minus（几种解释同样符合，依可能性排列）"
    rates, factor = explanation(Slip.RATES, "rates", after), explanation(Slip.FACTOR, "f", after, parameter=1.25)
    assert causes([rates, factor]).en == "rates (so it is 1.25 times the exact value)" and causes(
        [one, factor]
    ).en.startswith("l = 3; or f")


def test_positions_and_rates_with_two_lengths_belong_to_no_one_mechanism() -> None:
    after = weighed(column(TRUE))
    for slip, told in ((Slip.RATES, True), (Slip.LENGTH, False)):
        whole = said(column(2 * TRUE), told=[(explanation(slip, "x", after),)])[1:]
        assert any("no one mechanism" in words.en for words in whole) == told


def test_a_slip_beside_the_lengths_that_all_share_tells_these_once() -> None:
    after = weighed(column(spoilt({4: 2.0})))
    one = explanation(Slip.TERM, "x", after, alone=Words("少一项", "a term left out"), length="l_AB")
    assert in_short(one) == Words(
        "尺寸同上；此外，少一项（照此计算，11/12 行相符）",
        "the same lengths; besides, a term left out (computed so, 11 of 12 rows agree)",
    )
    full = explanation(Slip.TERM, "x", weighed(column(TRUE)), alone=Words("少一项", "a term left out"))
    assert in_short(full) == Words(
        "少一项（照此计算，全部 12 行相符）", "a term left out (computed so, all 12 rows agree)"
    )


@pytest.mark.parametrize(
    ("si", "unit", "factor", "text"),
    [
        (radians(0.0894), "deg", pi / 180, "0.089°"),
        (4.21, "rad/s^2", 1.0, "4.2 rad/s²"),
        (0.1234, "mm", 1e-3, "123 mm"),
        (100.4, "m/s", 1.0, "100 m/s"),
        (99.4, "m/s", 1.0, "99 m/s"),
        (3.21e-5, "m", 1.0, "0.000032 m"),
        (3.21e-7, "m", 1.0, "$3.2×10^{-7}$ m"),
        (0.0, "m", 1.0, "0 m"),
        (2e9, "m", 1.0, "2e+09 m"),
    ],
)
def test_a_deviation_is_told_in_the_unit_of_its_column_with_two_digits(
    si: float, unit: str, factor: float, text: str
) -> None:
    assert amount(column([1.0] * 5, unit=unit, factor=factor), si) == text


@pytest.mark.parametrize(
    ("rows", "text"),
    [([], ""), ([2], "60°"), ([2, 3], "60°, 90°"), ([2, 3, 4], "60°–120°"), ([0, 2, 3, 4, 6], "0°, 60°–120°, 180°")],
)
def test_neighbouring_rows_are_told_as_a_range(rows: list[int], text: str) -> None:
    assert rows_at(table(column(TRUE)), rows) == text


def test_many_rows_are_broken_off_after_twelve() -> None:
    degrees = np.arange(0.0, 360.0, 10.0)
    assert (
        rows_at(table(column([1.0] * 36), degrees=degrees), range(0, 26, 2))
        == ", ".join(f"{20 * k}°" for k in range(12)) + " …"
    )
    assert not rows_at(table(column([1.0] * 36), degrees=degrees), range(0, 24, 2)).endswith("…")


def test_positions_are_shown_in_degrees_or_in_millimetres() -> None:
    assert [
        shown_position(value, slide) for value, slide in ((90.0, False), (-7.5, False), (12.0, True), (-1e-12, False))
    ] == ["90°", "−7.5°", "12 mm", "0°"]


def test_a_table_that_numbers_its_links_otherwise_is_told_with_both_numbers() -> None:
    label = column(TRUE, renumbered="ω_4").label
    assert label == Words("表中 $ω_4$（即 $ω_{3}$）", "$ω_4$ (here $ω_{3}$)")


@pytest.mark.parametrize(
    ("off", "level"),
    [
        (0.0005, Level.REPRODUCED),
        (0.0006, Level.LAST_DIGIT),
        (0.0099, Level.LAST_DIGIT),
        (0.0115, Level.LOW),
        (0.014, Level.LOW),
        (0.02, Level.WRONG),
    ],
)
def test_a_column_off_by_one_amount_throughout_is_as_right_as_its_digits_say(off: float, level: Level) -> None:
    """Half a unit is 0.0005, the last digit means up to ten units, low accuracy up to a thousandth of 15 rad/s."""
    true = np.round(TRUE, 3)
    one = Column(
        header="w",
        target=column(TRUE).target,
        values=true + off,
        half=np.full(12, 0.0005),
        texts=("1.000",) * 12,
        unit="rad/s",
        factor=1.0,
    )
    assert weigh(one, true, np.full(12, 15.0)).level is level


def test_rows_without_a_number_are_left_out() -> None:
    values = TRUE.copy()
    values[[1, 8]] = np.nan
    one = column(values)
    found = weighed(one)
    assert found.level is Level.REPRODUCED and found.rows_right == 10 and "all 10 rows" in said(one)[0].en


def test_angles_are_compared_but_for_whole_turns_and_rates_are_not() -> None:
    angles = np.radians(DEG)
    target = column(angles, "phi3", decimals=6).target
    one = Column(
        header="phi3",
        target=target,
        values=angles + 2 * pi,
        half=np.full(12, 1e-6),
        texts=("1.0",) * 12,
        unit="rad",
        factor=1.0,
    )
    assert (
        weighed(one, angles).level is Level.REPRODUCED
        and weigh(one, angles, np.ones(12), whole_turns=False).level is Level.WRONG
    )
    rate = Column(
        header="w",
        target=column(TRUE).target,
        values=TRUE + 2 * pi,
        half=np.full(12, 1e-6),
        texts=("1.0",) * 12,
        unit="rad/s",
        factor=1.0,
    )
    assert weighed(rate).level is Level.WRONG


def test_the_largest_deviation_leaves_out_rows_that_stand_apart_and_the_worst_does_not() -> None:
    found = weighed(column(spoilt({4: -2.0})))
    assert (
        found.worst == pytest.approx(2.0, abs=1e-3)
        and found.largest < 1e-3
        and found.outliers.tolist() == [i == 4 for i in range(12)]
    )
    assert found.rows_right == 11 and found.typical <= 1.0
