"""The rocker of which both limit positions are given."""

from __future__ import annotations

from dataclasses import dataclass

from ....plane import Points

BESIDE = 1e-9  # of the rocker, or of C₁C₂: A in a limit position of C, where AD is as long as CD


@dataclass(frozen=True, slots=True, kw_only=True)
class Rocker:
    """D and the limit positions of the rocker on paper."""

    d: Points
    c1: Points
    c2: Points
