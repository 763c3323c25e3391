"""Tables of a motion that is symmetrical over the turn: half of the rows tell all, and a sentence the other half."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ....cycle import Column, Table
from ....foundation.slotted import dataclass, replace
from ....words import Words

_TURN = 360.0  # degrees of the drive
_RELATIVE, _NOTHING = 1e-6, 1e-9  # of a column's largest value: alike; rounding

Reals = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Mirror:
    """The row about which a table of one turn is symmetrical, and the columns that stay, change their sign, or (angles)
    become so many degrees less themselves."""

    row: int
    even: tuple[Column, ...]
    odd: tuple[Column, ...]
    turned: tuple[tuple[Column, float], ...]


def mirror(made: Table) -> Mirror | None:
    """How the table of a whole turn, without its last row, is symmetrical; None where it is not."""
    count = len(made.values)
    if count % 2 or made.columns[0].shown_unit != "°" or not _is_one_turn(made.values[:, 0]):
        return None
    found = (_about(made, row) for row in range(count // 2))
    return next((one for one in found if one is not None), None)


def half(made: Table, about: Mirror) -> Table:
    """The rows from one place of symmetry to the other."""
    return replace(made, values=made.values[about.row : about.row + len(made.values) // 2 + 1])


def told(made: Table, about: Mirror) -> Words:
    """With 360° − φ in place of φ these change their sign, those do not."""
    drive, at = made.columns[0].symbol, made.values[:, 0]
    low, high = at[about.row], at[about.row + len(at) // 2]
    other = f"{2 * low if low > at[0] else 2 * high:g}° − ${drive}$"
    zh, en = zip(*_kinds(about), strict=True)
    return Words(
        f"运动具有对称性：${drive}$ 换为 {other} 时，{'，'.join(zh)}，故只列 {low:g}° 至 {high:g}°。",
        f"The motion is symmetrical: with {other} in place of ${drive}$, {', '.join(en)}; {low:g}° to {high:g}° are "
        "listed. ",
    )


def _kinds(about: Mirror) -> Iterator[tuple[str, str]]:
    if about.odd:
        yield f"{_listed(about.odd, '、')} 变号", f"{_listed(about.odd, ', ')} change{'s' * (len(about.odd) == 1)} sign"
    for column, whole in about.turned:
        now = f"{round(whole, 2):g}° − ${column.symbol}$"
        yield f"${column.symbol}$ 变为 {now}", f"${column.symbol}$ becomes {now}"
    if about.even:
        rest = bool(about.odd or about.turned)
        yield ("其余各量不变", "all else stays") if rest else ("各量不变", "all stays as it is")


def _listed(columns: Sequence[Column], comma: str) -> str:
    return comma.join(f"${column.symbol}$" for column in columns)


def _is_one_turn(at: Reals) -> bool:
    steps = np.diff(at)
    return bool(np.allclose(steps, steps[0])) and abs(abs(len(at) * steps[0]) - _TURN) < _RELATIVE


def _about(made: Table, row: int) -> Mirror | None:
    count = len(made.values)
    order = (2 * row - np.arange(count)) % count
    even, odd, turned = list[Column](), list[Column](), list[tuple[Column, float]]()
    for column, values in zip(made.columns[1:], made.values.T[1:], strict=True):
        if not np.isfinite(values).all():
            return None
        other, slack = values[order], _NOTHING + _RELATIVE * float(np.abs(values).max())
        both = values + other
        if np.abs(values - other).max() <= slack:
            even.append(column)
        elif np.abs(both).max() <= slack:
            odd.append(column)
        elif column.shown_unit == "°" and np.ptp(both) <= slack:
            turned.append((column, float(both.mean())))
        else:
            return None
    return Mirror(row, tuple(even), tuple(odd), tuple(turned))
