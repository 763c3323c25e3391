"""What stands behind a printed answer about a mechanism: the exact size, the exact vector."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

from ... import oracle
from ...errors import UnknownNameError
from ...mechanism.asked.forces import given_value
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import Named, Rel
from ...problem.problem import Printed, Problem
from .centres import CentralTruth

if TYPE_CHECKING:
    from ...oracle.forces import Forces


def behind(problem: Problem) -> Callable[[Printed], float | None]:
    """What gives the exact value behind a printed answer (None: nothing to compare)."""
    mech, loads = problem.mechanism, problem.loads
    motion = oracle.solve(mech)
    balance, central = cache(lambda: _forces(mech, loads)), CentralTruth(problem)

    def truth(printed: Printed) -> float | None:
        if (value := central(printed)) is not None:
            return value
        return (
            _of_loads(printed.rel, loads, balance)
            if isinstance(printed.rel, Named) and loads
            else _exact(motion, printed)
        )

    return truth


def _forces(mech: Mechanism, loads: Loads | None) -> Forces:
    from ...oracle.forces import forces  # late: most problems have none

    return forces(mech, loads or Loads())


def _of_loads(rel: Named, loads: Loads, balance: Callable[[], Forces]) -> float:
    """A datum of the loads, or what equilibrium says."""
    if (data := given_value(loads, rel.key)) is not None:
        return data
    value = balance().value(rel.key)
    return abs(complex(value)) if rel.is_vector else float(value.real)


def _exact(motion: oracle.Motion, printed: Printed) -> float | None:
    if printed.rel is None:
        letters = printed.symbol.removeprefix("l_")
        if len(letters) != 2:
            return None
        try:
            return float(abs(motion.position(letters[1]) - motion.position(letters[0])))
        except UnknownNameError:
            return None
    if not isinstance(printed.rel, Rel):
        return None
    value = motion.value(printed.rel)
    return float(abs(value)) if printed.rel.kind.is_vector else float(value.real)


def way(problem: Problem) -> Callable[[Printed], complex | None]:
    """The exact vector behind a printed answer; None where there is none."""
    motion = oracle.solve(problem.mechanism)

    def vector(printed: Printed) -> complex | None:
        match printed.rel:
            case Rel() as rel if rel.kind.is_vector:
                return complex(motion.value(rel))
            case Named() as named if named.is_vector and problem.loads:
                return complex(_forces(problem.mechanism, problem.loads).value(named.key))
        return None

    return vector
