"""The door of the methods of a machine."""

from __future__ import annotations

from ...mechanism.asked.machine import Equivalent
from ..forces.state import Statics
from ..registry import Door


def _equivalent(st: Statics, to: Equivalent) -> None: ...


EQUIVALENTS = Door(_equivalent)
