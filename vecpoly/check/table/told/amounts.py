"""How amounts, places and rows of a table are told."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

import numpy as np

from ....foundation.runs import runs
from ..columns import Table, shown_position
from ..weigh import Column, Mask

MANY = 12  # positions that are listed one by one


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
    parts = runs(rows)
    ends = [[run[0], run[-1]] if len(run) > 2 else run for run in parts]
    texts = [
        "–".join(shown_position(float(table.printed[k]), table.slide) for k in end)
        if len(run) > 2
        else ", ".join(shown_position(float(table.printed[k]), table.slide) for k in end)
        for run, end in zip(parts, ends, strict=True)
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
