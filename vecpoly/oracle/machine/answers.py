"""The quantities of `mechanism.asked.machine` by their keys."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ...mechanism.asked.machine import STEADY, at_rest, equivalent_of, machine_quantities, reduced_quantities
from ...mechanism.laws.rated import refuse_rated
from ...mechanism.machine import Machine
from ...mechanism.model import Mechanism
from ..forces.laws.period import constant_size
from .reduced import Reduced, reduce
from .started import started_values
from .steady import one_place, steady_values


def machine_values(mech: Mechanism, machine: Machine, keys: Iterable[str]) -> dict[str, float]:
    """Key → exact value of what is asked of the machine (SI; angles in degrees).

    Raises AssemblyError, EquilibriumError, DeadPointError; the last too where the link rests on which all is to be
    thought.
    """
    asked, known = tuple(keys), reduced_quantities(mech)
    reduced = reduce(mech, machine.loads)
    found = {key: _equivalent(reduced, key) for key in asked if key in known}
    if (constant := machine.loads.constant) is not None and constant.name in asked:
        if machine.steady is not None:
            refuse_rated(machine.loads)
        found[constant.name] = constant_size(mech, machine.loads)
    if machine.steady is not None and {named.key for named in STEADY} & set(asked):
        one_place(mech, machine, asked)
        found |= {key: value for key, value in steady_values(mech, machine).items() if key in asked}
    if machine.started is not None and {named.key for named in machine_quantities(mech, machine).values()} & set(asked):
        found |= started_values(mech, machine, [key for key in asked if key not in found])
    return found


def _equivalent(reduced: Reduced, key: str) -> float:
    to = equivalent_of(reduced.mech, key)
    value = float((reduced.inertia(to) if key == to.inertia.key else reduced.load(to))[0])
    if np.isnan(value):
        raise at_rest(reduced.mech, to)
    return value
