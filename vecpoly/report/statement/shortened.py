"""Given numbers as they can be drawn."""

from __future__ import annotations

import re

from ...algebra.quantity import number

_LONG = re.compile(r"(?<![\w.])(\d+\.\d+)(?= (mm)|[^\d.]|$)")
_FIGURES = {"mm": 4}  # of a length; of other data one more


def shortened(text: str) -> str:
    """Given numbers to as many figures as can be drawn: 207.6 mm of 207.647 mm."""
    return _LONG.sub(lambda found: _to_figures(found[1], _FIGURES.get(found[2] or "", 5)), text)


def _to_figures(text: str, most: int) -> str:
    digits = len(text.replace(".", "").lstrip("0"))
    return text if digits <= most else number(float(text), most)
