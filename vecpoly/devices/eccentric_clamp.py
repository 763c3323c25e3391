"""An eccentric clamp: a round disc on an eccentric pin, turned by a handle, presses on the level face of the work."""

from __future__ import annotations

import cmath
from collections.abc import Collection
from math import atan, cos, sin
from typing import ClassVar, Literal

from pydantic import Field, model_validator

from ..errors import FaultError
from ..names import Named, reaction
from ..words import Words
from .base import Angle, Device, ForceSize, Length, Ratio, as_written


class EccentricClamp(Device):
    """Disc 1 of radius R and centre O on the pin A of the frame 3, AO = e at theta;
    its handle of length l at `handle`; work 2 under the disc.

    All angles from the x axis. F acts at the handle's end in the direction `F`, Q is the clamping force normal to the
    face;
    f: coefficient of friction on the workpiece, rho: radius of the friction circle at A, closing: sense in which it
    closes.
    """

    kind: ClassVar[str] = "eccentric-clamp"
    e: Length
    theta: Angle
    R: Length
    lever: Length = Field(alias="l")
    handle: Angle
    F: Angle
    closing: Literal["ccw", "cw"]
    f: Ratio
    rho: Length | None = None
    Q: ForceSize

    @model_validator(mode="after")
    def _possible(self) -> EccentricClamp:
        if self.e.si + self.radius >= self.R.si:
            raise FaultError(
                Words(
                    f"轴颈连同其摩擦圆应在偏心轮之内：e = {self.e.text} 与 rho = "
                    f"{self.rho.text if self.rho else '0 mm'} 之和已达 R = {self.R.text}",
                    f"the pin with its friction circle must lie inside the disc: e = {self.e.text} and rho = "
                    f"{self.rho.text if self.rho else '0 mm'} together reach R = {self.R.text}",
                ),
                keys=("e", "R", "rho"),
            )
        if self.turn * cos(self.theta.si) >= -1e-9:
            raise FaultError(
                Words(
                    f"按 {self.closing} 方向转动时，位于 theta = {self.theta.text} 的轮心并不向工件下移，"
                    "偏心夹具不能夹紧；请改正 theta 或 closing",
                    f"turned {self.closing}, the centre at theta = {self.theta.text} does not move down on the "
                    "work, so the clamp does not close; correct theta or closing",
                ),
                keys=("theta", "closing"),
            )
        if self.turn * sin(self.F.si - self.handle.si) <= 1e-9:
            raise FaultError(
                Words(
                    f"作用在手柄 {self.handle.text} 处、方向为 F = {self.F.text} 的力不能使夹具按 "
                    f"{self.closing} 方向转动；请改正 F 或 closing",
                    f"a force in the direction F = {self.F.text} on the handle at {self.handle.text} does not "
                    f"turn it {self.closing}; correct F or closing",
                ),
                keys=("handle", "F", "closing"),
            )
        return self

    @property
    def turn(self) -> float:
        """+1 where the clamp closes counter-clockwise, −1 clockwise."""
        return 1.0 if self.closing == "ccw" else -1.0

    @property
    def radius(self) -> float:
        """ρ (m)."""
        return self.rho.si if self.rho else 0.0

    @property
    def limited(self) -> bool:
        """Whether too large an e would open the clamp: with the centre at some angles it never does."""
        return self.turn * cmath.rect(1.0, self.theta.si + self.turn * atan(self.f.si)).real < -1e-9

    def task(self, asked: Collection[str]) -> Words:
        """A disc on a pin beside its centre."""
        sense = Words("逆时针", "counter-clockwise") if self.turn > 0 else Words("顺时针", "clockwise")
        pin = Words("，销轴的摩擦圆半径为 $ρ$", "; the friction circle of the pin has the radius $ρ$")
        circle = pin if self.rho else Words("，销轴的摩擦不计", "; the pin has no friction")
        return Words(
            "半径为 $R$、圆心为 $O$ 的偏心圆盘 1 绕机架 3 上的销轴 $A$ 转动，偏心距 $AO$ = $e$，从上方压紧工件 2 的水"
            f"平面，夹紧时{sense.zh}转动；力 $F$ 作用于长为 $l$ 的手柄端点。$AO$、手柄和 $F$ 的方向角依次为 $θ_O$、"
            f"$θ_l$、$θ_F$，自 $x$ 轴正向逆时针量起。接触处的摩擦系数为 $f${circle.zh}，所需的法向夹紧力为 $Q$。撤去 "
            "$F$ 后，工件反力对 $A$ 的力臂为 $h$。",
            "The eccentric disc 1 of radius $R$ and centre $O$ turns about the pin $A$ of the frame 3, with $AO$ = "
            f"$e$, and presses from above on the horizontal face of workpiece 2; it closes {sense.en}. $F$ acts at "
            "the end of the handle of length $l$. The directions of $AO$, handle and $F$, counter-clockwise from the "
            f"$x$ axis, are $θ_O$, $θ_l$ and $θ_F$. The coefficient of friction on the work is $f${circle.en}; the "
            "normal clamping force is to be $Q$. When $F$ is gone, the reaction of the work has the arm $h$ about "
            "$A$.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """φ, reactions, the force on the handle with and without friction, η;
        the arm of R_21 when F is gone, the verdict, the limit of e."""
        return (PHI, R21, FORCE, R31, IDEAL, ETA, ARM, SELF_LOCKING, *((E_LIMIT,) if self.limited else ()))

    def given(self) -> tuple[tuple[str, str], ...]:
        """Dimensions, position, friction, clamping force."""
        written = [
            ("e", self.e),
            ("R", self.R),
            ("l", self.lever),
            ("θ_O", self.theta),
            ("θ_l", self.handle),
            ("θ_F", self.F),
            ("f", self.f),
            ("ρ", self.rho),
            ("Q", self.Q),
        ]
        return as_written(written)

    @property
    def size(self) -> float:
        """Handle and disc."""
        return self.lever.si + self.R.si

    @property
    def force(self) -> float:
        """The clamping force."""
        return self.Q.si


PHI, ETA = Named("phi", "φ", "deg"), Named("eta", "η", "")
R21, R31 = reaction("2", "1"), reaction("3", "1")
FORCE, IDEAL = Named("F", "F", "N"), Named("F_0", "F_0", "N")
ARM, E_LIMIT = Named("h", "h", "m"), Named("e_limit", "e_{max}", "m")
SELF_LOCKING = Named("self_locking", "h ≤ ρ", "yes/no")
