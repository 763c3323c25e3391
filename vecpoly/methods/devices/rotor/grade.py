"""Grade of balance quality 平衡品质等级 (ISO 21940-11): a circle about the pole within which the tip must lie."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....algebra.quantity import Expr, Quantity, magnitude
from ....board.board import NO_LENGTH
from ....board.paper.marks import Dot, Role
from ....devices.balancing.asked import LIGHT, PER_RADIUS, permitted, within
from ....devices.balancing.rotor import Rotor
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from .polygon import Polygon, in_plane


def permitted_circles(bench: Bench, rotor: Rotor, polygons: Mapping[str, Polygon]) -> dict[str, Quantity]:
    """e_per = G/ω, U_per = m e_per, shared by the centre of mass; a circle of this radius in every polygon."""
    board, grade, unit = bench.board, rotor.tolerance, rotor.weighing
    assert grade is not None
    board.section(Words("平衡品质等级", "Grade of balance quality"))
    board.step(
        Words(
            "由平衡品质等级 $G$ = $e ω$ 求许用偏心距 $e_{per}$ 和许用不平衡量 $U_{per}$。",
            "The grade $G$ = $e ω$ gives the permissible eccentricity $e_{per}$ and the permissible unbalance "
            "$U_{per}$.",
        )
    )
    speed = bench.board.compute(
        "ω", magnitude("2π/60", np.pi / 30, "") * magnitude("n", grade.n.si * 30 / np.pi, "r/min"), "rad/s"
    )
    off = bench.worked(PER_RADIUS, magnitude("G", grade.G.si * 1e6, "μm/s") / speed)
    eccentric = off if unit is LIGHT else magnitude("e_{per}", off.value * 1e-6, "m")
    whole = bench.worked(permitted("", unit), magnitude("m", grade.mass.si, "kg") * eccentric)
    found = {"": whole} if rotor.static else _shared(bench, rotor, whole)
    for end, polygon in polygons.items():
        radius = board.to_paper(polygon.place, found[end].value)
        board.circle(polygon.place, 0j, radius, Role.HIDDEN)
        tip = complex(nominal(polygon.tip))
        away = -tip / abs(tip) if abs(tip) > NO_LENGTH else 1j
        board.plot(polygon.place, radius * away, permitted(end, unit).symbol, Dot.NONE)
    return found


def _shared(bench: Bench, rotor: Rotor, whole: Quantity) -> dict[str, Quantity]:
    """U_perI = U_per (L − l_S)/L; without the centre of mass one half each."""
    (one, first), (other, second) = rotor.correct.items()
    grade = rotor.tolerance
    assert grade is not None
    rotor.parts()  # refuses a centre of mass outside
    bench.board.step(
        Words(
            "许用不平衡量按质心 $S$ 到两平面的距离分配：" if grade.z is not None else "质心位置未给，两平面各取一半：",
            "It is divided between the planes in proportion to the distances of the centre of mass $S$:"
            if grade.z is not None
            else "The centre of mass is not given; each plane may have one half:",
        )
    )
    parts: dict[str, Expr] = {one: whole / magnitude("2", 2.0, ""), other: whole / magnitude("2", 2.0, "")}
    if grade.z is not None:
        span = magnitude("L", (second.at - first.at) * 1e3, "mm")
        arm = magnitude("l_S", (grade.z.si - first.at) * 1e3, "mm")
        parts = {one: whole * ((span - arm) / span), other: whole * (arm / span)}
    return {end: bench.worked(permitted(end, rotor.weighing), part) for end, part in parts.items()}


def judged_within(bench: Bench, end: str, polygon: Polygon, left: Points, allowed: Quantity, *, rounded: bool) -> None:
    """Whether the tip lies inside the circle about the pole."""
    board, symbol = bench.board, within(end)
    size = board.scale_of(polygon.place).value * np.abs(left)
    board.step(
        in_plane(
            end,
            Words(
                f"以 $O$ 为圆心、$U_{{per{end}}}$ 为半径作圆，看"
                + ("取整后的" if rounded else "校正前的")
                + "末端在圆内还是圆外。",
                f"About $O$ draw a circle of radius $U_{{per{end}}}$, the permissible unbalance of the plane, and see "
                "whether the tip "
                + ("that the rounded weights leave" if rounded else "before any correction")
                + " lies inside.",
            ),
        ),
        polygon.place,
    )
    yes = size <= allowed.value
    inside = Words("末端在圆内：合格。", " It lies inside: accepted.")
    outside = Words("末端在圆外：不合格，须校正。", " It lies outside: a correction is needed.")
    bench.judged(symbol, yes, inside if bool(nominal(yes)) else outside, size, allowed.value)
