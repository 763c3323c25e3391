"""What is told where a design has more solutions than are asked for: which one is answered, and how the others are."""

from __future__ import annotations

from ...names import Named
from ...problem.problem import Problem
from ...words import Words
from ..truth import OfSeveral, Truth


def several_of(problem: Problem, truth: Truth) -> Words | None:
    """None where there is one, or where another is asked for as well."""
    others = truth.others if isinstance(truth, OfSeveral) else {}
    named = [ask.rel for ask in problem.asks]
    if not others or not named or any(isinstance(rel, Named) and rel.solution in others for rel in named):
        return None
    whole = max(others)
    apart = {
        key: abs(value - mine) for key, mine in truth.values.items() if (value := others[whole].get(key)) is not None
    }
    if not apart:
        return None
    key = max(apart, key=lambda one: apart[one])
    return Words(
        f"共有 {whole} 个解，所答为解 1；要另一个，请在 find 中写如 {key}_{whole}，或 take: {whole}",
        f"there are {whole} solutions, and these answers are of the first; for another ask e.g. {key}_{whole}, or "
        f"write take: {whole}",
    )
