"""The door of the lines of action: how the force on a driven link lies."""

from __future__ import annotations

from ...mechanism.asked.pressure import Driven
from ...plane import Points
from ..desk import Desk
from ..registry import Door


def _line(desk: Desk, driven: Driven) -> Points:
    raise NotImplementedError


LINES = Door(_line)
