"""The door of the constructions of curvatures."""

from __future__ import annotations

from ..registry import Door
from .state import CurvatureFigure


def _way(fig: CurvatureFigure, points: tuple[str, ...]) -> None: ...


WAYS = Door(_way)
