"""What is told of a chain in the line of what is given: its figure, and which links drive."""

from __future__ import annotations

from collections.abc import Sequence

from ..words import Words

FIGURE = Words("机构示意图（见图）", "the diagram of the mechanism (see the figure)")


def told_drivers(sets: Sequence[Sequence[str]]) -> Words:
    """Which links drive; of several possibilities each."""
    zh = "，或 ".join("、".join(links) for links in sets)
    en = " or ".join(" and ".join(links) for links in sets)
    many = "s" if len(sets) == 1 and len(sets[0]) > 1 else ""
    return Words(f"原动件为构件 {zh}", f"input link{many} {en}")
