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
    """The rows of a table of one turn that are each other's images have this sum (so half of it is where the motion is
    symmetrical, at a row or between two); the columns that stay, change their sign, or (angles) become so many degrees
    less themselves."""

    sum: int
    even: tuple[Column, ...]
    odd: tuple[Column, ...]
    turned: tuple[tuple[Column, float], ...]


def mirror(made: Table) -> Mirror | None:
    """How the table of a whole turn, without its last row, is symmetrical; None where it is not."""
    count = len(made.values)
    if count % 2 or made.columns[0].shown_unit != "°" or not _is_one_turn(made.values[:, 0]):
        return None
    found = (_about(made, total) for total in range(count))
    return next((one for one in found if one is not None), None)


def half(made: Table, about: Mirror, near: float) -> Table:
    """The rows on that side of the line of symmetry on which the drive stands so (degrees), in order: 90° to 270°, or
    −90° to 90°."""
    count, at = len(made.values), made.values[:, 0]
    first, rows = -(-about.sum // 2), count // 2 + (about.sum % 2 == 0)
    step, axis = at[1] - at[0], (at[0] + (at[1] - at[0]) * about.sum / 2)
    if (near - axis) / step % count > count / 2:
        first += count // 2
    values = made.values[np.arange(first, first + rows) % count].copy()
    values[:, 0] = at[0] + step * np.arange(first, first + rows)
    values[:, 0] -= _TURN * (abs(values[-1, 0] - at[0]) > _TURN + _RELATIVE) * np.sign(step)
    return replace(made, values=values)


def told(made: Table, about: Mirror, near: float) -> Words:
    """With 360° − φ in place of φ these change their sign, those do not."""
    drive, at, shown = made.columns[0].symbol, made.values[:, 0], half(made, about, near).values[:, 0]
    whole = 2 * at[0] + (at[1] - at[0]) * about.sum
    other = f"{whole or _TURN:g}° − ${drive}$"
    low, high = (f"{angle:g}".replace("-", "−") for angle in (shown[0], shown[-1]))
    zh, en = zip(*_kinds(about), strict=True)
    return Words(
        f"所列各量具有对称性：${drive}$ 换为 {other} 时，{'，'.join(zh)}，故只列 {low}° 至 {high}°。",
        f"What is listed is symmetrical: with {other} in place of ${drive}$, {', '.join(en)}; {low}° to {high}° are "
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


def _about(made: Table, total: int) -> Mirror | None:
    count = len(made.values)
    order = (total - np.arange(count)) % count
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
    return Mirror(total, tuple(even), tuple(odd), tuple(turned))
