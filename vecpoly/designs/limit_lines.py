"""A crank-rocker from the lines of its coupler in both limits and the pressure angle in one of them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import pi
from typing import Any, ClassVar

from pydantic import model_validator

from ..devices.base import Angle
from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Design
from .linkages import four_bar
from .place import Fixed
from .quantities import FOUR_BAR, GAMMA_MIN, SWING, THETA
from .quantities import K as ADVANCE

_VARIED = (Named("alpha_1", "α_1", "deg"), Named("line_2", "δ_2", "deg"))


class LimitLines(Design):
    """C₁ and C₂, the directions of the coupler's line there (from the x axis), and the pressure angle α₁ at C₁."""

    ranged: ClassVar[tuple[Named, ...]] = _VARIED
    kind: ClassVar[str] = "limit-lines"
    C1: Fixed
    C2: Fixed
    line_1: Angle
    line_2: Angle
    alpha_1: Angle

    @model_validator(mode="after")
    def _possible(self) -> LimitLines:
        if not 0 <= self.alpha_1.si < pi / 2:
            raise FaultError(
                Words(
                    f"alpha_1 = {self.alpha_1.text}：压力角应不小于 0 且小于 90°",
                    f"alpha_1 = {self.alpha_1.text}: a pressure angle lies between 0 and 90 deg",
                ),
                code="out-of-range",
            )
        if self.C1.at == self.C2.at:
            raise FaultError(Words("C1 与 C2 重合；应为两个点", "C1 and C2 coincide; two points are needed"))
        return self

    def task(self, asked: Collection[str]) -> Words:
        """The coupler's lines in the limit positions."""
        return Words(
            "设计曲柄摇杆机构 $ABCD$（曲柄 $AB$，连杆 $BC$，摇杆 $CD$，机架 $AD$）。在摇杆的两极限位置，$C$ 位于 "
            "$C_1$、$C_2$，连杆分别在过这两点的给定直线上，直线的方向角 $δ_1$、$δ_2$ 自 $x$ 轴正向起、逆时针为正；"
            "$C_1$ 处的压力角为 $α_1$。",
            "Design a crank-rocker $ABCD$ (crank $AB$, coupler $BC$, rocker $CD$, frame $AD$). In the limit "
            "positions of the rocker $C$ lies at $C_1$ and $C_2$ and the coupler on two given lines through these "
            "points, whose directions $δ_1$ and $δ_2$ count counter-clockwise from the $x$ axis; the pressure angle "
            "at $C_1$ is $α_1$.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, K, the four lengths, swing and least transmission angle."""
        return (THETA, ADVANCE, *FOUR_BAR, SWING, GAMMA_MIN)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The two points, the two lines, the pressure angle."""
        return (
            ("C_1", self.C1.text),
            ("C_2", self.C2.text),
            ("δ_1", self.line_1.text),
            ("δ_2", self.line_2.text),
            ("α_1", self.alpha_1.text),
        )

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The four-bar with A in the origin and D on the x axis."""
        return four_bar(values, self.omega)

    @property
    def size(self) -> float:
        """Some of C₁C₂."""
        return 2 * abs(self.C2.at - self.C1.at)
