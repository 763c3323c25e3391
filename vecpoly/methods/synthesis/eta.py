"""Where A lies that sees C₁C₂ under θ: on a circle, by the inscribed angle; on the line C₁C₂ where θ = 0."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from ...algebra.quantity import Of, Quantity
from ...board.paper.marks import Dot
from ...designs.quantities import THETA
from ...errors import AssemblyError
from ...plane import Line, Points, Reals, nominal, unit
from ...plane.geometry import cross
from ...words import Words
from .angles import marked
from .draft import SHEET, TWO, Draft
from .linkage import point

NAMED = pi / 4  # from P on, where the circle has its letter
FLAT = 2.5  # times as large as all beside it the radius of a circle is of which only arcs are drawn
BEYOND, LETTER = 6.0, 8.0  # mm that an arc runs on; from C₂ to the letter
NO_CIRCLE = 1e-6  # mm: a radius with which nobody draws a circle

_FIRST = Words(
    "过 $C_2$ 作 $C_{1}C_{2}$ 的垂线，过 $C_1$ 作与 $C_{1}C_{2}$ 成 $90° − θ$ 的射线，两线交于 $P$，则 "
    "$∠C_{1}PC_{2} = θ$；以 $C_{1}P$ 为直径作圆 $η$"
    "（圆心 $O$ 为其中点），自弧 $C_{1}PC_{2}$ 上各点看 $C_{1}C_{2}$ 的角均为 $θ$，$A$ 必在此弧上。",
    "Draw the perpendicular to $C_{1}C_{2}$ at $C_2$ and from $C_1$ a ray at $90° − θ$ to $C_{1}C_{2}$; they meet "
    "in $P$, so that $∠C_{1}PC_{2} = θ$. Draw the circle $η$ on the diameter $C_{1}P$ (centre $O$, its midpoint). "
    "From every point of its arc $C_{1}PC_{2}$ the chord $C_{1}C_{2}$ is seen under $θ$: $A$ lies on this arc.",
)
_AGAIN = Words(
    "在 $C_{1}C_{2}$ 的另一侧同样作 $P′$ 和圆 $η′$（$η$ 对 $C_{1}C_{2}$ 的镜像）。",
    "Draw $P′$ and the circle $η′$ likewise on the other side of $C_{1}C_{2}$: the mirror image of $η$.",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Eta:
    """A circle from one arc of which C₁C₂ is seen under θ. side: −1 for the arc on the right of C₁C₂, 1 for the
    other. flat: whether it is so large that only arcs of it are drawn, about a centre off the paper."""

    centre: Points
    radius: Reals
    side: int
    marks: str
    flat: bool = False

    def arc(self, draft: Draft, start: Points, end: Points) -> None:
        """The piece from one of its points to another, a little beyond both."""
        one, other = (complex(nominal(at - self.centre)) for at in (start, end))
        radius = float(nominal(self.radius))
        turned, over = float(np.angle(other / one)), BEYOND / radius
        first = float(np.angle(one)) - np.copysign(over, turned)
        sweep = turned + 2 * np.copysign(over, turned)
        draft.board.circle(SHEET, self.centre, self.radius, start=min(first, first + sweep), sweep=abs(sweep))


@dataclass(frozen=True, slots=True, kw_only=True)
class Straight:
    """The line C₁C₂, where θ = 0."""

    line: Line


Locus = Eta | Straight


def eta(
    draft: Draft, ends: tuple[Points, Points], theta: Quantity, way: int, first: bool = True, size: float = 0.0
) -> Eta:
    """The circle on C₁P, P where the perpendicular at C₂ meets the ray at 90° − θ from C₁; of one that is many times as
    large as C₁C₂ and what is drawn beside it (size, mm), arcs.

    way: −1 on the right of C₁C₂, 1 on the left. first: whether there is no other circle yet.
    """
    span = float(nominal(np.abs(ends[1] - ends[0])))
    if span / (2 * np.sin(np.radians(float(nominal(theta.value))))) > FLAT * max(span, size):
        return _flat(draft, ends, theta, way, "" if first else "′")
    (c1, c2), board = ends, draft.board
    chord, marks = unit(c2 - c1), "" if first else "′"
    board.step(_FIRST if first else _AGAIN, SHEET)
    normal = board.parallel(c2, 1j * chord, key=f"C2P{marks}")
    ray = board.ray(c1, chord, way * (pi / 2 - theta.value * pi / 180), key=f"C1P{marks}")
    p = point(draft, f"P{marks}", board.meet(normal, ray, Words(f"求 $P{marks}$", f"finding $P{marks}$")))
    board.rule(SHEET, normal, p)
    board.rule(SHEET, ray, p)
    radius = np.abs(p - c1) / 2
    if not float(nominal(radius)) > NO_CIRCLE:
        raise _no_circle(marks)
    o = point(draft, f"O{marks}", board.lay_off(c1, unit(p - c1), radius))
    board.circle(SHEET, o, radius)
    behind = -np.sign(float(nominal(cross(p - c1, c2 - c1))))  # where neither C₁, C₂ nor P stands
    board.plot(SHEET, o + radius * unit(p - c1) * np.exp(1j * behind * NAMED), f"η{marks}", Dot.NONE)
    board.right_angle(SHEET, c2, unit(p - c2), unit(c1 - c2))
    if first:
        marked(draft, c1, (c2, p), "90° − θ")
        marked(draft, p, (c1, c2), "θ", key=THETA.key)
    return Eta(centre=o, radius=radius, side=way, marks=marks)


def _flat(draft: Draft, ends: tuple[Points, Points], theta: Quantity, way: int, marks: str) -> Eta:
    """Arcs about O at the distance C₁C₂/(2 sin θ) from C₁ and C₂, by beam compass."""
    (c1, c2), board = ends, draft.board
    board.step(_told_flat(marks), SHEET)
    on_paper = board.measure(c1, c2, "C_1 C_2")
    radius = board.compute(f"r_η{marks}", on_paper / (TWO * Of("sin", theta)), "mm")
    if not float(nominal(radius.value)) > NO_CIRCLE:
        raise AssemblyError(
            Words(
                "$C_{1}C_{2}$ 在图上太短，量得为零，半径无从计算；请取较小的 $μ_l$ 或较大的摆角",
                "$C_{1}C_{2}$ is so short on paper that nothing is read, and the radius cannot be computed; take a "
                "smaller $μ_l$, or a larger swing",
            )
        )
    left, right = board.arcs(c1, radius.value, c2, radius.value, Words(f"求 $O{marks}$", f"finding $O{marks}$"))
    found = Eta(centre=left if way > 0 else right, radius=radius.value, side=way, marks=marks, flat=True)
    found.arc(draft, c1, c2)
    over = complex(nominal(found.centre - (c1 + c2) / 2))
    board.plot(SHEET, c2 + LETTER * unit(c2 - c1) + over / abs(over) * LETTER / 2, f"η{marks}", Dot.NONE)
    return found


def _told_flat(marks: str) -> Words:
    o = f"O{marks}"
    return Words(
        f"$θ$ 很小，圆 $η{marks}$ 很大，其圆心 ${o}$ 在图外：由 $C_{{1}}C_{{2}}$ 计算半径，用长臂圆规以 $C_1$、$C_2$ "
        f"为圆心、$r_η$ 为半径作弧得 ${o}$，再以 ${o}$ 为圆心只画所需的弧段；自弧上 $C_{{1}}C_{{2}}$ 以外各点看 "
        "$C_{1}C_{2}$ 的角均为 $θ$，$A$ 必在此弧上。",
        f"The angle $θ$ is small and the circle $η{marks}$ so large that its centre ${o}$ lies off the paper: compute "
        f"its radius from $C_{{1}}C_{{2}}$, find ${o}$ by arcs of this radius about $C_1$ and $C_2$ with a beam "
        f"compass, and draw only those pieces of $η{marks}$ that are needed. From its points beyond $C_1$ and $C_2$ "
        "the chord $C_{1}C_{2}$ is seen under $θ$: $A$ lies there.",
    )


def _no_circle(marks: str) -> AssemblyError:
    """Not with any data: with a perpendicular ruled along the chord, or limit positions drawn as one."""
    p = f"P{marks}"
    return AssemblyError(
        Words(
            f"圆 $η{marks}$ 画不出来：${p}$ 落在 $C_1$ 上，直径 $C_{{1}}{p}$ 为零；"
            "请检查 $C_{1}C_{2}$ 与 $C_2$ 处的垂线",
            f"there is no circle $η{marks}$: ${p}$ falls on $C_1$, so that its diameter $C_{{1}}{p}$ is nothing; "
            "look at $C_{1}C_{2}$ and at the perpendicular at $C_2$",
        )
    )
