"""A four-bar that leads a coupler point nearly along a straight line: how straight, and how far."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import cos, degrees, pi
from typing import Any, ClassVar, Literal

from pydantic import model_validator

from ..devices.base import Angle, Length
from ..errors import FaultError
from ..names import Named
from ..units.reading import Quantity
from ..words import Words
from .base import Design
from .inversion.written import Place
from .linkages import OF_COUPLER, four_bar
from .ranges import extremes

L, BAND = Named("L", "L", "mm"), Named("delta", "δ", "mm")
SLACK = 1e-9  # of a length: at a dead point


class StraightLine(Design):
    """The four-bar ABCD, E in the coordinates of BC, C on one side of the ray BD, and AB turning from one angle to
    another. A is the origin, D lies on the x axis; the straight part is parallel to AD.
    """

    kind: ClassVar[str] = "straight-line"
    AB: Length
    BC: Length
    CD: Length
    AD: Length
    E: Place
    phi: tuple[Angle, Angle]
    side: Literal["left", "right"] = "left"

    @model_validator(mode="after")
    def _closes(self) -> StraightLine:
        low, high = sorted(end.si for end in self.phi)
        if not 0 < high - low < 2 * pi:
            raise FaultError(
                Words(
                    f"phi 的范围 {self.phi[0].text} 至 {self.phi[1].text} 应大于 0 且小于 360°",
                    f"the range of phi, {self.phi[0].text} to {self.phi[1].text}, must be above 0 and below 360 deg",
                ),
                "phi",
                code="out-of-range",
            )
        for phi in extremes(low, high):
            self._reaches(phi)
        return self

    def _spans(self, phi: float) -> tuple[float, float, float]:
        """BD with AB there, and between which distances BC and CD reach (m)."""
        a, d = self.AB.si, self.AD.si
        apart = max(a * a + d * d - 2 * a * d * cos(phi), 0.0) ** 0.5
        return apart, abs(self.BC.si - self.CD.si), self.BC.si + self.CD.si

    def dead(self, phi: float) -> bool:
        """Whether B, C and D are in line there: AB turns no further, and E leaves the place at once."""
        apart, least, most = self._spans(phi)
        return min(abs(apart - least), abs(apart - most)) <= SLACK * most

    def _reaches(self, phi: float) -> None:
        """BC and CD can be joined with AB there."""
        apart, least, most = self._spans(phi)
        if not least - SLACK * most <= apart <= most * (1 + SLACK):
            raise FaultError(
                Words(
                    f"φ = {degrees(phi):.6g}° 时 BD = {1e3 * apart:.6g} mm，而 BC、CD 只能联接相距 {1e3 * least:.6g} "
                    f"至 "
                    f"{1e3 * most:.6g} mm 的两点；请改变 phi 或长度",
                    f"at φ = {degrees(phi):.6g} deg BD = {1e3 * apart:.6g} mm, while BC and CD join points between "
                    f"{1e3 * least:.6g} and {1e3 * most:.6g} mm apart; change phi or the lengths",
                ),
                "phi",
                code="out-of-reach",
            )

    def task(self, asked: Collection[str]) -> Words:
        """A four-bar, a point of whose coupler runs nearly straight."""
        side = Words("左", "left") if self.side == "left" else Words("右", "right")
        return Words(
            f"铰链四杆机构 $ABCD$ 的 $A$ 为原点，机架 $AD$ 在 $x$ 轴上，$C$ 在由 $B$ 到 $D$ 的射线{side.zh}侧；$E$ 为"
            "连杆 $BC$ 上的点。$AB$ 的位置角 $φ$ 自 $x$ 轴逆时针量起，"
            "在给定范围内转动时 $E$ 的轨迹近似为平行于 $AD$ 的直线段，其长度为 $L$，轨迹所在带的宽度为 $δ$。",
            "In the four-bar linkage $ABCD$, $A$ is the origin and the frame $AD$ lies on the $x$ axis, with $C$ on "
            f"the {side.en} of the ray from $B$ to $D$; $E$ is a point of the coupler. "
            "While $AB$ turns through the range of its "
            "angle $φ$, counter-clockwise from the $x$ axis, $E$ runs nearly straight and parallel to $AD$: $L$ is "
            "the length of that part of its path, $δ$ the width of the band in which it lies.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """The length of the straight part, the width of the band in which it lies."""
        return L, BAND

    def told(self) -> tuple[Words, ...]:
        """From where the coupler's point is counted."""
        return (OF_COUPLER,)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The four-bar, its coupler point, the range."""
        return (
            *((f"l_{{{letters}}}", length.text) for letters, length in self.bars.items()),
            ("E", self.E.text),
            ("φ", f"{self.phi[0].text} … {self.phi[1].text}"),
        )

    @property
    def bars(self) -> Mapping[str, Quantity]:
        """The four lengths."""
        return {"AB": self.AB, "BC": self.BC, "CD": self.CD, "AD": self.AD}

    @property
    def is_given(self) -> bool:
        """Of the linkage nothing is sought."""
        return True

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The linkage as it is given, with its coupler point, in the middle of the range."""
        data = four_bar({key: 1e3 * length.si for key, length in self.bars.items()}, self.omega)
        spot = {"along": "BC", "at": f"{1e3 * self.E.at.real!r} mm", "left": f"{1e3 * self.E.at.imag!r} mm"}
        data["links"] = data["links"] | {"2": data["links"]["2"] | {"E": spot}}
        data["input"] = data["input"] | {"phi": f"{degrees(self.phi[0].si + self.phi[1].si) / 2!r} deg"}
        return data | {"branch": [f"C {self.side} of BD"], "find": ["v_E", "omega_2", "omega_3", "a_E"]}

    @property
    def size(self) -> float:
        """Input link and frame."""
        return self.AB.si + self.AD.si + abs(self.E.at)
