"""Why a problem has no cycle, and what to do."""

from __future__ import annotations

from ..designs.base import Design
from ..words import Words
from .problem import Problem


def no_cycle(problem: Problem) -> Words:
    """Of a problem that is about no mechanism: a synthesis finds one, a device has none."""
    if isinstance(problem.subject, Design):
        return Words(
            f"题目 {problem.id} 是机构综合题，本身没有运动循环；请加 --then analyse，"
            "改用求得的机构（Python 中为 solution.linkage）",
            f"problem {problem.id} is a synthesis, which has no cycle of its own; add --then analyse to go on with the "
            "linkage that it finds (in Python, solution.linkage)",
        )
    return Words(
        f"题目 {problem.id} 是机械装置题，或是未给尺寸的机构，没有运动循环；须为有 input 的机构",
        f"problem {problem.id} is about a device, or a structure without dimensions, and has no cycle; a cycle needs a "
        "mechanism with an input",
    )
