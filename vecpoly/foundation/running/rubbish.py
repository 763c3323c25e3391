"""Python's look for garbage in circles, made seldom: hardly anything here lives in circles, and all is looked through
each time (a tenth of the time of a solution)."""

from __future__ import annotations

import gc

OBJECTS = 250_000  # new ones between two looks


def seldom_looked_for() -> None:
    """From here on, in this process; what is there already is kept for good."""
    gc.freeze()
    gc.set_threshold(OBJECTS)
