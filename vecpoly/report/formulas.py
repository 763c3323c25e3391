"""Short display formulas set beside each other."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from ..algebra.formula import Node, Row, Txt
from ..typeset import layout
from .flow.style import BODY

_ROOM, _BETWEEN, _GAP = 138.0, 14.0, ",\u2003\u2003"  # mm


def beside(nodes: Sequence[Node], most: int, short: float = inf) -> list[Node]:
    """Up to `most` formulas to a line, as far as there is room; those longer than `short` (mm) stand alone."""
    rows: list[list[Node]] = []
    used = inf
    for node in nodes:
        wide = layout(node, BODY.em).width
        if rows and len(rows[-1]) < most and wide <= short and used + _BETWEEN + wide <= _ROOM:
            rows[-1].append(node)
            used += _BETWEEN + wide
        else:
            rows.append([node])
            used = wide if wide <= short else inf
    return [
        row[0]
        if len(row) == 1
        else Row(tuple(n for i, one in enumerate(row) for n in ((Txt(_GAP), one) if i else (one,))))
        for row in rows
    ]
