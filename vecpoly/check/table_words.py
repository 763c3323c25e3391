"""The verdict on a column, and on the whole table, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..words import Words
from .table_columns import Table, shown_position
from .table_explain import Explanation
from .table_guess import Slip
from .table_motions import integral
from .table_sheet import digits
from .table_weigh import Column, Level, Mask, Weighing

MANY = 12  # positions that are listed one by one
Told = Sequence[tuple[Explanation, ...]]


def amount(column: Column, value: float) -> str:
    """A deviation (SI) in the unit of the column: 0.089°, 4.2 rad/s²."""
    size = value / column.factor
    text = f"{size:.0f}" if 100 <= abs(size) < 1e9 else f"{size:.2g}"
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
    texts = ["–".join(shown_position(float(table.printed[k]), table.slide) for k in end) if len(run) > 2
             else ", ".join(shown_position(float(table.printed[k]), table.slide) for k in end) for run, end in zip(runs, ends, strict=True)]
    return ", ".join(texts[:MANY]) + (" …" if len(texts) > MANY else "")


def _which(mask: Mask) -> list[int]:
    return [int(k) for k in np.flatnonzero(mask)]


def of_column(table: Table, i: int, weighed: Sequence[Weighing], told: Told) -> Words:
    """What is to be said of one column."""
    column, before, slips = table.columns[i], weighed[i], told[i]
    if not slips:
        return column.label + Words("：", ": ") + _plain(table, i, weighed, told)
    first = slips[0].after
    how = Words("；或", "; or ").of
    words = Words(how("zh").join(one.words.zh for one in slips), how("en").join(one.words.en for one in slips))
    lead = Words(f"：{before.level.words.zh}（最大偏差 {amount(column, _largest(before))}，{_count(column, before)[0]}）。",
                 f": {before.level.words.en} (largest deviation {amount(column, _largest(before))}; {_count(column, before)[1]}). ")
    cause = Words(f"原因：{words.zh}。此时{_state(table, i, first, weighed, told).zh}",
                  f"Explained: {words.en}. Then it is {_state(table, i, first, weighed, told).en}")
    return column.label + lead + cause


def _plain(table: Table, i: int, weighed: Sequence[Weighing], told: Told) -> Words:
    """A column with no slip behind it."""
    column, one = table.columns[i], weighed[i]
    if one.level is not Level.WRONG:
        return _state(table, i, one, weighed, told)
    wrong = int(column.there.sum()) - one.rows_right
    count = int(column.there.sum())
    right = _which(one.right)
    at = rows_at(table, right)
    only = Words(f"仅在 {at} 正确", f"right only at {at}") if right else Words("没有一行正确", "no row is right")
    return Words(f"{count} 行中有 {wrong} 行错误，{only.zh}；最大偏差 {amount(column, one.largest)}；常见错误均不能解释。",
                 f"wrong in {wrong} of {count} rows, {only.en}; largest deviation {amount(column, one.largest)}; no usual slip explains it.") + _contradicted(table, i, weighed)


def _contradicted(table: Table, i: int, weighed: Sequence[Weighing]) -> Words:
    """The printed column of which this one should be the derivative is right, so the table contradicts itself."""
    before = integral(table.columns[i].target)
    j = next((k for k, column in enumerate(table.columns) if column.target == before), None)
    if j is None or weighed[j].level >= Level.ROWS:
        return Words.same("")
    symbol = f"${table.columns[j].target.symbol}$"
    return Words(f"所列 {symbol} 正确，它的导数并不是这一列：两列自相矛盾。", f" The printed {symbol} is right, and its derivative is not this column: the two contradict each other.")


def _state(table: Table, i: int, one: Weighing, weighed: Sequence[Weighing], told: Told) -> Words:
    """How well a column that is right, or nearly so, is right."""
    column = table.columns[i]
    zh, en = _count(column, one)
    most = amount(column, one.largest)
    match one.level:
        case Level.REPRODUCED:
            return Words(f"正确，{zh}{_short(column, one).zh}。", f"reproduced, {en}{_short(column, one).en}.")
        case Level.LAST_DIGIT:
            return Words(f"正确，{zh}，其余行只差末位（最大 {most}）。", f"reproduced: {en}, the others but for the last digit (at most {most}).")
        case Level.LOW:
            return Words(f"正确但精度低：{zh}，最大偏差 {most}（相当于尺寸相对误差 {one.doubt:.1g}）。",
                         f"reproduced with low accuracy: {en}, at most {most} off (as if the lengths were uncertain by {one.doubt:.1g} of their size).")
    rows = _which(one.outliers)
    at, count = rows_at(table, rows), len(rows)
    least, largest = (amount(column, float(f(np.abs(one.off[rows])))) for f in (np.min, np.max))
    others = f"其余行最大偏差 {most}", f"all other rows are within {most}"
    return Words(f"有 {count} 行错误（{at}，偏差 {least} 至 {largest}），{others[0]}。", f"wrong in {count} rows ({at}, off by {least} to {largest}); {others[1]}.") + _typed_over(table, i, rows, weighed, told)


def _typed_over(table: Table, i: int, rows: Sequence[int], weighed: Sequence[Weighing], told: Told) -> Words:
    """Other columns of the same link that are right in just these rows show that only the number was changed."""
    link = table.columns[i].target.of_link
    for j, column in enumerate(table.columns):
        best = told[j][0].after if told[j] else weighed[j]
        if j != i and link and column.target.of_link == link and best.level < Level.WRONG and not best.outliers[list(rows)].any():
            symbol = f"${column.target.symbol}$"
            return Words(f"这些行的 {symbol} 与正确值相符，可见只是这几个数被改写或抄错。", f" The {symbol} of these rows belongs to the exact values, so these numbers were typed over.")
    return Words.same("")


def _largest(one: Weighing) -> float:
    known = np.abs(one.off[np.isfinite(one.off)])
    return float(known.max()) if len(known) else float("nan")


def _count(column: Column, one: Weighing) -> tuple[str, str]:
    count = int(column.there.sum())
    return f"{count} 行中有 {one.rows_right} 行在末位半个单位以内", f"{one.rows_right} of {count} rows within half a unit of the last digit"


def _short(column: Column, one: Weighing) -> Words:
    """Rows that are right only because few of their digits are printed."""
    usual = float(np.median(column.half[column.there]))
    written = np.array([digits(text) for text in column.texts])
    short = one.right & (written <= np.median(written) - 3) & (np.abs(one.off) > 2 * usual)
    if not short.any():
        return Words.same("")
    few = [int(n) for n in written[short]]
    span = f"{min(few)}" if min(few) == max(few) else f"{min(few)}–{max(few)}"
    return Words(f"（其中 {len(few)} 行只印了 {span} 位有效数字）", f" ({len(few)} of them printed with {span} digits only)")


def of_whole(table: Table, weighed: Sequence[Weighing], told: Told) -> tuple[Words, ...]:
    """The verdict on the table: what is right, what was computed with other lengths, what nothing explains, which rows are wrong."""
    columns = table.columns
    right = [i for i, one in enumerate(weighed) if one.level < Level.ROWS and not told[i]]
    if len(right) == len(columns):
        return (Words("全部各列正确。", "All columns are reproduced."),)
    groups: dict[tuple[str, str], list[int]] = {}
    for i, slips in enumerate(told):
        if slips:
            groups.setdefault((slips[0].words.zh, slips[0].words.en), []).append(i)
    lost = [i for i, one in enumerate(weighed) if one.level is Level.WRONG and not told[i]]
    return (
        *([_listed(columns, right, "正确", "reproduced")] if right else []),
        *(_listed(columns, which, zh, en) for (zh, en), which in groups.items()),
        *_rows(table, weighed, told),
        *(_lost(table, i, weighed[i]) for i in lost),
        *_two_lengths(told),
    )


def _listed(columns: Sequence[Column], which: Sequence[int], zh: str, en: str) -> Words:
    labels = [columns[i].label for i in which]
    return Words(f"{'、'.join(label.zh for label in labels)}：{zh}。", f"{', '.join(label.en for label in labels)}: {en}.")


def _lost(table: Table, i: int, one: Weighing) -> Words:
    """A column that nothing explains, with the rows that are right all the same."""
    right, count = _which(one.right), int(table.columns[i].there.sum())
    at = rows_at(table, right)
    zh, en = (f"，仅在 {at} 正确", f", right only at {at}") if right else ("", "")
    return _listed(table.columns, [i], f"{count} 行中有 {count - len(right)} 行错误{zh}，常见错误均不能解释",
                   f"wrong in {count - len(right)} of {count} rows{en}, and no usual slip explains it")


def _rows(table: Table, weighed: Sequence[Weighing], told: Told) -> list[Words]:
    """Columns that are wrong in certain rows, explained or not."""
    found = []
    for i, one in enumerate(weighed):
        rows = _which((told[i][0].after if told[i] else one).outliers)
        if rows:
            at = rows_at(table, rows)
            found.append(_listed(table.columns, [i], f"有 {len(rows)} 行错误（{at}）", f"wrong in {len(rows)} rows ({at})"))
    return found


def _two_lengths(told: Told) -> tuple[Words, ...]:
    if not any(slips and slips[0].slip is Slip.RATES for slips in told):
        return ()
    return (Words("位置与速度、加速度用了同一尺寸的两个取值：整张表不属于任何一个机构。",
                  "Positions and rates were computed with two values of one length: the table belongs to no one mechanism."),)
