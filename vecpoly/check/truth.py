"""What is known of a problem by somebody who has not seen the drawing; registered by `knows`."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from typing import NamedTuple, Protocol, TypeVar, runtime_checkable

import numpy as np

from ..errors import NotAskedError
from ..foundation.plugins import BySubject
from ..names import Rel
from ..problem.problem import Printed, Problem
from ..words import Words

Values = dict[str, complex | float]


class ActsAt(NamedTuple):
    """Where a reaction acts: a point of its line (m), the sense of its moment about the pin ("": none).

    couple: of a slide (N·m); None where there is a force.
    """

    point: complex
    tangent: str = ""
    couple: float | None = None


class Truth(Protocol):
    """The oracle's opinion of a problem."""

    @property
    def values(self) -> Values:
        """Key → exact value (SI), of all that is asked. Raises NotAskedError for what has no value with these data."""
        ...

    @property
    def lines(self) -> Mapping[str, ActsAt]:
        """Key of every reaction asked for → where it acts."""
        ...

    @property
    def likely(self) -> Mapping[str, float]:
        """Unit → size of such quantities that the data alone make likely; nothing where they tell none."""
        ...

    @property
    def nearby(self) -> tuple[Values, ...]:
        """The values with data moved by a few units in the last place; none where no digit can be lost."""
        ...

    def known(self, rel: Rel) -> complex | float | None:
        """The exact value of what a hand found on its way; None where it is not known."""
        ...

    def behind(self) -> Callable[[Printed], float | None]:
        """What gives the exact value behind a printed answer (None: nothing to compare)."""
        ...

    def way(self) -> Callable[[Printed], complex | None]:
        """What gives the exact vector behind a printed answer (None: it is no vector)."""
        ...


@runtime_checkable
class OfSeveral(Protocol):
    """A truth about what may have several solutions that serve as well."""

    @property
    def others(self) -> Mapping[int, Mapping[str, float]]:
        """The number of each but the one that is taken → key → its value, in the units of the answers."""
        ...


T = TypeVar("T", bound=Callable[[Problem], Truth])
_TRUTHS: BySubject[Callable[[Problem], Truth]] = BySubject("vecpoly.check.truths")


def knows(subject: type) -> Callable[[T], T]:
    """Register what knows problems about this; raises ValueError where that is on file."""

    def register(truth: T) -> T:
        _TRUTHS.put(subject, truth, "two truths about")
        return truth

    return register


def truth_of(problem: Problem) -> Truth:
    """The oracle's opinion of this problem; raises NotAskedError where it has none."""
    if (truth := _TRUTHS.find(problem.subject)) is not None:
        return truth(problem)
    raise NotAskedError(
        Words(
            f"“{type(problem.subject).__name__}”类题目没有独立的解析解；请用 @knows 登记",
            f"nothing on file checks a problem about a {type(problem.subject).__name__}; register a truth by @knows",
        )
    )


def exact_values(problem: Problem) -> Values:
    """Key → exact value: complex for vectors and positions, float for ω, α, moments, efficiencies; all SI."""
    return truth_of(problem).values


def size_of(value: complex | float) -> float:
    """The magnitude of a vector, the value of a scalar."""
    return abs(value) if isinstance(value, complex) else float(value)


def finite(found: Values, directions: Container[str] = ()) -> Values:
    """The values; an efficiency of 0/0 is NaN, and so is the direction of what vanishes.
    Raises NotAskedError for what else has no value."""
    for key, value in found.items():
        if not np.isfinite(value) and not (np.isnan(value) and (key == "eta" or key in directions)):
            raise NotAskedError(
                Words(
                    f"由所给数据 {key} 无值；请从 find 中去掉，或检查数据",
                    f"{key} has no value with these data; leave it out of `find`, or check the data",
                )
            )
    return found
