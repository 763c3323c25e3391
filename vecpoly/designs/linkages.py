"""Linkages as a problem file says them, by their lengths (mm)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..units.reading import Quantity
from ..words import Words

OF_COUPLER = Words(
    "$E$ 的坐标以 $B$ 为原点，$x$ 轴沿 $BC$，$y$ 轴在其左侧",
    "the coordinates of $E$ have the $x$ axis along $BC$, the origin in $B$, and the $y$ axis to the left of $BC$",
)


def _mm(value: float) -> str:
    return f"{value!r} mm"


def _input(omega: Quantity | None) -> dict[str, Any]:
    return {"link": "1", "phi": "60 deg", "omega": "1 rad/s ccw" if omega is None else omega.text}


def four_bar(values: Mapping[str, float], omega: Quantity | None) -> dict[str, Any]:
    """A in the origin, D on the x axis, AB the input, C on the left of BD."""
    ab, bc, cd, ad = (_mm(values[key]) for key in ("AB", "BC", "CD", "AD"))
    return {
        "frame": {"A": ["0 mm", "0 mm"], "D": [ad, "0 mm"]},
        "links": {"1": {"AB": ab}, "2": {"BC": bc}, "3": {"CD": cd}},
        "input": _input(omega),
        "branch": ["C left of BD"],
        "find": ["v_C", "omega_2", "omega_3", "a_C", "alpha_2", "alpha_3"],
    }


def slider_crank(values: Mapping[str, float], omega: Quantity | None) -> dict[str, Any]:
    """A in the origin, the guide along x at the distance e below it, AB the input, C on the right."""
    ab, bc = (_mm(values[key]) for key in ("AB", "BC"))
    return {
        "frame": {"A": ["0 mm", "0 mm"]},
        "links": {"1": {"AB": ab}, "2": {"BC": bc}, "3": {"block": "C"}},
        "joints": [f"3 slides on y = {-values['e']!r} mm"],
        "input": _input(omega),
        "branch": ["C right of B"],
        "find": ["v_C", "omega_2", "a_C", "alpha_2"],
    }


def shaper(values: Mapping[str, float], rod: float, omega: Quantity | None) -> dict[str, Any]:
    """C in the origin, A above it, the crank in the slot of the lever CD, the ram E on the guide y = h; rod: DE."""
    return {
        "frame": {"A": ["0 mm", _mm(values["AC"])], "C": ["0 mm", "0 mm"]},
        "links": {
            "1": {"AB": _mm(values["AB"])},
            "2": {"block": "B"},
            "3": {"slot": "C", "D": {"along": "CB", "at": _mm(values["CD"])}},
            "4": {"DE": _mm(rod)},
            "5": {"block": "E"},
        },
        "joints": ["2 slides in 3", f"5 slides on y = {values['h']!r} mm"],
        "input": _input(omega),
        "branch": ["E right of D"],
        "find": ["omega_3", "v_D", "v_E", "alpha_3", "a_E"],
    }


def guide_bar(values: Mapping[str, float], omega: Quantity | None) -> dict[str, Any]:
    """C in the origin, A above it, the crank's block in the slot of a bar whose line passes beside C."""
    beside = {"through": "C", "left": _mm(values["e"])} if values["e"] else "C"
    return {
        "frame": {"A": ["0 mm", _mm(values["AC"])], "C": ["0 mm", "0 mm"]},
        "links": {"1": {"AB": _mm(values["AB"])}, "2": {"block": "B"}, "3": {"slot": beside}},
        "joints": ["2 slides in 3"],
        "input": _input(omega),
        "find": ["omega_3", "alpha_3"],
    }


def whitworth(values: Mapping[str, float], rod: float, omega: Quantity | None) -> dict[str, Any]:
    """C in the origin, A above it, the crank in the slot of the bar that turns about C, the slider E on y = 0."""
    return {
        "frame": {"A": ["0 mm", _mm(values["AC"])], "C": ["0 mm", "0 mm"]},
        "links": {
            "1": {"AB": _mm(values["AB"])},
            "2": {"block": "B"},
            "3": {"CD": _mm(values["CD"]), "slot": {"through": "C", "angle": "180 deg from CD"}},
            "4": {"DE": _mm(rod)},
            "5": {"block": "E"},
        },
        "joints": ["2 slides in 3", "5 slides on y = 0 mm"],
        "input": _input(omega),
        "branch": ["E right of D"],
        "find": ["omega_3", "v_D", "v_E", "alpha_3", "a_E"],
    }
