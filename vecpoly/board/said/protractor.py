"""An angle as it is told: to the tenth of the protractor where it was read off that, 40.0°; else as it was computed."""

from __future__ import annotations

from collections.abc import Sequence

from ...algebra.quantity import number
from ...algebra.rounding import in_tenths
from ...plane import Reals, nominal
from ...plane.traced import acts_of
from ..acts import Act, Gauge


def degrees_told(acts: Sequence[Act], value: Reals) -> str:
    """The angle (deg) without its unit; acts: those of the sheet."""
    read = any(n < len(acts) and isinstance(acts[n], Gauge) for n in acts_of(value))
    size = float(nominal(value))
    return in_tenths(size + 0.0).replace("-", "−") if read else number(size)
