"""From where the travel along a guide is counted, and which way."""

from __future__ import annotations

from math import isclose, pi

from ..words import Words
from .model import Prismatic


def counted_from(joint: Prismatic) -> Words:
    """自 K 点起, from K: the letter from which the guide is set out;
    of a guide x = c or y = c the axis that it crosses."""
    if joint.through:
        return Words(f"自 ${joint.through}$ 点", f"from ${joint.through}$")
    if upright(joint):
        return Words("自 $x$ 轴向上", "upwards from the $x$ axis")
    return Words("自 $y$ 轴向右", "to the right from the $y$ axis")


def upright(joint: Prismatic) -> bool:
    """Whether the travel counts along the y axis."""
    return isclose(joint.direction, pi / 2)


def travel_words(link: str, joint: Prismatic) -> Words:
    """What s of a link means, after 已知."""
    start = counted_from(joint)
    return Words(f"$s_{link}$ {start.zh}量起", f"$s_{link}$ counts {start.en}")
