"""What a millimetre on paper stands for, before a sheet says how much of it."""

from __future__ import annotations

from ..foundation.slotted import dataclass
from ..words import Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Mu:
    """A scale without its value. symbol: ``μ_v``, ``μ_{φ}``; unit: of the quantity that is drawn, ``m/s``.

    example: as one writes it; called: 速度比例尺, a velocity scale; listed: in a list of symbols. typed: how a problem
    file writes it, where another scale has the same symbol. degrees: an angle that is told in °/mm, as an axis that is
    numbered in degrees is divided; one that is multiplied by is told in rad/mm.
    """

    symbol: str
    unit: str
    called: Words
    listed: Words
    example: str
    typed: str = ""
    degrees: bool = False

    @property
    def key(self) -> str:
        """How a problem file and a reader at a keyboard write it: ``mu_v``, ``mu_phi``."""
        return self.typed or self.symbol.translate(_ASCII)


_ASCII = str.maketrans(
    {"μ": "mu", "φ": "phi", "ψ": "psi", "θ": "theta", "ω": "omega", "α": "alpha", "{": None, "}": None}
)
LENGTH = Mu(
    symbol="μ_l",
    unit="m",
    called=Words("长度比例尺", "a length scale"),
    listed=Words("长度比例尺", "scale of lengths"),
    example="0.002 m/mm",
)
