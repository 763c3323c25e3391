"""A unit that all numbers of a column have stands in its head."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..algebra.rounding import braced

_CELL = re.compile(r"((?:< )?[+−±]?\d[\d.]*) ?([^\d\s*$,;.]\S*)")  # a number and its unit
_SIZE = r"((?:.*≙ )?[+−-]?\d[\d.]*(?:×10\^\S+)?)"
_TOLD = re.compile(_SIZE + r" ?([^\d\s（(]\S*?)?((?:（.*）| \(.*\))?)")  # a number, its unit, what is said of it
_BARE = ("", "—", "0", "∞")  # what has none
_LEAST = 2  # numbers of a column


def united(header: Sequence[str], rows: Sequence[Sequence[str]]) -> tuple[list[str], list[tuple[str, ...]]]:
    """Heads and rows, each unit of a whole column in its head: φ_1 /°, and 12.2 for 12.2°."""
    heads, columns = list(header), [list(column) for column in zip(*rows, strict=True)]
    for n, column in enumerate(columns):
        told = [_CELL.fullmatch(cell) for cell in column if cell not in _BARE]
        units = {one[2] if one else "" for one in told}
        again = header.count(header[n]) > 1  # of blocks beside each other all heads are alike
        if len(told) < _LEAST or len(units) != 1 or not all(units) or " /" in heads[n] or again:
            continue
        heads[n] = f"{heads[n]} /{braced(*units)}"
        columns[n] = [cell if cell in _BARE else _CELL.sub(r"\1", cell) for cell in column]
    return heads, [tuple(row) for row in zip(*columns, strict=True)]


def unit_column(rows: Sequence[Sequence[str]], columns: Sequence[int]) -> list[tuple[str, ...]] | None:
    """The rows with the unit that these cells of each share in a column of its own, the second; None where one of them
    has cells of two units, or no number."""
    found = []
    for row in rows:
        told = [_TOLD.fullmatch(row[n]) for n in columns]
        units = {(one[2] or "—").replace("²", "^2") for one in told if one is not None}
        if None in told or len(units) != 1:
            return None
        bare = {n: one[1] + one[3] for n, one in zip(columns, told, strict=True) if one is not None}
        cells = [bare.get(n, cell) for n, cell in enumerate(row)]
        found.append((cells[0], *units, *cells[1:]))
    return found
