"""The slide of a machine tool on a flat and a V guide: which coefficient of friction a single flat guide would need."""

from __future__ import annotations

from collections.abc import Collection
from math import pi
from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Angle, Device, ForceSize, Length, Ratio


class VeeGuide(Device):
    """G acts at the distance l1 from the V guide and l2 from the flat one;
    theta: half the angle of the V; f: coefficient of friction.

    The width of the V is neglected in the lever arms.
    """

    kind: ClassVar[str] = "vee-guide"
    f: Ratio
    G: ForceSize
    l1: Length
    l2: Length
    theta: Angle

    @model_validator(mode="after")
    def _possible(self) -> VeeGuide:
        if not pi / 36 - 1e-9 <= self.theta.si <= pi / 2 * 17 / 18 + 1e-9:
            raise FaultError(
                Words(
                    f"theta = {self.theta.text} 是槽形半角，应在 5 与 85 deg 之间；槽形角为 100 deg 时写 theta: 50 deg",
                    f"theta = {self.theta.text} is half the angle of the V, between 5 and 85 deg; a V of 100 "
                    "deg has theta: 50 deg",
                ),
                code="out-of-range",
                keys=("theta",),
            )
        return self

    def task(self, asked: Collection[str]) -> Words:
        """A slide on a V guide and a flat one."""
        return Words(
            "机床滑台支承在一条 V 形导轨 1 和一条平导轨 2 上移动，总载荷 $G$ 到两导轨的水平距离为 $l_1$ 和 $l_2$（V "
            "形的宽度略去不计）；V 形的半角为 $θ$，各接触面的摩擦系数均为 $f$。",
            "The slide of a machine tool moves on a V guide 1 and a flat guide 2. The whole load $G$ acts at the "
            "horizontal distances $l_1$ and $l_2$ from the guides (the width of the V is neglected); half the angle "
            "of the V is $θ$, and all faces have the coefficient of friction $f$.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """The shares of the load, the force on each flank, friction on each guide, equivalent coefficients."""
        return (ON_V, ON_FLAT, FLANK, F_VEE, FRICTION_V, FRICTION_FLAT, FRICTION, F_WHOLE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Load, distances, half angle, coefficient of friction."""
        return (
            ("G", self.G.text),
            ("l_1", self.l1.text),
            ("l_2", self.l2.text),
            ("θ", self.theta.text),
            ("f", self.f.text),
        )

    @property
    def force(self) -> float:
        """The load."""
        return self.G.si


ON_V, ON_FLAT = Named("F1", "F_1", "N"), Named("F2", "F_2", "N")
FLANK = Named("N_flank", "N", "N")
FRICTION_V, FRICTION_FLAT, FRICTION = (
    Named("F_f_V", "F_{f1}", "N"),
    Named("F_f_flat", "F_{f2}", "N"),
    Named("F_f", "F_f", "N"),
)
F_VEE, F_WHOLE = Named("f_vee", "f_{V1}", ""), Named("f_V", "f_V", "")
