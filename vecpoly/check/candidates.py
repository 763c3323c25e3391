"""The linkages that a synthesis found on paper beside those of the closed solution: as many, with the same verdicts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..designs.base import Design
from ..designs.verdict import Verdict
from ..oracle.synthesis.registry import linkages
from ..problem.problem import Problem
from ..words import Words


def objection(problem: Problem, verdicts: Sequence[str]) -> Words | None:
    """What is to be said where the candidates on paper (their verdicts by number) are not those of the oracle."""
    if not isinstance(problem.subject, Design):
        return None
    exact = [one.verdict.name for one in linkages(problem.subject)]
    if list(verdicts) == exact:
        return None
    drawn, there = _told(verdicts), _told(exact)
    return Words(
        f"图上的候选解（{drawn.zh}）与解析所得（{there.zh}）不符，不得采用。",
        f"The candidates on paper ({drawn.en}) are not those of the closed solution ({there.en}): not to be used.",
    )


def exact(design: Design) -> tuple[Mapping[str, float], ...]:
    """The values of each valid solution by the closed form, in the order of their numbers (mm, deg)."""
    return tuple(one.values for one in linkages(design) if one.verdict is Verdict.VALID)


def _told(verdicts: Sequence[str]) -> Words:
    """How many, and how many of them are any use."""
    valid = sum(name == Verdict.VALID.name for name in verdicts)
    return Words(f"{len(verdicts)} 个，{valid} 个可用", f"{len(verdicts)}, {valid} valid")
