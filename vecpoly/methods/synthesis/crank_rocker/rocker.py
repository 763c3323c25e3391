"""The rocker of which both limit positions are given."""

from __future__ import annotations

from dataclasses import dataclass

from ....plane import Points


@dataclass(frozen=True, slots=True, kw_only=True)
class Rocker:
    """D and the limit positions of the rocker on paper."""

    d: Points
    c1: Points
    c2: Points
