"""Linkages whose lengths are given: their limit positions, and what follows from them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any, ClassVar

from ..devices.base import Beside, Length, as_written
from ..names import Named
from ..words import Words
from .base import Design
from .linkages import four_bar, guide_bar, slider_crank
from .quantities import AB as CRANK
from .quantities import AC as FRAME
from .quantities import ALPHA_MAX, FOUR_BAR, GAMMA_MIN, OFFSET, STROKE, SWING, THETA
from .quantities import BC as COUPLER
from .quantities import K as ADVANCE


class CrankRockerLimits(Design):
    """A crank-rocker by its four lengths; A is the origin, D on the x axis."""

    kind: ClassVar[str] = "crank-rocker-limits"
    AB: Length
    BC: Length
    CD: Length
    AD: Length

    def task(self, asked: Collection[str]) -> Words:
        """A crank-rocker in its limit positions."""
        return Words(
            "曲柄摇杆机构 $ABCD$ 的曲柄 $AB$ 为原动件，$BC$ 为连杆，$CD$ 为摇杆，$AD$ 为机架，各构件的长度已知；作出"
            "其两极限位置。",
            "The crank $AB$ drives the crank-rocker $ABCD$, with the coupler $BC$, the rocker $CD$ and the frame $AD$; "
            "the lengths are given. Draw it in its limit positions.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, K, swing, least transmission angle; the lengths as given."""
        return (THETA, ADVANCE, SWING, GAMMA_MIN, *FOUR_BAR)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The four lengths."""
        return tuple((named.symbol, getattr(self, named.key).text) for named in FOUR_BAR)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The four-bar itself."""
        return four_bar(values, self.omega)

    @property
    def size(self) -> float:
        """Coupler and crank in one line."""
        return self.AB.si + self.BC.si


class SliderCrankLimits(Design):
    """A slider-crank by crank, coupler and offset; A is the origin, the guide below it."""

    kind: ClassVar[str] = "slider-crank-limits"
    AB: Length
    BC: Length
    e: Beside | None = None

    def task(self, asked: Collection[str]) -> Words:
        """A slider-crank in its limit positions."""
        offset = Words("在 $A$ 下方 $e$ 处", "at the distance $e$ below $A$")
        guide = offset if self.e is not None else Words("通过 $A$", "through $A$")
        return Words(
            f"曲柄滑块机构的曲柄 $AB$ 绕 $A$ 转动，为原动件，经连杆 $BC$ 带动滑块 $C$，滑块的水平导路{guide.zh}；作出"
            "其两极限位置。",
            "The crank $AB$, which turns about $A$, drives the slider $C$ through the coupler $BC$ along a level guide "
            f"{guide.en}. Draw the mechanism in its limit positions.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, K, stroke, greatest pressure and least transmission angle; the lengths as given."""
        return (THETA, ADVANCE, STROKE, ALPHA_MAX, GAMMA_MIN, CRANK, COUPLER, OFFSET)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Crank, coupler, offset."""
        written = (("l_{AB}", self.AB), ("l_{BC}", self.BC), ("e", self.e))
        return as_written(written)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The slider-crank itself."""
        return slider_crank(values, self.omega)

    @property
    def offset(self) -> float:
        """e in m; 0 where none is given."""
        return 0.0 if self.e is None else self.e.si

    @property
    def size(self) -> float:
        """Coupler and crank in one line."""
        return self.AB.si + self.BC.si


class GuideBarLimits(Design):
    """A crank that drives an oscillating guide bar: crank, frame, distance of the bar's line from its pivot C."""

    kind: ClassVar[str] = "guide-bar-limits"
    AB: Length
    AC: Length
    e: Beside | None = None

    def task(self, asked: Collection[str]) -> Words:
        """A guide bar in its limit positions."""
        offset = Words("导杆的槽中线到 $C$ 的距离为 $e$", "the line of whose slot passes at the distance $e$ from $C$")
        line = offset if self.e is not None else Words("槽中线过 $C$", "the line of whose slot passes through $C$")
        return Words(
            f"摆动导杆机构的曲柄 $AB$ 绕 $A$ 转动，为原动件，经滑块 $B$ 带动导杆绕 $C$ 摆动，{line.zh}，$AC$ 为机架；"
            "作出其两极限位置。",
            "The crank $AB$, which turns about $A$, drives through the block $B$ a guide bar that swings about $C$, "
            f"{line.en}; $AC$ is the frame. Draw the mechanism in its limit positions.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, K, swing, greatest pressure and least transmission angle; the lengths as given."""
        return (THETA, ADVANCE, SWING, ALPHA_MAX, GAMMA_MIN, CRANK, FRAME, OFFSET)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Crank, frame, offset."""
        written = (("l_{AB}", self.AB), ("l_{AC}", self.AC), ("e", self.e))
        return as_written(written)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Crank, block and guide bar."""
        return guide_bar(values, self.omega)

    @property
    def offset(self) -> float:
        """e in m; 0 where none is given."""
        return 0.0 if self.e is None else self.e.si

    @property
    def size(self) -> float:
        """Frame and crank in one line."""
        return self.AC.si + self.AB.si
