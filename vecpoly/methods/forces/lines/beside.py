"""Where the arm without friction stands on the diagram: an arm may be measured anywhere between two parallel lines."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Block, Point, Role, Segment, Slot
from ....plane import Points, nominal
from ..state import Statics

STEPS = (14.0, -14.0, 20.0, -20.0, 26.0, -26.0)  # mm along the lines
CLEAR = 6.0  # mm from what is drawn: farther is not better
BETWEEN = np.linspace(0.1, 0.9, 9)  # places on the arm that are to be clear


def clear_of(st: Statics, at: Points, across: Points, along: Points) -> float:
    """How far (mm along the lines) the arm from `at` to `across` is to be shifted to stand clear of the links,
    and of the arm with friction, which will stand about where it was itself."""
    a, b, u = (complex(nominal(z)) for z in (at, across, along))
    own = a + (b - a) * BETWEEN
    drawn = np.concatenate([own, _drawn(st)])
    clear = {step: min(float(np.abs(own[:, None] + u * step - drawn).min()), CLEAR) for step in STEPS}
    return max(STEPS, key=lambda step: clear[step])


def _drawn(st: Statics) -> np.ndarray:
    """Places on the links, the slots, the blocks and the letters of the diagram."""
    found: list[complex] = []
    for mark in st.board.marks(View.MECHANISM):
        match mark:
            case Segment(a=a, b=b, role=Role.LINK) | Slot(a=a, b=b):
                found += [a + (b - a) * t for t in np.linspace(0.0, 1.0, 25)]
            case Point(at=here) | Block(at=here):
                found.append(here)
            case _:
                pass
    return np.array(found, dtype=complex)
