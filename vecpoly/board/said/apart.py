"""Why two arcs, or an arc and a line, have no meeting, and why a line touches no circle."""

from __future__ import annotations

from ...errors import AssemblyError, EquilibriumError, bilingual
from ...words import Words

ONE = 1e-9  # mm: two centres, or two radii, that are one


def arcs_apart(what: Words | str, span: float, one: float, other: float) -> AssemblyError:
    """Of two arcs with these radii, their centres so far apart (mm)."""
    if max(span, abs(one - other)) < ONE:
        return AssemblyError(bilingual(what) + _ANYWHERE)
    return AssemblyError(
        bilingual(what)
        + Words(
            f"：半径 {one:.2f} mm 与 {other:.2f} mm 的两弧圆心相距 {span:.2f} mm，"
            f"不相交（半径之和 {one + other:.2f} mm）",
            f": the arcs of {one:.2f} mm and {other:.2f} mm about points {span:.2f} mm apart "
            f"do not meet (sum {one + other:.2f} mm)",
        )
    )


def line_apart(what: Words | str, radius: float, gap: float) -> AssemblyError:
    """Of an arc and a line so far from its centre (mm)."""
    return AssemblyError(
        bilingual(what)
        + Words(
            f"：半径 {radius:.2f} mm 的弧达不到相距 {gap:.2f} mm 的直线",
            f": an arc of {radius:.2f} mm does not reach a line {gap:.2f} mm away",
        )
    )


_ANYWHERE = Words(
    "：两弧同心且半径相等，处处重合，交点不定（两构件叠合，如筝形机构折叠处）；请避开此位置，或用 vecpoly exact",
    ": both arcs have one centre and one radius and meet everywhere: two links lie on each other (a kite that folds), "
    "and the point may be anywhere; keep clear of this position, or use 'vecpoly exact'",
)


def no_tangent(away: float, size: float) -> EquilibriumError:
    """Why no line of action passes through a point so far from the centre of a friction circle of this radius (mm)."""
    if size < ONE:
        return EquilibriumError(
            Words(
                "作用线须通过的一点就在铰链中心，两点重合，方向不定；请另取位置，或改变力的作用点",
                "a line of action must pass through a point that is the centre of the joint itself, so it has no "
                "direction; choose another position, or another point of application",
            )
        )
    return EquilibriumError(
        Words(
            f"作用线须过距摩擦圆圆心 {away:.2f} mm 的一点，而摩擦圆半径为 {size:.2f} mm，该点在圆内，"
            "无切线，在此摩擦下不能平衡；请减小 f 或 ρ",
            f"a line of action must pass through a point {away:.2f} mm from the centre of a friction "
            f"circle of radius {size:.2f} mm, inside it: no tangent, there is no equilibrium with this "
            "friction; lower f or ρ",
        )
    )
