"""Through which positions of the drive centrodes are drawn: by them the sum of their chords is determined."""

from __future__ import annotations

from ...mechanism.asked.curvature import between
from ...problem.problem import Problem
from ...words import Words


def centrodes_asked(problem: Problem) -> Words:
    """Behind what is asked; nothing where no centrodes are."""
    curvature = problem.curvature
    if curvature is None or curvature.centrodes is None:
        return Words.same("")
    asked = curvature.centrodes
    ends = between(problem.mechanism, asked)
    return Words(
        f"（瞬心线取 {ends.zh} 等分的 {asked.positions} 个位置）",
        f" (centrodes through {asked.positions} equally spaced positions, {ends.en})",
    )
