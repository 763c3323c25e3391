"""What every search has: a box of parameters, a score, and the linkage that a point of the box stands for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..foundation.slotted import dataclass
from ..problem.problem import Problem
from ..words import Words

Reals = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure:
    """What was reached, measured by the general solver on the linkage as it is written."""

    name: Words
    value: float
    unit: str


class Search(Protocol):
    """A search: `score` is to be least; it is infinite where a candidate is none."""

    @property
    def box(self) -> tuple[Reals, Reals]:
        """Lower and upper bounds of the parameters, shape (k,)."""

    def score(self, x: Reals) -> Reals:
        """Of candidates of shape (m, k), shape (m,)."""

    def possible(self, x: Reals) -> NDArray[np.bool_]:
        """Which of them are linkages of the kind that is sought, at the price of a few products."""

    def built(self, x: Reals) -> Mapping[str, Any]:
        """What a problem file says of one candidate, shape (k,)."""

    def measured(self, problem: Problem) -> tuple[Measure, ...]:
        """What the linkage really does."""
