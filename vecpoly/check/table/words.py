"""The verdict on a column, and on the whole table, in words."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

import numpy as np

from ...oracle.run import wrapped
from ...words import Words
from ..slips.explain import Explanation
from ..slips.guess import Slip
from ..slips.motions import integral
from .columns import Table, shown_position
from .sheet import digits
from .weigh import LAST_DIGIT, Column, Level, Mask, Weighing

MANY = 12  # positions that are listed one by one
FEW_NUMBERS = 3  # wrong numbers that are told one by one
SMOOTH = 0.3  # second differences of a smooth deviation, as a share of its size
Told = Sequence[tuple[Explanation, ...]]


def amount(column: Column, value: float) -> str:
    """A deviation (SI) in the unit of the column: 0.089°, 4.2 rad/s²."""
    size = value / column.factor
    text = f"{size:.0f}" if 100 <= abs(size) < 1e9 else f"{size:.2g}"
    if 1e-5 <= abs(size) < 1e-4:
        text = f"{size:.{1 - floor(log10(abs(size)))}f}"
    elif 0 < abs(size) < 1e-5:
        power = floor(log10(abs(size)))
        text = f"${size / 10.0**power:.1f}×10^{{{power}}}$"
    return f"{text}°" if column.unit in ("deg", "°") else f"{text} {column.unit.replace('^2', '²')}"


def rows_at(table: Table, rows: Sequence[int]) -> str:
    """Positions of the drive: 0°, 40°; runs of neighbouring rows as 0°–60°."""
    runs: list[list[int]] = []
    for k in rows:
        if runs and k == runs[-1][-1] + 1:
            runs[-1].append(k)
        else:
            runs.append([k])
    ends = [[run[0], run[-1]] if len(run) > 2 else run for run in runs]
    texts = [
        "–".join(shown_position(float(table.printed[k]), table.slide) for k in end)
        if len(run) > 2
        else ", ".join(shown_position(float(table.printed[k]), table.slide) for k in end)
        for run, end in zip(runs, ends, strict=True)
    ]
    return ", ".join(texts[:MANY]) + (" …" if len(texts) > MANY else "")


def listed(at: str) -> str:
    """Positions in a Chinese sentence."""
    return at.replace(", ", "、")


def spaced(label: str) -> str:
    """A label within a Chinese sentence: a symbol stands apart by spaces, words do not."""
    return f" {label} " if label.startswith("$") else label


def which(mask: Mask) -> list[int]:
    return [int(k) for k in np.flatnonzero(mask)]


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
            return Words(f"正确，{zh}{_short(column, one).zh}。", f"reproduced, {en}{_short(column, one).en}.")
        case Level.LAST_DIGIT:
            return Words(
                f"正确，{zh}，其余行只差末位（最大 {most}）。",
                f"reproduced: {en}, the others but for the last digit (at most {most}).",
            )
        case Level.LOW:
            return Words(
                f"正确但精度低：{zh}，最大偏差 {most}（{_worst(table, one)}）。",
                f"reproduced with low accuracy: {en}, at most {most} off (at {_worst(table, one)}).",
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
        + _numbers(table, i, one, rows)
        + Words("。", ".")
        + _typed_over(table, i, rows, weighed, told)
        + _closing(table, column)
    )


def _worst(table: Table, one: Weighing) -> str:
    off = np.where(np.isfinite(one.off) & ~one.outliers, np.abs(one.off), 0.0)
    return shown_position(float(table.printed[int(np.argmax(off))]), table.slide)


def _numbers(table: Table, i: int, one: Weighing, rows: Sequence[int]) -> Words:
    """A few wrong numbers, each beside the one that belongs there."""
    column = table.columns[i]
    if len(rows) > FEW_NUMBERS:
        return Words.same("")
    pairs = []
    for k in rows:
        decimals = (
            len(column.texts[k].lower().partition("e")[0].partition(".")[2])
            if "e" not in column.texts[k].lower()
            else 6
        )
        right = (column.values[k] - one.off[k]) / column.factor
        if column.target.is_angle:  # in the turn of the number that is printed
            right = column.values[k] / column.factor - one.off[k] / column.factor
        pairs.append(
            (
                shown_position(float(table.printed[k]), table.slide),
                column.texts[k],
                f"{right + column.turned / column.factor:.{decimals}f}",
            )
        )
    return Words(
        "：" + "；".join(f"{at} 处印作 {text}，应为 {right}" for at, text, right in pairs),
        ": " + "; ".join(f"{text} for {right} at {at}" for at, text, right in pairs),
    )


def _closing(table: Table, column: Column) -> Words:
    """Rows one whole turn apart must agree, and do not."""
    turn = np.flatnonzero(np.abs(table.positions - table.positions[0] - 2 * np.pi) < 1e-6)
    if table.slide or not len(turn) or (column.target.is_angle is False and not column.target.rel):
        return Words.same("")
    gap = float(column.values[turn[0]] - column.values[0])
    gap = float(wrapped(np.array([gap]))[0]) if column.target.is_angle else gap
    if not abs(gap) > 2 * LAST_DIGIT * max(column.half[0], column.half[turn[0]]):
        return Words.same("")
    first, last = (shown_position(float(table.printed[k]), table.slide) for k in (0, int(turn[0])))
    return Words(
        f"{first} 与 {last} 两行本应相同，表中却差 {amount(column, abs(gap))}。",
        f" The rows {first} and {last} must agree, and differ by {amount(column, abs(gap))}.",
    )


def _typed_over(table: Table, i: int, rows: Sequence[int], weighed: Sequence[Weighing], told: Told) -> Words:
    """Other columns of the same link that are right, or wrong by one rule, in just these rows show that only the number
    was changed."""
    link = table.columns[i].target.of_link
    for j, column in enumerate(table.columns):
        best = told[j][0].after if told[j] else weighed[j]
        if (
            j == i
            or not link
            or column.target.of_link != link
            or best.level >= Level.WRONG
            or best.outliers[list(rows)].any()
        ):
            continue
        here, there = table.columns[i].label, column.label
        if told[j]:
            return Words(
                f"这些行的{spaced(there.zh)}与其余各行服从同一规律，可见算出的{spaced(here.zh)}是对的，"
                "只是这几个数被改写或抄错。",
                f" In these rows {there.en} follows the same rule as in all others: {here.en} was "
                "right when it was computed, and only these numbers were typed over.",
            )
        return Words(
            f"这些行的{spaced(there.zh)}与正确值相符，可见只是这几个数被改写或抄错。",
            f" The {there.en} of these rows belongs to the exact values, so these numbers were typed over.",
        )
    return Words.same("")


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
