"""The scale of a figure: what a millimetre on paper stands for, and how it is told."""

from __future__ import annotations

from math import degrees

from ..figures.mu import Mu
from ..foundation.slotted import dataclass, replace
from .place import View


@dataclass(frozen=True, slots=True, kw_only=True)
class Scale:
    """μ: what 1 mm on paper stands for. value in `unit` per mm; symbol e.g. ``μ_v``.

    across: of what is set out to the right, where that is another quantity. degrees: it is told in °/mm.
    """

    symbol: str
    value: float
    unit: str  # "m", "m/s", "m/s^2"
    across: Scale | None = None
    degrees: bool = False

    @classmethod
    def of(cls, view: View, value: float, across: float | None = None) -> Scale:
        """The scale of a kind of figure, with this value (SI per mm), and that of what is set out to the right."""
        made = cls._with(view.mu, value)
        return made if view.across is None or across is None else replace(made, across=cls._with(view.across, across))

    @classmethod
    def _with(cls, mu: Mu, value: float) -> Scale:
        return cls(symbol=mu.symbol, value=value, unit=mu.unit, degrees=mu.degrees)

    @property
    def right(self) -> Scale:
        """The scale of what is set out to the right."""
        return self.across or self

    @property
    def told(self) -> Scale:
        """As it is told: in degrees, where an axis is divided by them."""
        whole = float(f"{degrees(self.value):.10g}")
        return replace(self, value=whole, unit="°", degrees=False) if self.degrees else self

    @property
    def per_mm(self) -> str:
        """The unit of the scale as printed: m/mm, (m/s)/mm."""
        return f"({self.unit})/mm" if "/" in self.unit else f"{self.unit}/mm"
