"""Linkages whose lengths are given: their limit positions, and what follows from them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from ..devices.base import Beside, Length, as_written
from ..names import Named
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
