"""What was found by inversion as a problem of its own, standing in its first position."""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping
from math import radians
from typing import Any

from ...units.reading import Quantity
from ..linkages import four_bar, slider_crank

MM = 1e3
_OF_LAST = ["v_B", "omega_1", "omega_2", "a_B", "alpha_1", "alpha_2"]


def posed_four_bar(
    values: Mapping[str, float], ab: float, dc: float, ad: float, omega: Quantity | None, *, last: bool = False
) -> dict[str, Any]:
    """A in the origin; ab, dc, ad: the directions of AB, DC and AD in the first position (deg). last: DC drives."""
    data = four_bar(values, omega)
    d = values["AD"] * _ray(ad)
    b, c = values["AB"] * _ray(ab), d + values["CD"] * _ray(dc)
    data["frame"] = {"A": ["0 mm", "0 mm"], "D": [f"{d.real!r} mm", f"{d.imag!r} mm"]}
    data["input"] = data["input"] | {"phi": f"{ab!r} deg"}
    data["branch"] = [f"C {_hand(b, d, c)} of BD"]
    if not last:
        return data
    data["links"] = data["links"] | {"3": {"DC": data["links"]["3"]["CD"]}}
    data["input"] = data["input"] | {"link": "3", "phi": f"{dc!r} deg"}
    return data | {"branch": [f"B {_hand(c, 0j, b)} of CA"], "find": _OF_LAST}


def posed_slider_crank(
    values: Mapping[str, float], ab: float, c: complex, along: complex, omega: Quantity | None
) -> dict[str, Any]:
    """A in the origin; ab: the direction of AB in the first position (deg); c (m), along: the slider there."""
    level = abs(along.imag) < abs(along.real)
    data = slider_crank({**values, "e": 0.0}, omega)
    b = values["AB"] * _ray(ab)
    ahead = (MM * c - b).real if level else (MM * c - b).imag
    sides = ("right of", "left of") if level else ("above", "below")
    data["joints"] = [f"3 slides on {'y' if level else 'x'} = {MM * (c.imag if level else c.real)!r} mm"]
    data["input"] = data["input"] | {"phi": f"{ab!r} deg"}
    data["branch"] = [f"C {sides[ahead < 0]} B"]
    return data


def _hand(start: complex, end: complex, at: complex) -> str:
    """On which hand of the ray from one point to another a third one lies."""
    return "left" if ((end - start).conjugate() * (at - start)).imag >= 0 else "right"


def _ray(deg: float) -> complex:
    return exp(1j * radians(deg))
