"""E–φ 图 and 能量指示图: the kinetic energy over the angle of a turn, and its rises and falls one above the other."""

from __future__ import annotations

from ..words import Words
from .displacement import TURNED
from .hue import Hue
from .kind import View, register
from .mu import Mu

INK = Hue("energy", (0.50, 0.20, 0.02))
WORK = Mu(
    symbol="μ_E",
    unit="J",
    called=Words("能量比例尺", "an energy scale"),
    listed=Words("能量比例尺", "scale of energies"),
    example="20 J/mm",
)

ENERGY = register(
    View(
        name="energy",
        order=72,
        title=Words("能量线图 $E$–$φ$", "Energy diagram $E$–$φ$"),
        called=Words("能量线图", "the diagram of the energy"),
        mu=WORK,
        across=TURNED,
        ink=INK,
        wide=True,
    )
)
INDICATOR = register(
    View(
        name="indicator",
        order=74,
        title=Words("能量指示图", "Energy-fluctuation diagram"),
        called=Words("能量指示图", "the energy-fluctuation diagram"),
        mu=WORK,
        ink=INK,
    )
)
