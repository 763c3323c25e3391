"""The door of the methods that pass masses on."""

from __future__ import annotations

from ...mechanism.counterweights import Passing
from ..registry import Door
from .standing import Weighing


def _passing(here: Weighing, of: Passing) -> None: ...


PASSINGS = Door(_passing)
