"""Crank and guide bar from K and a stroke: the crank-shaper, whose bar swings, and Whitworth's, whose bar turns."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import cos
from typing import Any, ClassVar, Self

from pydantic import model_validator

from ..devices.base import Length, as_written
from ..devices.defined import sentence
from ..names import Named
from ..words import Words
from .base import Design, Quick, between_limits
from .linkages import shaper, whitworth
from .quantities import AB, AC, ALPHA_MAX, CD, HEIGHT, RETURN, THETA
from .quantities import K as ADVANCE

LONG = 3.0  # times CD, or the least that serves: a rod DE where none is given, for the motion alone


class QuickReturn(Design):
    """K, the stroke H and the crank AB or the frame AC."""

    K: Quick
    H: Length
    AB: Length | None = None
    AC: Length | None = None
    DE: Length | None = None

    @model_validator(mode="after")
    def _determined(self) -> Self:
        self.one_of("AB", "AC")
        return self

    def given(self) -> tuple[tuple[str, str], ...]:
        """K, H, and what is given beside."""
        written = (("K", self.K), ("H", self.H), ("l_{AB}", self.AB), ("l_{AC}", self.AC), ("l_{DE}", self.DE))
        return as_written(written)

    def rod(self, values: Mapping[str, float]) -> float:
        """DE, mm."""
        return 1e3 * self.DE.si if self.DE is not None else LONG * max(values["CD"], self.least_rod(values["CD"]))

    def assumed(self, values: Mapping[str, float]) -> Words | None:
        """A rod DE of our own."""
        if self.DE is not None:
            return None
        rod = f"{self.rod(values):.4g} mm"
        return Words(f"自取的连杆 DE = {rod} ", f"a rod DE = {rod} of our choice")

    def least_rod(self, lever: float) -> float:
        """What DE must exceed for the ram to turn back where lever or bar does, and nowhere else; lever: CD."""
        return lever

    @property
    def theta(self) -> float:
        """θ = π (K − 1) / (K + 1), rad."""
        return between_limits(self.K)


class Shaper(QuickReturn):
    """K, the stroke H and the crank AB or the frame AC; DE, where the pressure angle at the ram is asked.

    C, about which the lever swings, is the origin, A above it; the ram's guide is level, through the middle of the
    height of D's arc, where the pressure angle is least.
    """

    kind: ClassVar[str] = "shaper"

    def task(self, asked: Collection[str]) -> Words:
        """Crank, lever, rod, ram."""
        return sentence(
            Words(
                "牛头刨床的曲柄 $AB$ 绕 $A$ 转动，经滑块 $B$ 带动绕 $C$ 摆动的导杆 $CD$，再经连杆 $DE$ 带动滑枕 $E$",
                "the crank $AB$ of a shaper turns about $A$ and drives the lever $CD$, which swings about $C$, "
                "through the block $B$; the lever drives the ram $E$ through the rod $DE$",
            ),
            Words("$AC$ 为机架，$A$ 在 $C$ 的正上方", "$AC$ is the frame, $A$ straight above $C$"),
            Words(
                "滑枕的导路水平，到 $C$ 的距离 $h$ 应使滑枕处的压力角最小",
                "the guide of the ram is level, at that distance $h$ from $C$ with which the pressure angle at the "
                "ram is least",
            ),
            Words("滑枕的行程 $H$ 和", "the stroke $H$ of the ram and ") + RETURN + Words("已知", " are given"),
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, which is the swing of the lever, crank, frame, lever, height of the guide; with DE the pressure angle."""
        return (THETA, AB, AC, CD, HEIGHT, *((ALPHA_MAX,) if self.DE is not None else ()), ADVANCE)

    def least_rod(self, lever: float) -> float:
        """MN / (2 cos(θ/2)): a shorter rod comes in line with the lever before this turns back, and the ram with it."""
        across = cos(self.theta / 2)
        return lever * (1.0 - across) / (2.0 * across)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Crank, lever, rod and ram."""
        return shaper(values, self.rod(values), self.omega)

    @property
    def size(self) -> float:
        """The stroke."""
        return 2 * self.H.si


class Whitworth(QuickReturn):
    """K, the stroke H and the crank AB or the frame AC; the slider runs on the line through C square to AC."""

    kind: ClassVar[str] = "whitworth"

    def task(self, asked: Collection[str]) -> Words:
        """Crank, bar, rod, slider."""
        return sentence(
            Words(
                "转动导杆机构的曲柄 $AB$ 绕 $A$ 转动，经滑块 $B$ 带动绕 $C$ 整周转动的导杆，导杆反向延长线上的 $D$ 经"
                "连杆 $DE$ 带动滑块 $E$",
                "the crank $AB$ turns about $A$ and drives a bar, which turns right round about $C$, through the block "
                "$B$; its arm $CD$, beyond $C$ as seen from $B$, drives the slider $E$ through the rod $DE$",
            ),
            Words(
                "$E$ 的导路过 $C$ 且垂直于机架 $AC$",
                "the line of $E$ passes through $C$ at right angles to the frame $AC$",
            ),
            Words("滑块的行程 $H$ 和", "the stroke $H$ of the slider and ") + RETURN + Words("已知", " are given"),
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, crank, frame, arm of the bar, K."""
        return (THETA, AB, AC, CD, ADVANCE)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Crank, bar, rod and slider."""
        return whitworth(values, self.rod(values), self.omega)

    @property
    def size(self) -> float:
        """Twice the crank, or the frame."""
        length = self.AB or self.AC
        assert length is not None
        return 3 * length.si
