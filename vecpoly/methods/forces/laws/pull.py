"""A load as it was found in this position."""

from __future__ import annotations

from dataclasses import dataclass

from ....plane import Points, Reals


@dataclass(frozen=True, slots=True, kw_only=True)
class Pull:
    """Its size by every hand (N along its direction, or N·m), and the direction of a force."""

    size: Reals
    along: Points = 1 + 0j
