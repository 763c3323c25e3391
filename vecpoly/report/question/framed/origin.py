"""The origin of a frame off which coordinates are read: short axes with their letters."""

from __future__ import annotations

from collections.abc import Iterator

from ....board.paper.marks import Mark, Note, Role, Vector
from ....words import Words
from .through import EDGE, Box

ORIGIN = "origin"  # of its marks
_LONG = 12.0  # mm of an axis


def origin(box: Box) -> Iterator[Mark]:
    """Both axes, from the origin of the drawing; none where it lies off the frame."""
    low, high = box[0] + complex(EDGE, EDGE), box[1] - complex(EDGE, EDGE)
    if low.real <= 0.0 <= high.real - _LONG and low.imag <= 0.0 <= high.imag - _LONG:
        for way, letter in ((1 + 0j, "x"), (1j, "y")):
            yield Vector(a=0j, b=_LONG * way, role=Role.DIRECTION, step=1, key=ORIGIN)
            yield Note(at=_LONG * way, words=Words.same(f"${letter}$"), side=way, step=1, key=ORIGIN)
