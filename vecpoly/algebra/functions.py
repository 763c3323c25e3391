"""The trigonometric functions of a pocket calculator that counts in degrees."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ..plane import Reals

FUNCTIONS: dict[str, Callable[[Any], Reals]] = {
    "sin": lambda angle: np.sin(np.radians(angle)),
    "cos": lambda angle: np.cos(np.radians(angle)),
    "tan": lambda angle: np.tan(np.radians(angle)),
    "arctan": lambda ratio: np.degrees(np.arctan(ratio)),
}
