"""A slider-crank from the coefficient K of its quick return, its stroke, and one datum more."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import Any, ClassVar

from pydantic import model_validator

from ..devices.base import Length
from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Advance, Design
from .linkages import slider_crank
from .quantities import AB, ALPHA_MAX, BC, GAMMA_MIN, OFFSET, STROKE, THETA
from .quantities import K as ADVANCE


class SliderCrank(Design):
    """K, the stroke H, and the offset e, the crank or the coupler; C₁ is the origin, C₂ on the x axis, A above it."""

    kind: ClassVar[str] = "slider-crank"
    K: Advance
    H: Length
    e: Length | None = None
    AB: Length | None = None
    BC: Length | None = None

    @model_validator(mode="after")
    def _determined(self) -> SliderCrank:
        more = [name for name in ("e", "AB", "BC") if getattr(self, name) is not None]
        if len(more) != 1:
            raise FaultError(
                Words(
                    f"还须且只须给定 e、AB、BC 之一，此处有：{'、'.join(more) or '无'}；如写 e: 20 mm",
                    f"just one of e, AB, BC is needed beside, and here are: {', '.join(more) or 'none'}; "
                    "write e.g. e: 20 mm",
                ),
                code="contradiction",
            )
        if self.K.si == 1:
            raise FaultError(
                Words(
                    "K = 1：对心曲柄滑块机构无急回，l_AB = H/2，偏距为零，连杆任取；求急回机构须 K > 1",
                    "K = 1: a slider-crank without quick return is central, l_AB = H/2 with any coupler; "
                    "K > 1 is needed here",
                ),
                code="out-of-range",
            )
        return self

    def quantities(self) -> tuple[Named, ...]:
        """θ, crank, coupler, offset, stroke, greatest pressure and least transmission angle, K."""
        return (THETA, AB, BC, OFFSET, STROKE, ALPHA_MAX, GAMMA_MIN, ADVANCE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """K, H, and what is given beside."""
        written = (("K", self.K), ("H", self.H), ("e", self.e), ("l_{AB}", self.AB), ("l_{BC}", self.BC))
        return tuple((symbol, value.text) for symbol, value in written if value is not None)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The slider-crank with A in the origin."""
        return slider_crank(values, self.omega)

    @property
    def theta(self) -> float:
        """θ = π (K − 1) / (K + 1), rad."""
        return pi * (self.K.si - 1) / (self.K.si + 1)

    @property
    def size(self) -> float:
        """The stroke."""
        return 2 * self.H.si
