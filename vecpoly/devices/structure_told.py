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


def structure_task(frame: str, *, touching: bool, driven: bool) -> Words:
    """Of which figure the structure is analysed; frame: its number as printed, where it has one; touching: with higher
    pairs; driven: whether an input link is named."""
    whose = Words(f"（构件 {frame} 为机架）", f" (link {frame} is the frame)") if frame else Words("", "")
    low = Words("，作高副低代", ", replace the higher pairs by lower ones") if touching else Words("", "")
    groups = (
        Words(
            "，按给定的原动件拆分杆组，确定机构的级别",
            ", take it apart into Assur groups and find its class for the input link given",
        )
        if driven
        else Words("", "")
    )
    return Words(
        f"计算图示平面机构{whose.zh}的自由度{low.zh}{groups.zh}。",
        f"Count the degree of freedom of the plane mechanism in the figure{whose.en}{low.en}{groups.en}.",
    )
