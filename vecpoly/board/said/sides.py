"""The sides of a place on paper, in words."""

from __future__ import annotations

from ...words import Words


def side_of(out: complex) -> Words:
    """下, lower: on which side of a circle a line lies that touches it at the end of this radius."""
    if abs(out.imag) >= abs(out.real):
        return Words("上", "upper") if out.imag > 0 else Words("下", "lower")
    return Words("右", "right-hand") if out.real > 0 else Words("左", "left-hand")
