"""What is told of the wrong rows of a column: its numbers, whether the cycle closes, whether they were typed over."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....oracle.run import wrapped
from ....words import Words
from ...slips.explain import Explanation
from ..columns import Table, shown_position
from ..weigh import LAST_DIGIT, Column, Level, Weighing
from .amounts import amount, spaced

FEW_NUMBERS = 3  # wrong numbers that are told one by one
Told = Sequence[tuple[Explanation, ...]]


def numbers(table: Table, i: int, one: Weighing, rows: Sequence[int]) -> Words:
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


def closing(table: Table, column: Column) -> Words:
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


def typed_over(table: Table, i: int, rows: Sequence[int], weighed: Sequence[Weighing], told: Told) -> Words:
    """Other columns of the same link that are right, or wrong by one rule,
    in just these rows show that only the number was changed."""
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
