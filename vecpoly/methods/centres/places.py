"""The place of a point as an answer, with both coordinates as they were read off the rule."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import Row, Txt, row
from ...algebra.worked import spot_in_mm
from ...board.construction import Reading, Scale
from ...plane import Points, Reals, nominal


def place_read(key: str, symbol: str, mm: Points, scale: Scale) -> tuple[Reading, Reals, Points]:
    """The answer (m) from what was read in mm from the origin, and its distance from there and both coordinates by
    every hand."""
    metres = mm * scale.value
    vector = complex(nominal(metres))
    text = Row((*row(symbol).items, Txt(f" = {spot_in_mm(vector)}")))
    return (
        Reading(key=key, symbol=symbol, unit="m", scalar=abs(vector), vector=vector, scale=scale.symbol, formula=text),
        np.abs(metres),
        metres,
    )
