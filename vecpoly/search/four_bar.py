"""Parameters that all searches over four-bars share: b, c, d of AB = 1, the side of C, the coupler point E."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..foundation.slotted import dataclass
from ..oracle.families import FourBars

Reals = NDArray[np.float64]
LOW = (1.02, 1.02, 0.3, -1.0, -1.0, -2.0)
HIGH = (6.0, 6.0, 6.0, 1.0, 2.0, 2.0)
LEAST = np.radians(20.0)  # of γ_min: below, a linkage is of no use
SIZES = 4  # significant digits of the lengths that are written


def family(x: Reals) -> FourBars:
    """The four-bars of these candidates."""
    return FourBars(b=x[:, 0], c=x[:, 1], d=x[:, 2], side=np.where(x[:, 3] < 0, -1.0, 1.0))


def sound(x: Reals, least: float) -> NDArray[np.bool_]:
    """Whether the crank turns right round with this transmission angle at least."""
    bars = family(x)
    good: NDArray[np.bool_] = bars.turn & (bars.least_angle >= max(least, LEAST))
    return good


def coupler(x: Reals, crank: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """The coupler point E = B + (u + iv) b · BC/|BC| along the cranks' directions."""
    b_pin, along = family(x).points(crank)
    return b_pin + along * ((x[:, 4] + 1j * x[:, 5]) * x[:, 0])[:, None]


def longest(x: Reals) -> Reals:
    """The longest side of any of the links and of the frame: AB = 1, BC, CD, AD, and BE, CE of the coupler."""
    spot = x[:, 4] + 1j * x[:, 5]
    sides: Reals = np.maximum(np.abs(spot), np.abs(spot - 1.0)) * x[:, 0]
    longest_side: Reals = np.maximum(np.maximum(x[:, :3].max(axis=1), sides), 1.0)
    return longest_side


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """A four-bar with its coupler point as a problem file says it; `scale`: what AB = 1 and the x axis become (m)."""

    x: Reals
    at: complex
    scale: complex

    def place(self, z: complex) -> list[str]:
        """A point of the plane of the family, as coordinates."""
        spot = 1e3 * (self.at + self.scale * z)
        return [f"{spot.real:.3f} mm", f"{spot.imag:.3f} mm"]

    def length(self, size: float) -> str:
        """A length of the family."""
        return f"{1e3 * abs(self.scale) * size:.3f} mm"

    def four_bar(self) -> dict[str, Any]:
        """Frame, links 1 to 3 with E on the coupler, the branch."""
        b, c, d, _, u, v = (float(one) for one in self.x[:6])
        side = "left" if self.x[3] >= 0 else "right"
        spot = {"along": "BC", "at": self.length(u * b)} | {"left": self.length(v * b)}
        return {
            "frame": {"A": self.place(0j), "D": self.place(complex(d))},
            "links": {
                "1": {"AB": self.length(1.0)},
                "2": {"BC": self.length(b), "E": spot},
                "3": {"CD": self.length(c)},
            },
            "branch": [f"C {side} of BD"],
        }
