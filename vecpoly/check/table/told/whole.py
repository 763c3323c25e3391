"""The verdict on the whole table, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....words import Words
from ...slips.explain import Explanation
from ...slips.guess import Slip
from ..columns import Table
from ..weigh import Column, Level, Weighing
from .amounts import listed, rows_at, which
from .wrong_rows import Told


def of_whole(table: Table, weighed: Sequence[Weighing], told: Told) -> tuple[Words, ...]:
    """The verdict on the table: what is right, what was computed with other lengths,
    what nothing explains, which rows are wrong."""
    columns = table.columns
    right = [i for i, one in enumerate(weighed) if one.level < Level.LOW and not told[i]]
    low = [i for i, one in enumerate(weighed) if one.level is Level.LOW and not told[i]]
    if len(right) == len(columns):
        return (Words("全部各列正确。", "All columns agree."),)
    groups: dict[tuple[str, str], list[int]] = {}
    for i, slips in enumerate(told):
        if slips:
            words = in_short(slips[0])
            groups.setdefault((words.zh, words.en), []).append(i)
    lost = [i for i, one in enumerate(weighed) if one.level is Level.WRONG and not told[i]]
    return (
        *([_listed(columns, right, "正确", "correct")] if right else []),
        *([_listed(columns, low, "正确但精度低", "correct, with low accuracy")] if low else []),
        *(_listed(columns, which, zh, en) for (zh, en), which in groups.items()),
        *_rows(table, weighed, told),
        *(_lost(table, i, weighed[i]) for i in lost),
        *_two_lengths(told),
    )


def in_short(one: Explanation) -> Words:
    """The slip as the verdict on a whole table tells it: what other columns share is not told again."""
    if one.alone is None:
        return one.words
    zh, en = ("尺寸同上；此外，", "the same lengths; besides, ") if one.length else ("", "")
    right, count = one.after.rows_right, int(np.isfinite(one.after.off).sum())
    agree = Words("全部 ", "all ") if right == count else Words(f"{right}/", f"{right} of ")
    return (
        Words(zh, en)
        + one.alone
        + Words(f"（照此计算，{agree.zh}{count} 行相符）", f" (computed so, {agree.en}{count} rows agree)")
    )


def _listed(columns: Sequence[Column], which: Sequence[int], zh: str, en: str) -> Words:
    labels = [columns[i].label for i in which]
    return Words(
        f"{'、'.join(label.zh for label in labels)}：{zh}。", f"{', '.join(label.en for label in labels)}: {en}."
    )


def _lost(table: Table, i: int, one: Weighing) -> Words:
    """A column that nothing explains, with the rows that are right all the same."""
    right, count = which(one.right), int(table.columns[i].there.sum())
    if not right:
        return _listed(
            table.columns,
            [i],
            f"{count} 行全部错误，常见错误均不能解释",
            f"wrong in all {count} rows, and no usual slip explains it",
        )
    at = rows_at(table, right)
    return _listed(
        table.columns,
        [i],
        f"{count} 行中有 {count - len(right)} 行错误，仅在 {listed(at)} 相符，常见错误均不能解释",
        f"wrong in {count - len(right)} of {count} rows, right only at {at}, and no usual slip explains it",
    )


def _rows(table: Table, weighed: Sequence[Weighing], told: Told) -> list[Words]:
    """Columns that are wrong in certain rows, explained or not."""
    found = []
    for i, one in enumerate(weighed):
        if rows := which((told[i][0].after if told[i] else one).outliers):
            at = rows_at(table, rows)
            found.append(
                _listed(
                    table.columns,
                    [i],
                    f"有 {len(rows)} 行错误（{listed(at)}）",
                    f"wrong in {len(rows)} row{'s' * (len(rows) > 1)} ({at})",
                )
            )
    return found


def _two_lengths(told: Told) -> tuple[Words, ...]:
    if not any(slips and slips[0].slip is Slip.RATES for slips in told):
        return ()
    return (
        Words(
            "位置与速度、加速度用了同一尺寸的两个取值：整张表不属于任何一个机构。",
            "Positions and rates were computed with two values of one length: the table belongs to no one mechanism.",
        ),
    )
