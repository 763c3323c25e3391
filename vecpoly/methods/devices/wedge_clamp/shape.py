"""The outline of a clamping wedge."""

from __future__ import annotations

from ....plane import Points, nominal

LENGTH, TIP, DEEP = 46.0, 3.0, 11.0  # mm: of the wedge; its thin end; the bodies that it clamps
OUT = -1 + 0j  # the way on which the wedge slips out


def corners(slope: Points) -> tuple[Points, ...]:
    """The wedge: thick end at the left, below and above, thin end at the right."""
    thin = complex(LENGTH, 0)
    over = thin + TIP * 1j
    return 0j, thin, over, over - slope * (LENGTH / nominal(slope.real))
