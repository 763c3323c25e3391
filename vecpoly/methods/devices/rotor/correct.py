"""What is done in a plane: a weight at the radius, a hole on the other side, or two weights at fixed places."""

from __future__ import annotations

from math import degrees, pi

import numpy as np

from ....algebra.formula import Row, sym
from ....algebra.quantity import Of, Quantity, Rooted, magnitude
from ....algebra.worked import worked
from ....devices.balancing.asked import hole_bearing, hole_size, weight
from ....devices.balancing.plane import RotorPlane
from ....devices.balancing.refused import check_holes, too_deep
from ....devices.balancing.rotor import Rotor
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from .grade import judged_within
from .places import at_places
from .polygon import Polygon, in_plane, stated_bearing
from .products import QUARTER, density, radius
from .rounding import rounded_weight
from .views.sketch import added


def corrected(
    bench: Bench, rotor: Rotor, end: str, polygon: Polygon, found: Quantity, permitted: Quantity | None
) -> None:
    """m_b = W_b / r_b, in the way this plane asks for; then what remains, inside or outside its circle."""
    plane = rotor.planes[end]
    left: Points = polygon.tip
    if plane.r is not None:
        left = _done(bench, rotor, end, polygon, found)
    if permitted is not None:
        judged_within(bench, end, polygon, left, permitted, rounded=plane.step is not None)


def _done(bench: Bench, rotor: Rotor, end: str, polygon: Polygon, found: Quantity) -> Points:
    plane = rotor.planes[end]
    bench.board.section(Words("校正", "Correction"))
    if plane.places is not None:
        return at_places(bench, rotor, end, polygon)
    assert plane.r is not None
    bench.board.step(
        in_plane(end, _NEEDED if plane.hole is None else _REMOVED),
        again=Words(f"同样求平面 ${end}$ 内所需的质量：", f"The mass for plane ${end}$ is found in the same way:"),
    )
    unit = rotor.weighing
    needed = bench.worked(weight(end, unit), found / radius("r_b", plane.r.si, unit))
    if plane.hole is not None:
        _drilled(bench, rotor, end, polygon, needed)
    added(bench, rotor, end, polygon, plane)
    return polygon.tip if plane.step is None else rounded_weight(bench, rotor, end, polygon, needed)


def _drilled(bench: Bench, rotor: Rotor, end: str, polygon: Polygon, needed: Quantity) -> None:
    """d from m = π/4 d² b ρ, or h from m = π/4 d² h ρ; two holes at ± spread bear W/(2 cos) each."""
    plane, board = rotor.planes[end], bench.board
    board.step(
        Words(
            "去重与加重等效：孔钻在 $W_b$ 的对侧。" + (_TWO.zh if plane.spread is not None else ""),
            "Taking mass away is the same as adding it on the opposite side: the hole is drilled opposite to $W_b$."
            + (" " + _TWO.en if plane.spread is not None else ""),
        )
    )
    stated_bearing(bench, hole_bearing(end), polygon.tip, polygon.least)
    each = needed
    if plane.spread is not None:
        gamma = magnitude("γ", degrees(plane.spread.si), "deg")
        each = board.compute(
            f"m_{{h{end}}}", needed / (magnitude("2", 2.0, "") * Of("cos", gamma)), rotor.weighing.mass
        )
    _size_of_hole(bench, rotor, end, each, plane)


_NEEDED = Words("在校正半径 $r_b$ 处所需的质量为：", "At the radius $r_b$ the mass needed is:")
_REMOVED = Words("在半径 $r_b$ 处应钻去的质量为：", "At the radius $r_b$ the mass to be drilled out is:")
_TWO = Words(
    "用两个相同的孔代替，它们在所求方位两侧各偏 $γ$，质量各为：",
    "Two equal holes replace it, at $γ$ on either side of that direction, each with the mass:",
)


def _size_of_hole(bench: Bench, rotor: Rotor, end: str, each: Quantity, plane: RotorPlane) -> None:
    assert plane.b is not None and plane.density is not None and plane.hole is not None
    unit, named = rotor.weighing, hole_size(end, plane.through)
    b, dense = rotor.disc.symbols(f"b{end}", plane.b, plane.density)
    rho = density(dense, plane.density.si, unit)
    if plane.through:
        deep = magnitude(b, plane.b.si * 1e3, "mm")
        value = np.sqrt(each.value / (QUARTER * deep * rho).value)
        check_holes(plane, float(nominal(value)) / 1e3)
        bench.stated(named, value, _root(named.symbol, each, deep, rho))
        return
    check_holes(plane, plane.hole.si)
    wide = magnitude("d", plane.hole.si * 1e3, "mm")
    depth = bench.worked(named, each / (QUARTER * wide.squared() * rho))
    if float(nominal(depth.value)) > 1e3 * plane.b.si:
        raise too_deep(plane, float(nominal(each.value)) / unit.masses, float(nominal(depth.value)) / 1e3)


def _root(symbol: str, each: Quantity, deep: Quantity, rho: Quantity) -> Row:
    """d = √(4 m/(π b ρ)) = … mm."""
    four, under = magnitude("4", 4.0, ""), magnitude("π", pi, "")
    return worked(sym(symbol), Rooted(four * each / (under * deep * rho)), "mm")
