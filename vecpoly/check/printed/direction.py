"""The printed direction of a vector against the exact one."""

from __future__ import annotations

import cmath
from math import degrees, pi, radians

from ...foundation.slotted import replace
from ...words import Words
from ..truth import Truth
from .verdict import Checked, Verdict

CALCULATED, GRAPHICAL = radians(0.5), radians(3.0)  # how far a direction may be off


def with_directions(truth: Truth, checked: list[Checked]) -> list[Checked]:
    """The verdicts, wrong where the printed direction is another than the exact one."""
    if all(one.printed.direction is None for one in checked):
        return checked
    way = truth.way()
    return [_weighed(one, way(one.printed)) for one in checked]


def _weighed(one: Checked, exact: complex | None) -> Checked:
    if one.printed.direction is None or not exact:
        return one
    off = cmath.phase(cmath.rect(1.0, one.printed.direction) / exact)
    if abs(off) <= (GRAPHICAL if one.printed.kind == "graphical" else CALCULATED):
        return one
    here, there = (f"{degrees(angle) % 360:.4g}°" for angle in (one.printed.direction, cmath.phase(exact)))
    turned = Words("，恰好相反", ", just the opposite") if abs(abs(off) - pi) < GRAPHICAL else Words.same("")
    said = Words(f"方向应为 {there}，原书为 {here}", f"its direction is {there}, not {here}") + turned
    return replace(one, verdict=Verdict.WRONG, slip=said if one.slip is None else one.slip + Words("；", "; ") + said)
