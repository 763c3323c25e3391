"""Which of several solutions of a synthesis transmits force best, as it moves with the lengths read, and which do it
poorly."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite

from ...cycle.facts.transmission_range import ABOUT
from ...solution import Solution
from ...words import Lang, Words, joined

_ALIKE = 1.0  # degrees: of two least transmission angles that are nearer neither is preferred


def moved_told(solution: Solution, lang: Lang) -> str:
    """What is to be preferred, in a sentence; of one solution, that it transmits force poorly, if it does."""
    best = _alone(solution) if len(solution.verification) == 1 else preferred(solution)
    return "" if best is None else best.of(lang)


def _alone(solution: Solution) -> Words | None:
    """That the only solution is below the usual bound, in a full turn or between the given positions."""
    (one,) = solution.verification
    if one.broken is not None or not (one.gamma if one.full else one.between) < ABOUT:
        return None
    return Words(
        "最小传动角小于许用值 [$γ$] = 40°，传力性能较差。",
        "The minimum transmission angle is below the usual bound of 40°: force is transmitted poorly there.",
    )


def preferred(solution: Solution) -> Words | None:
    """Which solution has the largest γ_min, and which are below the usual bound; None where there is no choice."""
    turning = [one for one in solution.verification if one.broken is None and one.full and isfinite(one.gamma)]
    if len(turning) < 2:
        return None
    best, second, *_ = sorted(turning, key=lambda one: -one.gamma)
    low = [one.number for one in turning if one.gamma < ABOUT]
    first = best.number if best.gamma - second.gamma > _ALIKE else 0
    told = list(_all_low(first) if len(low) == len(turning) else _some_low(first, low))
    return Words("；".join(one.zh for one in told) + "。", "; ".join(one.en for one in told) + ".") if told else None


def _all_low(first: int) -> Iterator[Words]:
    yield Words(
        "各解的 $γ_{min}$ 均小于许用值 [$γ$] = 40°，传力性能较差",
        "In every solution $γ_{min}$ is below the usual bound of 40°",
    )
    if first:
        yield Words(f"解 {first} 的较大，相比之下宜选用", f"solution {first}, in which it is largest, is preferable")


def _some_low(first: int, low: Sequence[int]) -> Iterator[Words]:
    if first:
        yield Words(
            f"解 {first} 的 $γ_{{min}}$ 最大，传力性能最好，宜优先选用",
            f"Solution {first}, with the largest $γ_{{min}}$, transmits force best and is preferable",
        )
    if low:
        named = joined([Words.same(f"{number}") for number in low])
        yield Words(
            f"解 {named.zh} 的 $γ_{{min}}$ 小于许用值 [$γ$] = 40°",
            f"{'in' if first else 'In'} solution{'s' if len(low) > 1 else ''} {named.en} $γ_{{min}}$ is below the "
            "usual bound of 40°",
        )
