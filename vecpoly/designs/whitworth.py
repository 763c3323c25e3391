"""Whitworth's quick return (rotating guide bar) from K and the stroke of its slider."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from pydantic import model_validator

from ..devices.base import Length, as_written
from ..names import Named
from .base import Design, Quick, between_limits
from .linkages import whitworth
from .quantities import AB, AC, CD, THETA
from .quantities import K as ADVANCE

LONG = 3.0  # arms CD: a rod DE where none is given, for the motion alone


class Whitworth(Design):
    """K, the stroke H and the crank AB or the frame AC; the slider runs on the line through C square to AC."""

    kind: ClassVar[str] = "whitworth"
    K: Quick
    H: Length
    AB: Length | None = None
    AC: Length | None = None
    DE: Length | None = None

    @model_validator(mode="after")
    def _determined(self) -> Whitworth:
        self.one_of("AB", "AC")
        return self

    def quantities(self) -> tuple[Named, ...]:
        """θ, crank, frame, arm of the bar, K."""
        return (THETA, AB, AC, CD, ADVANCE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """K, H, and what is given beside."""
        written = (("K", self.K), ("H", self.H), ("l_{AB}", self.AB), ("l_{AC}", self.AC), ("l_{DE}", self.DE))
        return as_written(written)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Crank, bar, rod and slider."""
        return whitworth(values, 1e3 * self.DE.si if self.DE is not None else LONG * values["CD"], self.omega)

    @property
    def theta(self) -> float:
        """θ = π (K − 1) / (K + 1), rad."""
        return between_limits(self.K)

    @property
    def size(self) -> float:
        """Twice the crank, or the frame."""
        length = self.AB or self.AC
        assert length is not None
        return 3 * length.si
