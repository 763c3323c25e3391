"""Two positions of a crank and the link it drives: a dead centre in the second, or half a turn of a drag link."""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Collection, Mapping
from math import acos, degrees, pi
from typing import Any, ClassVar

from ..devices.base import Angle, Length, as_written
from ..names import Named
from ..words import Words
from .base import Advance, Design
from .inversion.built import posed_four_bar
from .linkages import four_bar
from .quantities import AB, AD, CD, FOUR_BAR, GAMMA_MIN
from .quantities import K as ADVANCE

_DEAD_CENTRE = (Named("phi_12", "φ_{12}", "deg"), CD, AD, Named("psi_1", "ψ_1", "deg"), Named("psi_2", "ψ_2", "deg"))


class DeadCentre(Design):
    """AD, CD, the angles ψ₁, ψ₂ of DC (from the x axis) and the turn φ₁₂ of AB; in position 2 A, B, C lie in one line.

    A is the origin, D on the x axis.
    """

    ranged: ClassVar[tuple[Named, ...]] = _DEAD_CENTRE
    kind: ClassVar[str] = "dead-centre"
    AD: Length
    CD: Length
    psi_1: Angle
    psi_2: Angle
    phi_12: Angle

    def task(self, asked: Collection[str]) -> Words:
        """Two positions, the second a dead centre."""
        return Words(
            "设计铰链四杆机构 $ABCD$，$A$ 为原点，机架 $AD$ 在 $x$ 轴上。连架杆 $DC$ 的两个位置 $ψ_1$、$ψ_2$ 自 $x$ "
            "轴正向逆时针量起，$AB$ 在其间的转角为 $φ_{12}$（逆时针为正）；位置 2 为死点，$A$、$B$、$C$ 共线。",
            "Design a four-bar linkage $ABCD$ with $A$ in the origin and the frame $AD$ on the $x$ axis. The "
            "positions $ψ_1$ and $ψ_2$ of the link $DC$ count counter-clockwise from the $x$ axis, and so does the "
            "turn $φ_{12}$ of $AB$ between them; in the second, a dead centre, $A$, $B$ and $C$ lie in one line.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """The four lengths."""
        return FOUR_BAR

    def given(self) -> tuple[tuple[str, str], ...]:
        """Frame, rocker, the angles."""
        written = (
            ("l_{AD}", self.AD),
            ("l_{CD}", self.CD),
            ("ψ_1", self.psi_1),
            ("ψ_2", self.psi_2),
            ("φ_{12}", self.phi_12),
        )
        return as_written(written)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The four-bar in its first position: the input link need be no crank, and may reach no other.

        DC stands at ψ₁ and AB as the lengths ask for: they are as read, and by itself AB might stand beyond its reach.
        """
        a, b, c, d = (values[named.key] for named in FOUR_BAR)
        c1, c2 = (d + c * exp(1j * psi.si) for psi in (self.psi_1, self.psi_2))
        ahead = a * c2 / abs(c2) / exp(1j * self.phi_12.si)
        told = min((ahead, -ahead), key=lambda pin: abs(abs(c1 - pin) - b))  # A, B, C or B, A, C in one line
        base = abs(c1)
        at_a = acos(max(-1.0, min(1.0, (a * a + base * base - b * b) / (2 * a * base))))
        b1 = min((a * c1 / base * exp(1j * way * at_a) for way in (1, -1)), key=lambda pin: abs(pin - told))
        return posed_four_bar(values, degrees(phase(b1)), degrees(self.psi_1.si), 0.0, self.omega)

    @property
    def size(self) -> float:
        """The frame."""
        return 2 * self.AD.si


_DRAG_LINK = (Named("phi_1", "φ_1", "deg"), ADVANCE, AD, Named("psi_1", "ψ_1", "deg"), AB)


class DragLink(Design):
    """AD, AB, K, the angles φ₁ of AB and ψ₁ of DC: while DC turns by 180° AB turns by 360°/(K + 1)."""

    ranged: ClassVar[tuple[Named, ...]] = _DRAG_LINK
    kind: ClassVar[str] = "drag-link"
    AD: Length
    AB: Length
    K: Advance
    phi_1: Angle
    psi_1: Angle

    def task(self, asked: Collection[str]) -> Words:
        """Two cranks, the first turning faster in one half of the second."""
        return Words(
            "设计双曲柄机构 $ABCD$，$A$ 为原点，机架 $AD$ 在 $x$ 轴上，主动曲柄 $AB$ 和从动曲柄 $DC$ 均逆时针转动，"
            "$K$ 为行程速比系数：$DC$ 由方向角 $ψ_1$ 转过 180° 时，$AB$ 由方向角 $φ_1$ 转过 360°/($K$ + 1)；方向角自 "
            "$x$ 轴正向逆时针量起。",
            "Design a drag-link mechanism $ABCD$ with $A$ in the origin and the frame $AD$ on the $x$ axis; the "
            "driving crank $AB$ and the driven crank $DC$ turn counter-clockwise. $K$ is its time ratio: while $DC$ "
            "turns through 180° from the direction $ψ_1$, $AB$ turns through 360°/($K$ + 1) from $φ_1$; directions "
            "count counter-clockwise from the $x$ axis.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """The four lengths, the least transmission angle, K."""
        return (*FOUR_BAR, GAMMA_MIN, ADVANCE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Frame, crank, K, the angles."""
        written = (("l_{AD}", self.AD), ("l_{AB}", self.AB), ("K", self.K), ("φ_1", self.phi_1), ("ψ_1", self.psi_1))
        return as_written(written)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The four-bar with A in the origin and D on the x axis."""
        return four_bar(values, self.omega)

    @property
    def beta(self) -> float:
        """360°/(K + 1), rad."""
        return 2 * pi / (self.K.si + 1)

    @property
    def size(self) -> float:
        """The crank, both ways."""
        return 2 * self.AB.si + self.AD.si
