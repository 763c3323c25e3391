"""The quantities of `mechanism.asked.machine` by their keys."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ...mechanism.asked.machine import at_rest, equivalent_of, reduced_quantities
from ...mechanism.machine import Machine
from ...mechanism.model import Mechanism
from .reduced import Reduced, reduce


def machine_values(mech: Mechanism, machine: Machine, keys: Iterable[str]) -> dict[str, float]:
    """Key → exact value of what is asked of the machine (SI; angles in degrees).

    Raises AssemblyError, DeadPointError; DeadPointError too where the link rests on which all is to be thought.
    """
    asked, known = tuple(keys), reduced_quantities(mech)
    reduced = reduce(mech, machine.loads)
    return {key: _equivalent(reduced, key) for key in asked if key in known}


def _equivalent(reduced: Reduced, key: str) -> float:
    to = equivalent_of(reduced.mech, key)
    value = float((reduced.inertia(to) if key == to.inertia.key else reduced.load(to))[0])
    if np.isnan(value):
        raise at_rest(reduced.mech, to)
    return value
