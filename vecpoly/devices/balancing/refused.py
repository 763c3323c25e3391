"""What is refused when the size of a correction is known: a hole too deep, a share of the wrong sign."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator
from itertools import combinations
from math import degrees, pi, radians, sin, sqrt

from ...errors import EquilibriumError, FaultError, NotAskedError
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
    assert plane.r is not None
    room = plane.hole.si <= 2 * plane.r.si * sin(radians(APART))
    if plane.spread is None and two <= 1e3 * plane.b.si and room:
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


def check_holes(plane: RotorPlane, wide: float) -> None:
    """EquilibriumError where a hole of this diameter (m) would reach over the axis, or two would overlap."""
    assert plane.r is not None
    radius, text = plane.r.si, f"{1e3 * wide:.4g} mm"
    if wide >= 2 * radius:
        raise EquilibriumError(
            Words(
                f"半径 {plane.r.text} 处直径 {text} 的孔将越过转轴，钻不成；请加大 r（或厚度 b），或用更小的钻头",
                f"a hole of {text} at a radius of {plane.r.text} would reach over the axis of the shaft; take a "
                "larger r (or b), or a smaller drill",
            ),
            code="out-of-range",
            numbers={"d": wide, "r": radius},
        )
    if plane.spread is not None and wide > (apart := 2 * radius * sin(plane.spread.si)):
        raise EquilibriumError(
            Words(
                f"两孔中心相距 {1e3 * apart:.4g} mm，小于孔径 {text}，两孔重叠，所去质量不足；"
                "请加大 spread 或 r，或用更小的钻头",
                f"the two holes stand {1e3 * apart:.4g} mm apart and are {text} wide: they run into each other and "
                "take away too little; take a larger spread or r, or a smaller drill",
            ),
            code="out-of-range",
            numbers={"d": wide, "apart": apart},
        )


def leaves_couple(couple: float) -> Words:
    """What is told where masses in several planes are balanced in one: the couple (kg·m²) stays."""
    return Words(
        f"各质量与校正面不在同一平面：单面（静）平衡后仍留下不平衡力偶矩 {couple:.4g} kg·m²；要消除它须取两个校正平面",
        f"the masses and the correction do not lie in one plane: balanced in one plane (statically) it keeps a couple "
        f"of {couple:.4g} kg·m²; two planes of correction would take it away",
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


def outside(part: float, one: str, other: str) -> FaultError:
    """What is said of a centre of mass beside the planes, of which one would have this share."""
    return FaultError(
        Words(
            f"质心不在校正平面 {one} 与 {other} 之间（{one} 的份额为 {part:.3g}），不能按杠杆分配许用不平衡量；请改 "
            "tolerance.z",
            f"the centre of mass does not lie between the planes {one} and {other} (the share of {one} would be "
            f"{part:.3g}): the permissible unbalance cannot be split by the lever; mend tolerance.z",
        ),
        code="out-of-range",
        numbers={"share": part},
        keys=("tolerance", ("correct", one), ("correct", other)),
    )
