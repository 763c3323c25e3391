"""What is concluded of a synthesis that no linkage solves: why each candidate is rejected, and what is admissible."""

from __future__ import annotations

from ...designs.base import Design
from ...designs.verdict import Verdict
from ...oracle.synthesis.registry import linkages, solvable
from ...problem.problem import Problem
from ...words import Words
from .admissible import admissible


def conclusion(problem: Problem) -> Words | None:
    """The reasons, each with the numbers of its candidates, and a range where one is known; None where there is a
    solution after all, and of other problems."""
    design = problem.subject
    if not isinstance(design, Design) or solvable(design):
        return None
    reasons: dict[Verdict, list[int]] = {}
    for number, one in enumerate(linkages(design), 1):
        reasons.setdefault(one.verdict, []).append(number)
    told = Words("没有机构满足所给条件。", "No linkage satisfies the conditions.")
    for verdict, numbers in reasons.items():
        told += _rejected(numbers, verdict)
    return told if (known := admissible(design)) is None else told + known


def _rejected(numbers: list[int], verdict: Verdict) -> Words:
    why, zh, en = verdict.value, "、".join(map(str, numbers)), ", ".join(map(str, numbers))
    many = "s" if len(numbers) > 1 else ""
    return Words(f"候选解 {zh} 舍去：{why.zh}。", f" Candidate{many} {en} rejected: {why.en}.")
