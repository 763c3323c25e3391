"""The stranger's equilibrium: reactions, balancing load and losses of a loaded mechanism, with Coulomb friction.

result = forces(mech, loads)
result.value("M_1"), result.value("R_12"), result.value("eta")
"""

from __future__ import annotations

from .causes import Cause
from .equilibrium import Forces, forces

__all__ = ["Cause", "Forces", "forces"]
