"""A slider-crank from its time ratio K, its stroke, and one datum more."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import degrees
from typing import Any, ClassVar

from pydantic import model_validator

from ..devices.base import Length, as_written
from ..devices.defined import sentence
from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Advance, Design, between_limits
from .linkages import slider_crank
from .quantities import AB, ALPHA_MAX, BC, GAMMA_MIN, OFFSET, RETURN, STROKE, THETA
from .quantities import K as ADVANCE

_VARIED = (OFFSET, AB, BC, ADVANCE)


class SliderCrank(Design):
    """K, the stroke H, and the offset e, the crank or the coupler; C₁ is the origin, C₂ on the x axis, A above it."""

    ranged: ClassVar[tuple[Named, ...]] = _VARIED
    kind: ClassVar[str] = "slider-crank"
    K: Advance
    H: Length
    e: Length | None = None
    AB: Length | None = None
    BC: Length | None = None

    @model_validator(mode="after")
    def _determined(self) -> SliderCrank:
        if self.K.si == 1 and self.BC is None:
            raise FaultError(
                Words(
                    "K = 1：θ = 0，则 e = 0、AB = H/2，BC 任意；请改为给定 BC，如 BC: 120 mm，否则须 K > 1，如 1.5",
                    "K = 1 means θ = 0, so that e = 0 and AB = H/2, whatever BC: give BC instead, e.g. BC: 120 mm; "
                    "else K > 1 is needed, e.g. 1.5",
                ),
                code="out-of-range",
            )
        if self.K.si >= 3:
            raise FaultError(
                Words(
                    f"K = {self.K.text}：θ = {degrees(self.theta):.4g}° 不小于 90°，A 到导路的垂足必在 C₁、C₂ 之间，"
                    "没有这样的曲柄滑块机构；须 K < 3，如 1.5",
                    f"K = {self.K.text} means θ = {degrees(self.theta):.4g} deg, no less than 90: the foot of A on "
                    "the guide would always lie between C₁ and C₂, and no slider-crank has this ratio; K < 3 is "
                    "needed, e.g. 1.5",
                ),
                code="out-of-range",
            )
        self.one_of("e", "AB", "BC")
        return self

    def task(self, asked: Collection[str]) -> Words:
        """A slider-crank from its time ratio."""
        offset = self.e is not None or "e" in asked
        guide = Words("$e$ 为导路到 $A$ 的偏距", "$e$ is the offset of the guide from $A$") if offset else Words("", "")
        return sentence(
            Words(
                "设计偏置曲柄滑块机构：曲柄 $AB$ 绕 $A$ 转动，经连杆 $BC$ 带动滑块 $C$",
                "design an offset slider-crank, whose crank $AB$ turns about $A$ and drives the slider $C$ through the "
                "coupler $BC$",
            ),
            Words("滑块的行程 $H$ 和", "the stroke $H$ of the slider and ") + RETURN + Words("已知", " are given"),
            guide,
        )

    def quantities(self) -> tuple[Named, ...]:
        """θ, crank, coupler, offset, stroke, greatest pressure and least transmission angle, K."""
        return (THETA, AB, BC, OFFSET, STROKE, ALPHA_MAX, GAMMA_MIN, ADVANCE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """K, H, and what is given beside."""
        written = (("K", self.K), ("H", self.H), ("e", self.e), ("l_{AB}", self.AB), ("l_{BC}", self.BC))
        return as_written(written)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The slider-crank with A in the origin."""
        return slider_crank(values, self.omega)

    @property
    def theta(self) -> float:
        """θ = π (K − 1) / (K + 1), rad."""
        return between_limits(self.K)

    @property
    def size(self) -> float:
        """The stroke."""
        return 2 * self.H.si
