"""J_e–φ 图 and 能量–质量图: the equivalent inertia over the angle of a turn, and the energy over that inertia."""

from __future__ import annotations

from ..words import Words
from .displacement import TURNED
from .energy import WORK
from .hue import Hue
from .kind import View, register
from .mu import Mu

INK = Hue("inertia", (0.05, 0.36, 0.28))
MASS = Mu(
    symbol="μ_J",
    unit="kg·m^2",
    called=Words("转动惯量比例尺", "a scale of inertias"),
    listed=Words("转动惯量比例尺", "scale of moments of inertia"),
    example="0.05 kg*m^2/mm",
)

INERTIA = register(
    View(
        name="inertia",
        order=71,
        title=Words("等效转动惯量线图 $J_e$–$φ$", "Equivalent moment of inertia $J_e$–$φ$"),
        called=Words("等效转动惯量线图", "the diagram of the inertia"),
        mu=MASS,
        across=TURNED,
        ink=INK,
        wide=True,
    )
)
WITTENBAUER = register(
    View(
        name="energy-mass",
        order=73,
        title=Words("能量–质量图 $E$–$J_e$", "Energy over inertia, $E$–$J_e$ (Wittenbauer)"),
        called=Words("能量–质量图", "the diagram of energy over inertia"),
        mu=WORK,
        across=MASS,
        ink=INK,
        wide=True,
    )
)
