"""A task of synthesis: the closed solutions under the keys of what is asked; its data are taken as they are written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from ...designs.base import Design
from ...designs.verdict import Verdict
from ...errors import NotAskedError
from ...foundation.frozen import FrozenMap
from ...names import Rel
from ...oracle.synthesis.registry import counted, design_answers, linkages, solvable
from ...problem.problem import Printed, Problem
from ...words import Words
from ..truth import ActsAt, Values, finite, knows


@knows(Design)
@dataclass(frozen=True)
class DesignTruth:
    """The oracle's opinion of a task of synthesis."""

    problem: Problem
    likely: Mapping[str, float] = FrozenMap({})
    lines: Mapping[str, ActsAt] = FrozenMap({})
    nearby: tuple[Values, ...] = ()

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
        found, asked = design_answers(self.design), [ask.rel.key for ask in self.problem.asks]
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

    def known(self, rel: Rel) -> None:
        """Nothing: a linkage that is to be found has no motion yet."""

    def behind(self) -> Callable[[Printed], float | None]:
        """Sizes behind printed answers, asked for or not."""
        found = design_answers(self.design)
        return lambda printed: found.get(printed.rel.key) if printed.rel else None

    def way(self) -> Callable[[Printed], complex | None]:
        """No answer has a direction."""
        return lambda printed: None
