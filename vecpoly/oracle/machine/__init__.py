"""The stranger's machine: one link that has the kinetic energy of all links and the power of all loads, and how that
moves.

reduced = reduce(mech, loads)                  # at the mechanism's own position
reduced.inertia(link), reduced.load(link)      # J_e, M_e of a link
"""

from __future__ import annotations

from .answers import machine_values
from .confirmed import Confirmed, confirmed
from .course import Course, course
from .extremes import Top
from .power import Flow
from .reduced import Reduced, reduce
from .started import ending, motion_of
from .steady import Evenness, Tangents, evenness, surplus, tangents

__all__ = [
    "Confirmed",
    "Course",
    "Evenness",
    "Flow",
    "Reduced",
    "Tangents",
    "Top",
    "confirmed",
    "course",
    "ending",
    "evenness",
    "machine_values",
    "motion_of",
    "reduce",
    "surplus",
    "tangents",
]
