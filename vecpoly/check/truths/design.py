"""A task of synthesis: the closed solutions under the keys of what is asked; its data are taken as they are written."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from ...designs.base import Design, numbered
from ...designs.verdict import Verdict
from ...errors import NotAskedError, VecpolyError
from ...foundation.frozen import FrozenMap
from ...names import Rel
from ...oracle.synthesis.registry import Linkage, candidates, counted, design_answers, linkages, solvable
from ...problem.problem import Printed, Problem
from ...words import Words
from ..designs.unsolvable import answered_or_ranged
from ..nudged import TRIALS, nudged_data
from ..truth import ActsAt, Values, finite, knows


@knows(Design)
@dataclass(frozen=True)
class DesignTruth:
    """The oracle's opinion of a task of synthesis."""

    problem: Problem
    likely: Mapping[str, float] = FrozenMap({"deg": 1.0})  # where the largest angle is nothing but rounding
    lines: Mapping[str, ActsAt] = FrozenMap({})

    @property
    def design(self) -> Design:
        """What is asked of the linkage that is to be found."""
        assert isinstance(self.problem.subject, Design)
        return self.problem.subject

    @cached_property
    def values(self) -> Values:
        """Key → exact value, of all that is asked; where no linkage serves, of what has a value all the same.

        Raises NotAskedError for one solution more than there are.
        """
        found, asked = answered_or_ranged(self.design), [ask.rel.key for ask in self.problem.asks]
        if not solvable(self.design):
            return finite({key: found[key] for key in asked if key in found})
        for key in asked:
            if key not in found:
                raise self._no_such(key)
        return finite({key: found[key] for key in asked})

    def _no_such(self, key: str) -> NotAskedError:
        count = sum(one.verdict is Verdict.VALID for one in linkages(self.design))
        return NotAskedError(
            Words(
                f"{key}：可用的解只有 {count} 个；请改编号，或从 find 中去掉",
                f"{key}: {counted(count)}; choose another number, or leave it out of `find`",
            ),
            code="no-solution",
            numbers={"solutions": count},
        )

    @property
    def nearby(self) -> tuple[Values, ...]:
        """The values with nudged data, of the linkages that lie nearest to those that serve."""
        return _nearby(self.design)

    @property
    def others(self) -> Mapping[int, Mapping[str, float]]:
        """The valid ones after the first; none where a certain one is to be taken."""
        if self.design.take != 1:
            return {}
        valid = [one for one in linkages(self.design) if one.verdict is Verdict.VALID]
        return {number: one.values for number, one in enumerate(valid[1:], 2)}

    def known(self, rel: Rel) -> None:
        """Nothing: a linkage that is to be found has no motion yet."""

    def behind(self) -> Callable[[Printed], float | None]:
        """Sizes behind printed answers, asked for or not."""
        found = design_answers(self.design)
        return lambda printed: found.get(printed.rel.key) if printed.rel else None

    def way(self) -> Callable[[Printed], complex | None]:
        """No answer has a direction."""
        return lambda printed: None


@lru_cache(maxsize=256)
def _nearby(design: Design) -> tuple[Values, ...]:
    rng = np.random.default_rng(0)
    nudges = (nudged_data(design, rng) for _ in range(TRIALS))
    valid = [one for one in linkages(design) if one.verdict is Verdict.VALID]
    return tuple(_followed(design, valid, found) for one in nudges if (found := _candidates(one)))


def _candidates(design: Design) -> tuple[Linkage, ...]:
    """What fits the data; none where what is sought ends within the nudge."""
    try:
        return candidates(design)
    except VecpolyError:
        return ()


def _followed(design: Design, valid: Sequence[Linkage], found: Sequence[Linkage]) -> Values:
    """The values of those found that lie nearest to the valid ones, whatever number they would have: a hair's breadth
    may turn a verdict, or the order."""
    near = [min(found, key=lambda one: _apart(one, mine)) for mine in valid]
    values: Values = dict(near[design.take - 1].values) if design.take <= len(near) else {}
    for n, one in enumerate(near, 1):
        values |= {
            numbered(named, n).key: one.values[named.key] for named in design.quantities() if named.key in one.values
        }
    return values


def _apart(one: Linkage, other: Linkage) -> float:
    """How far two linkages are apart: by their pins, and where those are the same by what they are numbered by."""
    pins = sum(abs(one.pins[name] - at) for name, at in other.pins.items() if name in one.pins)
    return pins + sum(abs(a - b) for a, b in zip(one.order, other.order, strict=False))
