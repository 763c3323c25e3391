"""The verdict on a column in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....words import Words
from ...slips.explain import Explanation
from ...slips.guess import Slip
from ...slips.motions import integral
from ..columns import Table, shown_position
from ..sheet import digits
from ..weigh import Column, Level, Weighing
from .amounts import amount, listed, rows_at, spaced, which
from .wrong_rows import Told, closing, numbers, typed_over

SMOOTH = 0.3  # second differences of a smooth deviation, as a share of its size


def of_column(table: Table, i: int, weighed: Sequence[Weighing], told: Told) -> Words:
    """What is to be said of one column."""
    column, before, slips = table.columns[i], weighed[i], told[i]
    if not slips:
        return column.label + Words("：", ": ") + _plain(table, i, weighed, told)
    state = _state(table, i, slips[0].after, weighed, told)
    cause = Words(f"原因：{causes(slips).zh}。此时{state.zh}", f"Explained: {causes(slips).en}. Then it is {state.en}")
    return column.label + Words("：", ": ") + _wrong(table, column, before) + Words("。", ". ") + cause


def causes(slips: Sequence[Explanation]) -> Words:
    """All that explains a column; what only follows from the first is told as its consequence."""
    first, follows = slips[0].words, Words.same("")
    others = [one for one in slips[1:] if not (one.slip is Slip.FACTOR and slips[0].slip is Slip.RATES)]
    for one in slips[1:]:
        if one not in others:
            follows = Words(
                f"（因而是正确值的 {one.parameter:.5g} 倍）", f" (so it is {one.parameter:.5g} times the exact value)"
            )
    texts = [first + follows, *(one.words for one in others)]
    equally = (
        Words("（几种解释同样符合，依可能性排列）", " (these fit equally well, the likeliest first)")
        if others
        else Words.same("")
    )
    return Words("；或".join(text.zh for text in texts), "; or ".join(text.en for text in texts)) + equally


def _wrong(table: Table, column: Column, before: Weighing) -> Words:
    """In how many rows it is wrong, and where the others are."""
    count, right = int(column.there.sum()), which(before.right)
    most = amount(column, before.worst)
    if not right:
        return Words(f"{count} 行全部错误，最大偏差 {most}", f"wrong in all {count} rows, by up to {most}")
    at = rows_at(table, right)
    return Words(
        f"{count} 行中有 {count - len(right)} 行错误，仅在 {listed(at)} 相符，最大偏差 {most}",
        f"wrong in {count - len(right)} of {count} rows, right only at {at}, by up to {most}",
    )


def _plain(table: Table, i: int, weighed: Sequence[Weighing], told: Told) -> Words:
    """A column with no slip behind it."""
    column, one = table.columns[i], weighed[i]
    if one.level is not Level.WRONG:
        return _state(table, i, one, weighed, told)
    crossed = Words("（两条曲线在此相交）", " (where the two curves cross)") if one.right.any() else Words.same("")
    return (
        _wrong(table, column, one)
        + crossed
        + Words("；常见错误均不能解释。", "; no usual slip explains it.")
        + _smooth(one)
        + _contradicted(table, i, weighed)
    )


def _smooth(one: Weighing) -> Words:
    """A deviation that runs smoothly through the cycle comes of a formula, not of copying."""
    off = one.off[np.isfinite(one.off)]
    if len(off) < 8 or np.median(np.abs(np.diff(off, 2))) > SMOOTH * np.median(np.abs(off - np.median(off))):
        return Words.same("")
    return Words(
        "偏差随转角连续变化，属公式或数据错误，而不是抄写错误。",
        " The deviation changes smoothly from row to row: a slip in a formula or in its data, not in copying.",
    )


def _contradicted(table: Table, i: int, weighed: Sequence[Weighing]) -> Words:
    """The printed column of which this one should be the derivative is right, so the table contradicts itself."""
    before = integral(table.columns[i].target)
    j = next((k for k, column in enumerate(table.columns) if column.target == before), None)
    if j is None or weighed[j].level >= Level.ROWS:
        return Words.same("")
    label = table.columns[j].label
    return Words(
        f"所列{spaced(label.zh)}正确，它的导数并不是这一列：两列自相矛盾。",
        f" The printed {label.en} is right, and its derivative is not this column: the two contradict each other.",
    )


def _state(table: Table, i: int, one: Weighing, weighed: Sequence[Weighing], told: Told) -> Words:
    """How well a column that is right, or nearly so, is right."""
    column = table.columns[i]
    zh, en = _count(column, one)
    most = amount(column, one.largest)
    match one.level:
        case Level.REPRODUCED:
            return Words(f"正确，{zh}{_short(column, one).zh}。", f"in agreement, {en}{_short(column, one).en}.")
        case Level.LAST_DIGIT:
            return Words(
                f"正确，{zh}，其余行只差末位（最大 {most}）。",
                f"in agreement: {en}, the others but for the last digit (at most {most}).",
            )
        case Level.LOW:
            return Words(
                f"正确但精度低：{zh}，最大偏差 {most}（{_worst(table, one)}）。",
                f"in agreement with low accuracy: {en}, at most {most} off (at {_worst(table, one)}).",
            )
    rows = which(one.outliers)
    at, count = rows_at(table, rows), len(rows)
    least, largest = (amount(column, float(f(np.abs(one.off[rows])))) for f in (np.min, np.max))
    fine = most != amount(column, 0.0)
    others = Words(
        f"其余行{'最大偏差 ' + most if fine else '全部正确'}",
        f"all other rows are {'within ' + most if fine else 'right'}",
    )
    span = (
        largest if least == largest else f"{least} 至 {largest}",
        largest if least == largest else f"{least} to {largest}",
    )
    return (
        Words(
            f"有 {count} 行错误（{listed(at)}，偏差 {span[0]}），{others.zh}",
            f"wrong in {count} row{'s' * (count > 1)} ({at}, off by {span[1]}); {others.en}",
        )
        + numbers(table, i, one, rows)
        + Words("。", ".")
        + typed_over(table, i, rows, weighed, told)
        + closing(table, column)
    )


def _worst(table: Table, one: Weighing) -> str:
    off = np.where(np.isfinite(one.off) & ~one.outliers, np.abs(one.off), 0.0)
    return shown_position(float(table.printed[int(np.argmax(off))]), table.slide)


def _count(column: Column, one: Weighing) -> tuple[str, str]:
    count = int(column.there.sum())
    if one.rows_right == count:
        return f"{count} 行全部在末位半个单位以内", f"all {count} rows within half a unit of the last digit"
    return (
        f"{count} 行中有 {one.rows_right} 行在末位半个单位以内",
        f"{one.rows_right} of {count} rows within half a unit of the last digit",
    )


def _short(column: Column, one: Weighing) -> Words:
    """Rows that are right only because few of their digits are printed."""
    usual = float(np.median(column.half[column.there]))
    written = np.array([digits(text) for text in column.texts])
    short = one.right & (written <= np.median(written) - 3) & (np.abs(one.off) > 2 * usual)
    if not short.any():
        return Words.same("")
    few = [int(n) for n in written[short]]
    span = f"{min(few)}" if min(few) == max(few) else f"{min(few)}–{max(few)}"
    return Words(
        f"（其中 {len(few)} 行只印了 {span} 位有效数字）", f" ({len(few)} of them printed with {span} digits only)"
    )
