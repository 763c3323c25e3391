"""A torsion spring as a spiral about the pin of its two links."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ...board.paper.marks import Role, Segment
from ...board.paper.symbols import Symbol
from ...board.strokes import spot
from ...plane import Points
from .straight import OWNER

TURNS, INNER, OUTER = 1.75, 2.2, 4.6  # of the spiral; its radii (mm)


def coil_symbol(at: Points) -> Symbol:
    """A spiral about a pin."""
    share = np.linspace(0.0, 1.0, 36)
    spiral = spot(at) + (INNER + (OUTER - INNER) * share) * np.exp(2j * np.pi * TURNS * share)
    points = [complex(place) for place in spiral]
    return Symbol.of(OWNER, tuple(Segment(a=p, b=q, role=Role.GIVEN) for p, q in pairwise(points)))
