"""A clamping wedge: wedge 3 between body 2 and work 1, with friction on both faces;
does it stay in when nothing holds it?"""

from __future__ import annotations

from collections.abc import Collection
from math import degrees
from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError
from ..names import Named, reaction
from ..words import Words
from .base import Angle, Device, ForceSize, Ratio


class WedgeClamp(Device):
    """α: angle of the wedge; f: friction of both faces; R: the clamping force of body 2 on the wedge, R_23."""

    kind: ClassVar[str] = "wedge-clamp"
    alpha: Angle
    f: Ratio
    R: ForceSize

    @model_validator(mode="after")
    def _possible(self) -> WedgeClamp:
        if not 0 < degrees(self.alpha.si) < 90:
            raise FaultError(
                Words(
                    f"alpha = {self.alpha.text}：楔角应在 0 与 90 deg 之间",
                    f"alpha = {self.alpha.text}: the angle of the wedge must lie between 0 and 90 deg",
                ),
                code="out-of-range",
                keys=("alpha",),
            )
        return self

    def task(self, asked: Collection[str]) -> Words:
        """A wedge between the work and a body."""
        return Words(
            "夹具中，楔块 3 打入工件 1 与构件 2 之间将工件夹紧，楔角为 $α$，两工作面的摩擦系数均为 $f$，构件 2 对楔块的"
            "作用力为 $R_{23}$。撤去打入力后，沿工件表面作用、阻止楔块退出的力为 $F'$，不计摩擦时为 $F'_{0}$。",
            "In a fixture wedge 3 is driven in between workpiece 1 and body 2. The wedge angle is $α$, the coefficient "
            "of friction of both faces $f$; body 2 presses on the wedge with $R_{23}$. When the driving force is gone, "
            "a force $F'$ along the face of the work stops the wedge from slipping out, $F'_{0}$ without friction.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """φ, limit of α, F' that holds the wedge in (not positive:
        it needs none), by formula, without friction, R_13, η'."""
        return PHI, LIMIT, HOLD, BY_SINES, IDEAL, PRESSED, ETA_BACK

    def given(self) -> tuple[tuple[str, str], ...]:
        """α, f, R_23."""
        return ("α", self.alpha.text), ("f", self.f.text), ("R_{23}", self.R.text)

    @property
    def force(self) -> float:
        """The clamping force."""
        return self.R.si


PHI, LIMIT = Named("phi", "φ", "deg"), Named("alpha_limit", "α_{lim}", "deg")
HOLD, BY_SINES, IDEAL = Named("F", "F'", "N"), Named("F_sine", "F'", "N"), Named("F_0", "F'_{0}", "N")
CLAMP, PRESSED = reaction("2", "3"), reaction("1", "3")
ETA_BACK = Named("eta", "η'", "")
