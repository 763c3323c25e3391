"""The two cognates of a four-bar, which lead a point along the same coupler curve (Roberts and Chebyshev)."""

from __future__ import annotations

from collections.abc import Collection
from math import cos, degrees
from typing import ClassVar, Literal

from pydantic import model_validator

from ...devices.base import Angle, Length
from ...errors import FaultError
from ...names import Named
from ...words import Words
from ..base import Design
from ..linkages import OF_COUPLER
from .written import Place

STRETCHED = 1e-9  # of BC + CD: by so little they meet or miss at random
LEFT, RIGHT = ("AG", "GH", "HF", "AF"), ("DM", "MN", "NF", "DF")


class Cognates(Design):
    """The four-bar ABCD at the angle phi of AB, C on one side of the ray BD, and E in the coordinates of BC.

    A G H F is the left cognate, D M N F the right one; A is the origin, D lies on the x axis.
    """

    kind: ClassVar[str] = "cognates"
    AB: Length
    BC: Length
    CD: Length
    AD: Length
    E: Place
    phi: Angle
    side: Literal["left", "right"] = "left"

    @model_validator(mode="after")
    def _closes(self) -> Cognates:
        a, d = self.AB.si, self.AD.si
        apart = (a * a + d * d - 2 * a * d * cos(self.phi.si)) ** 0.5
        least, most = abs(self.BC.si - self.CD.si), self.BC.si + self.CD.si
        if not least + STRETCHED * most < apart < (1 - STRETCHED) * most:
            phi = degrees(self.phi.si)
            raise FaultError(
                Words(
                    f"phi = {phi:.6g}°：BD = {1e3 * apart:.6g} mm，而 BC、CD 只能联接相距大于 {1e3 * least:.6g} "
                    f"而小于 {1e3 * most:.6g} mm 的两点；请改变 phi 或长度",
                    f"phi = {phi:.6g} deg: BD = {1e3 * apart:.6g} mm, while BC and CD join points more than "
                    f"{1e3 * least:.6g} and less than {1e3 * most:.6g} mm apart; change phi or the lengths",
                ),
                "phi",
                code="out-of-reach",
            )
        if min(abs(self.E.at), abs(self.E.at - self.BC.si)) <= 1e-9 * self.BC.si:
            raise FaultError(
                Words(
                    f"E = {self.E.text} 与 B 或 C 重合，其轨迹是圆弧，没有同源机构；请另取 E",
                    f"E = {self.E.text} is B or C itself, whose path is a circle and has no cognates; choose another E",
                ),
                "E",
                code="out-of-range",
            )
        return self

    def task(self, asked: Collection[str]) -> Words:
        """A four-bar and both its cognates."""
        side = Words("左", "left") if self.side == "left" else Words("右", "right")
        return Words(
            "铰链四杆机构 $ABCD$ 的 $A$ 为原点，机架 $AD$ 在 $x$ 轴上，$AB$ 的位置角 $φ$ 自 $x$ 轴逆时针量起，$C$ 在"
            f"由 $B$ 到 $D$ 的射线{side.zh}侧，$E$ 为连杆上的点。按罗伯茨"
            "—切比雪夫定理作出使 $E$ 画出同一轨迹的两个同源机构：左侧的 $AGHF$（机架 $AF$）和右侧的 $DMNF$（机架 "
            "$DF$）。",
            "In the four-bar linkage $ABCD$, $A$ is the origin and the frame $AD$ lies on the $x$ axis; $AB$ stands "
            f"at the angle $φ$, counter-clockwise from the $x$ axis, and $C$ on the {side.en} of the ray from $B$ to "
            "$D$. $E$ is a point of the coupler. "
            "Draw by the theorem of Roberts and Chebyshev both cognates that lead $E$ "
            "along the same path: $AGHF$ on the left, with the frame $AF$, and $DMNF$ on the right, with the frame "
            "$DF$.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """The lengths of both cognates."""
        return tuple(Named(letters, f"l_{{{letters}}}", "mm") for letters in (*LEFT, *RIGHT))

    def told(self) -> tuple[Words, ...]:
        """From where the coupler's point is counted."""
        return (OF_COUPLER,)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The four-bar, its coupler point and its position."""
        lengths = (("AB", self.AB), ("BC", self.BC), ("CD", self.CD), ("AD", self.AD))
        return (
            *((f"l_{{{letters}}}", length.text) for letters, length in lengths),
            ("E", self.E.text),
            ("φ", self.phi.text),
        )

    @property
    def size(self) -> float:
        """Frame and coupler."""
        return 2 * max(self.AD.si, self.BC.si, abs(self.E.at))
