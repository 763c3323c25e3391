"""The stranger's machine: one link that has the kinetic energy of all links and the power of all loads, and how that
moves.

reduced = reduce(mech, loads)                  # at the mechanism's own position
reduced.inertia(link), reduced.load(link)      # J_e, M_e of a link
"""

from __future__ import annotations

from .answers import machine_values
from .reduced import Reduced, reduce
from .started import ending, motion_of

__all__ = ["Reduced", "ending", "machine_values", "motion_of", "reduce"]
