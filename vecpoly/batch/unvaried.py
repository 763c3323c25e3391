"""A problem that is the same for everybody: what is demoted is what its own key demotes."""

from __future__ import annotations

from ..grading.derive.keyed import answer_key
from ..problem.problem import Problem
from ..variants.judge import Standard
from ..variants.pilot import Pilot


def same_for_all(problem: Problem) -> Pilot:
    """The pilot of a problem without ranges."""
    demoted = frozenset(one.key for one in answer_key(problem).quantities if one.asked and one.demoted)
    asked = tuple(dict.fromkeys(ask.rel.key for ask in problem.asks))
    return Pilot(
        standard=Standard(work=(), meeting=0.0, signs={}, demoted=demoted), passed=1.0, failed={}, asked=asked, slips=0
    )
