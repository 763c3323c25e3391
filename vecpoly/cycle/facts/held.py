"""What is to be said of a cycle of several drives."""

from __future__ import annotations

from collections.abc import Iterator

from ...words import Words
from ..cycle import Cycle


def held(cycle: Cycle) -> Iterator[Words]:
    """Of several drives: that the first alone is taken through the cycle."""
    for drive in cycle.mech.drives[1:]:
        yield Words(
            f"其余原动件不随之移动：构件 {drive.link} 在各行均处于给定位置，速度、加速度按给定值计，"
            "各行是该位置的瞬时状态，不是连续运动。",
            f"The other drive does not move on with it: link {drive.link} stands where it is given in every row, with "
            "its given speed and acceleration, so that each row is a state by itself and they are no motion.",
        )
