"""Scales that stand on a drawing in words: μ_v = 0.01 (m/s)/mm."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...figures import scales
from .segment import Label

_SCALE = re.compile(r"[μµu]_?\{?([A-Za-z])\}?\s*=\s*([0-9.]+(?:[eE][-+]?\d+)?)\s*(\(?[a-zA-Z·/^0-9²]+\)?)/mm")
_SQUARED = str.maketrans({"²": "2", "^": None, "(": None, ")": None, "·": None})
LINE = 1.0  # of the letters' height: what stands on one line of lettering


def stated(labels: Sequence[Label]) -> dict[str, float]:
    """``mu_v`` → SI per mm, of the scales whose unit is that of the textbook."""
    known = {mu.key: mu.unit.translate(_SQUARED) for mu in scales().values()}
    found: dict[str, float] = {}
    for text in _lines(labels):
        for letter, number, unit in _SCALE.findall(text.replace(" ", "")):
            key = f"mu_{letter}"
            if known.get(key) == unit.translate(_SQUARED) and float(number) > 0:
                found.setdefault(key, float(number))
    return found


def _lines(labels: Sequence[Label]) -> list[str]:
    """Each label with those that go on to its right."""
    return [
        one.text + "".join(other.text for other in sorted(labels, key=lambda o: o.at.real) if _goes_on(one, other))
        for one in labels
        if "=" in one.text or one.text[:1] in "μµ"
    ]


def _goes_on(one: Label, other: Label) -> bool:
    step = other.at - one.at
    return 0 < step.real < 20 * one.height and abs(step.imag) <= LINE * one.height
