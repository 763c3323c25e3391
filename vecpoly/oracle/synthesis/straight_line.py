"""The path of a coupler point by the law of cosines: how far it goes along AD, and how far across."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ...designs.straight_line import StraightLine
from ...designs.verdict import Verdict
from .registry import Linkage, synthesizes
from .sweep import greatest


@synthesizes(StraightLine)
def straight_lines(design: StraightLine) -> list[Linkage]:
    """The extent of E along AD and across it, over the range."""
    path = _path(design)
    length = greatest(lambda t: path(t).real) + greatest(lambda t: -path(t).real)
    band = greatest(lambda t: path(t).imag) + greatest(lambda t: -path(t).imag)
    pins = {"A": 0j, "D": complex(design.AD.si), "E1": complex(path(0.0)), "E2": complex(path(1.0))}
    order = (design.AB.si, design.BC.si, design.AD.si, 0.0)
    return [Linkage(values={"L": 1e3 * length, "delta": 1e3 * band}, pins=pins, verdict=Verdict.VALID, order=order)]


def _path(design: StraightLine) -> Callable[[Any], Any]:
    """E at a share of the range, or at many."""
    a, b, c, d = (one.si for one in (design.AB, design.BC, design.CD, design.AD))
    first, last = (end.si for end in design.phi)
    side = 1 if design.side == "left" else -1

    def at(share: Any) -> Any:
        pin = a * np.exp(1j * (first + share * (last - first)))
        base = d - pin
        cosine = (abs(base) ** 2 + b * b - c * c) / (2 * abs(base) * b)
        return pin + design.E.at * base / abs(base) * np.exp(1j * side * np.arccos(np.clip(cosine, -1.0, 1.0)))

    return at
