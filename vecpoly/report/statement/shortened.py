"""Given numbers as they can be drawn."""

from __future__ import annotations

import re

from ...algebra.quantity import number
from ...problem.values.given import Datum
from ...words import Lang, Words

_SPOT = re.compile(r"\((−?[\d.]+) mm, (−?[\d.]+) mm\)")  # its unit is said once
_RAY = re.compile(r"\$φ_\{([A-Z]{2})\}\$ = (?=.*,)")  # the directions of a line, one a position

_LONG = re.compile(r"(?<![\w.])(\d+\.\d+)(?= (mm)|[^\d.]|$)")
_FIGURES = {"mm": 4}  # of a length; of other data one more


def as_told(datum: Datum, lang: Lang) -> str:
    """A datum as the line has it: (0, 0) mm; of the directions of a line what they are."""
    rays = Words(r"$\1$ 在各位置的方向角 $φ_{\1}$ = ", r"directions of $\1$ in its positions $φ_{\1}$ = ").of(lang)
    return _RAY.sub(rays, _SPOT.sub(r"(\1, \2) mm", shortened(datum.of(lang))))


def shortened(text: str) -> str:
    """Given numbers to as many figures as can be drawn: 207.6 mm of 207.647 mm."""
    return _LONG.sub(lambda found: _to_figures(found[1], _FIGURES.get(found[2] or "", 5)), text)


def _to_figures(text: str, most: int) -> str:
    digits = len(text.replace(".", "").lstrip("0"))
    return text if digits <= most else number(float(text), most)
