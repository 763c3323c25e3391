"""Counterweights as the oracle has them: of the centre of mass that they bring to rest."""

from __future__ import annotations

from ...names import Named, Sort
from ...problem.problem import Problem


def weighed_values(problem: Problem) -> dict[str, complex | float]:
    """Key → exact value of what is asked of the counterweights; nothing of a problem without."""
    asked = {ask.rel.key for ask in problem.asks if isinstance(ask.rel, Named) and ask.rel.sort is Sort.BALANCE}
    if problem.counterweights is None or not asked:
        return {}
    from ...oracle.machine.balance import counterweight_values  # late: only where something is asked

    values = counterweight_values(problem.mechanism, problem.counterweights)
    return {key: value for key, value in values.items() if key in asked}
