"""Tables of columns over the cycle."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10
from typing import Any

import numpy as np

from ....cycle import Column, Table, table
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....words import Words
from ...flow.style import Style
from ..numbering import SMALL, TINY, Press
from .mirrored import half, mirror, told

_HALVED, _LONG = 6, 12  # a table of few columns and many rows is told in two halves beside each other
_NARROW, _MOST_ABREAST = 3, 3  # columns of one that is told in three parts, where it is long
_MOST = 6  # decimals
_ANGLE = 2  # decimals of degrees
_SPARED = 1  # of four significant digits, in the smaller columns of a quantity
COLUMNS, TIGHT = 9, 12  # beside the input link's position, in small and in tiny type


def tabled(study: Study, press: Press, keys: Sequence[str], title: Words, style: Style = SMALL, every: int = 1) -> str:
    """A table of these columns at the rows of the table, or at every so many of them; half of what is symmetrical."""
    made, repeated = _of_one_period(study, keys, every)
    about = mirror(made)
    shown = made if about is None else half(made, about, given_place(study))
    return laid_out(shown, press, title + repeated, style, _HALVED if study.dense else _HALVED - 1)


def halved(study: Study, keys: Sequence[str], every: int = 1) -> Words:
    """Of what is symmetrical, how the half that is not listed follows from the table; else nothing."""
    made, _ = _of_one_period(study, keys, every)
    about = mirror(made)
    return Words("", "") if about is None else told(made, about, given_place(study))


def given_place(study: Study) -> float:
    """Where the drive stands in the problem, as tables tell it."""
    return float(study.turn.drive.told(study.mech.drive.position))


def _of_one_period(study: Study, keys: Sequence[str], every: int) -> tuple[Table, Words]:
    """These columns over what does not come again, and what the title adds where there is such."""
    parts = dict.fromkeys(part for key in keys for part in study.turn.info(key).parts)
    made = table(study.turn, tuple(part for part in parts if study.varies(part)) or tuple(parts), study.rows[::every])
    made = without_repeat(made) if study.whole.whole else made
    if (period := _repeats_after(made)) < len(made.values):
        again = _repeated(abs(made.values[period, 0] - made.values[0, 0]))
        return replace(made, values=made.values[:period]), again
    return made, Words("", "")


def _repeated(turn: float) -> Words:
    """After how many degrees of the drive all comes again, of which one period is listed."""
    if turn % 360.0 < 1e-6:
        return Words("（每转一周重复，只列一周）", " (the same in every turn; one is listed)")
    return Words(f"（每转 {turn:g}° 重复，只列一个周期）", f" (the same after every {turn:g}°; one period is listed)")


def without_repeat(made: Table) -> Table:
    """The table of a whole turn without its last row, where that is the first again."""
    first, last = made.values[0, 1:], made.values[-1, 1:]
    return replace(made, values=made.values[:-1]) if np.allclose(first, last, 1e-6, 1e-9, equal_nan=True) else made


def _repeats_after(made: Table) -> int:
    """The rows after which all of them come again: of a machine whose period is two turns, those of one turn,
    of what runs round twice in a turn those of half a turn."""
    rows = made.values[:, 1:]
    count, turns = len(rows), abs(made.values[-1, 0] - made.values[0, 0]) / 360.0
    for n in range(2, round(turns) + 2):
        part, left = divmod(count, n)
        if not left and np.allclose(rows, np.tile(rows[:part], (n, 1)), 1e-6, 1e-9, equal_nan=True):
            return part
    return count


def laid_out(made: Table, press: Press, title: Words, style: Style = SMALL, halved: int = _HALVED) -> str:
    """A table of a cycle on the page; one of few columns (up to `halved`) in two halves beside each other."""
    header = [_head(column) for column in made.columns]
    formats = _formats(made.columns, made.values)
    body = [
        tuple(decimal(value, places) for value, places in zip(row, formats, strict=True))
        for row in made.values.tolist()
    ]
    blocks = 1
    if len(header) <= halved and len(body) > _LONG:
        blocks = _MOST_ABREAST if len(header) <= _NARROW and len(body) > 2 * _LONG else 2
    columns = blocks * (len(header) + 1) - 1  # with a blank one between two blocks
    style = TINY if columns > TIGHT else style
    return press.table(title, header, body, "r" * len(header), style=style, blocks=blocks)


def _head(column: Column) -> str:
    unit = column.shown_unit.replace("^2", "²").replace("·", "·")
    return f"${column.symbol}$" + (f" /({unit})" if "/" in unit or "·" in unit else f" /{unit}" if unit else "")


def _formats(columns: Sequence[Column], values: Any) -> list[int]:
    """Decimals of each column, the same for all of one quantity: of angles two, else as few as leave the smallest
    column three significant digits."""
    own = [_decimals(values[:, i]) for i in range(len(columns))]
    kinds = [(column.key.partition("_")[0], column.unit) for column in columns]
    found = []
    for n, kind in zip(own, kinds, strict=True):
        alike = [m for m, other in zip(own, kinds, strict=True) if other == kind and m is not None] or [0]
        found.append(
            _ANGLE * (n is not None) if kind[1] == "rad" else min(_MOST, max(max(alike) - _SPARED, min(alike)))
        )
    return found


def _decimals(values: Any) -> int | None:
    """As many decimals as give the largest number four significant digits; None where all are whole numbers."""
    known = np.abs(values[np.isfinite(values)])
    top = float(known.max()) if known.size else 0.0
    if not top or np.allclose(known, np.round(known), rtol=1e-12, atol=1e-9):
        return None
    return int(max(0, 3 - floor(log10(top))))


def decimal(value: float, places: int) -> str:
    if not np.isfinite(value):
        return "—"
    text = f"{value:.{places}f}"
    return (text.lstrip("-") if float(text) == 0 else text).replace("-", "−")
