"""Scales that stand on a drawing in words: μ_v = 0.01 (m/s)/mm."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...errors import FaultError
from ...figures import scales
from ..reading.characters import plain
from ..sheet import scale_read
from .segment import Label

_SCALE = re.compile(r"[μµu]_?\{?([A-Za-z]+)\}?=([^=]*?)/mm(?![A-Za-z0-9_/^])")
_ONE = re.compile(r"(?<![\d.])1mm=([\d.][^=,;]*)")  # 1 mm = 0.01 m/s
_ENDS = re.compile(r"[^\w°)]+$")
LINE = 1.0  # of the letters' height: what stands on one line of lettering


def stated(labels: Sequence[Label]) -> dict[str, float]:
    """``mu_v`` → in the unit of its kind per mm, whatever unit it is told in; what is no scale is left out.

    1 mm = 0.01 m/s is said of every kind that is measured so.
    """
    known = scales()
    found: dict[str, float] = {}
    for text in map(_squeezed, _lines(labels)):
        said = [(f"mu_{letter}", value) for letter, value in _SCALE.findall(text)]
        said += [(key, _ENDS.sub("", value)) for value in _ONE.findall(text) for key in known]
        for key, value in said:
            if key in known and (number := _number(key, value)) is not None:
                found.setdefault(key, number)
    return found


def _number(key: str, value: str) -> float | None:
    """The scale that says so many of a unit a mm; None where the unit is none of its kind."""
    digits = re.match(r"[\d.]+(?:[eE][-+]?\d+|[×·*]10\^?[-+]?\d+)?", value)
    unit = value[digits.end() :].strip("()") if digits else ""
    if digits is None or not unit:
        return None
    try:
        return scale_read(key, f"{digits[0]} ({unit})/mm") or None
    except FaultError:
        return None


def _squeezed(text: str) -> str:
    return plain(text).replace(" ", "")


def _lines(labels: Sequence[Label]) -> list[str]:
    """Each label with those that go on to its right."""
    return [
        one.text + "".join(other.text for other in sorted(labels, key=lambda o: o.at.real) if _goes_on(one, other))
        for one in labels
        if "=" in plain(one.text) or one.text[:1] in "μµ"
    ]


def _goes_on(one: Label, other: Label) -> bool:
    step = other.at - one.at
    return 0 < step.real < 20 * one.height and abs(step.imag) <= LINE * one.height
