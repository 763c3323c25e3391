"""The linkages that a synthesis found on paper beside those of the closed solution: the same ones, with the same
verdicts."""

from __future__ import annotations

from collections.abc import Mapping

from ..designs.base import Design
from ..designs.verdict import Verdict
from ..oracle.synthesis.registry import linkages
from ..problem.problem import Problem
from ..words import Words


def objection(problem: Problem, verdicts: Mapping[int, str]) -> Words | None:
    """What is to be said where the candidates on paper (number: verdict) are not those of the oracle."""
    exact = {number: one.verdict.name for number, one in enumerate(linkages(problem.design), 1)}
    if dict(verdicts) == exact:
        return None
    drawn, there = _told(verdicts), _told(exact)
    return Words(
        f"图上的候选解（{drawn.zh}）与解析所得（{there.zh}）不符，不得采用",
        f"The candidates on paper ({drawn.en}) are not those of the closed solution ({there.en}): not to be used",
    ) + _what(verdicts, exact)


def exact(design: Design) -> tuple[Mapping[str, float], ...]:
    """The values of each valid solution by the closed form, in the order of their numbers (mm, deg)."""
    return tuple(one.values for one in linkages(design) if one.verdict is Verdict.VALID)


def _told(verdicts: Mapping[int, str]) -> Words:
    """How many, and how many of them are any use."""
    valid = sum(name == Verdict.VALID.name for name in verdicts.values())
    return Words(f"{len(verdicts)} 个，{valid} 个可用", f"{len(verdicts)}, {valid} valid")


def _what(drawn: Mapping[int, str], exact: Mapping[int, str]) -> Words:
    """Which of them are lost, which there are not, of which the verdict is another."""
    parts = [
        _named(sorted(exact.keys() - drawn.keys()), Words("未作出", "not found")),
        _named(sorted(drawn.keys() - exact.keys()), Words("并不存在", "not there in truth")),
        _named(sorted(n for n in exact if drawn.get(n, exact[n]) != exact[n]), Words("判定不同", "judged otherwise")),
    ]
    told = [part for part in parts if part is not None]
    return Words("：" + "；".join(w.zh for w in told) + "。", " (" + "; ".join(w.en for w in told) + ").")


def _named(numbers: list[int], what: Words) -> Words | None:
    if not numbers:
        return None
    listed = ", ".join(map(str, numbers))
    return Words(f"解 {listed.replace(', ', '、')} {what.zh}", f"candidate {listed}: {what.en}")
