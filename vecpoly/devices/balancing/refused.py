"""What is refused when the size of a correction is known: a hole too deep, a share of the wrong sign."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator
from itertools import combinations
from math import degrees, pi, radians, sqrt

from ...errors import EquilibriumError, NotAskedError
from ...words import Words
from .plane import RotorPlane

APART = 20.0  # deg: to either side, of two holes that are offered in place of one
SMALL = 1e-9  # of the product: a share that is none


def too_deep(plane: RotorPlane, mass: float, depth: float) -> EquilibriumError:
    """A hole would have to go through the disc; two are offered, or a larger drill. Depths in m."""
    assert plane.b is not None and plane.hole is not None and plane.density is not None
    wide = 1e3 * sqrt(4 * mass / (pi * plane.b.si * plane.density.si))
    two = 1e3 * depth / (2 * rect(1, radians(APART)).real)
    zh, en = f"请将钻头直径加大到 {wide:.4g} mm 以上", f"take a drill of more than {wide:.4g} mm"
    if plane.spread is None and two <= 1e3 * plane.b.si:
        zh += f"，或在所求方位两侧各 {APART:g}° 钻两个深 {two:.4g} mm 的孔（spread: {APART:g} deg）"
        en += f", or drill two holes {two:.4g} mm deep at {APART:g}° on either side (spread: {APART:g} deg)"
    return EquilibriumError(
        Words(
            f"孔径 {plane.hole.text} 时每孔须钻深 {1e3 * depth:.4g} mm，超过盘厚 {1e3 * plane.b.si:g} mm；{zh}",
            f"with a drill of {plane.hole.text} a hole must be {1e3 * depth:.4g} mm deep, more than the thickness of "
            f"the disc, {1e3 * plane.b.si:g} mm; {en}",
        ),
        code="too-deep",
        numbers={"depth": depth, "b": plane.b.si, "two_holes": two / 1e3},
    )


def nothing_to_share(end: str) -> NotAskedError:
    """Places are asked of a plane that needs no correction."""
    zh, en = (f"平面 {end} ", f"plane {end}") if end else ("转子", "the rotor")
    return NotAskedError(
        Words(
            f"{zh}已经平衡，没有可分配到两个方位的质径积；请去掉 places",
            f"{en} is in balance already: there is nothing to share between two places; leave out 'places'",
        ),
        code="balanced",
    )


def parallel_places(at: tuple[float, float]) -> EquilibriumError:
    """Two neighbouring places are opposite."""
    return EquilibriumError(
        Words(
            f"相邻的两个允许方位 {at[0]:g}° 和 {at[1]:g}° 在同一直线上，所求质径积不能沿它们分解；请增加方位或用 use "
            "另选",
            f"the two places on either side, {at[0]:g}° and {at[1]:g}°, lie in one line: the product cannot be "
            "resolved "
            "along them; allow more places, or choose two with 'use'",
        ),
        code="parallel",
        numbers={"at_1": at[0], "at_2": at[1]},
    )


def check_signs(plane: RotorPlane, needed: complex, shares: tuple[tuple[float, float], ...]) -> None:
    """EquilibriumError where a weight comes out negative though weights are only added, or the other way round."""
    if plane.only is None:
        return
    sign = 1.0 if plane.only == "add" else -1.0
    wrong = next(((at, share) for at, share in shares if sign * share < -SMALL * abs(needed)), None)
    if wrong is None:
        return
    pairs = "; ".join(f"{one:g}° & {other:g}°" for one, other in _working(plane, sign * needed))
    at, share = wrong
    only = Words("只许加重", "weights may only be added") if sign > 0 else Words("只许去重", "mass may only be removed")
    raise EquilibriumError(
        Words(
            f"方位 {degrees(at) % 360:g}° 的分量为 {share:.4g} kg·m，而{only.zh}；"
            f"{'可行的方位对：' + pairs if pairs else '给出的方位中没有可行的一对'}",
            f"the share at {degrees(at) % 360:g}° is {share:.4g} kg·m, but {only.en}; "
            f"{'pairs that work: ' + pairs if pairs else 'no pair of the given places works'}",
        ),
        code="wrong-sign",
        numbers={"share": share, "at": degrees(at) % 360},
    )


def _working(plane: RotorPlane, needed: complex) -> Iterator[tuple[float, float]]:
    """The neighbouring places between which the direction lies, nearest first; at most four."""
    assert plane.places is not None
    found = []
    for one, other in combinations(plane.places, 2):
        u, v = rect(1, one.si), rect(1, other.si)
        det = (u.conjugate() * v).imag
        if abs(det) < SMALL:
            continue
        first, second = (needed.conjugate() * v).imag / det, (u.conjugate() * needed).imag / det
        if min(first, second) >= -SMALL * abs(needed):
            gap = abs((degrees(other.si - one.si) + 180) % 360 - 180)
            found.append((gap, degrees(one.si) % 360, degrees(other.si) % 360))
    yield from ((one, other) for _, one, other in sorted(found)[:4])
