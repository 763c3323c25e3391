"""M–φ 图: moments over the angle of a turn; an area is a work, μ_M μ_φ for a square millimetre (φ in radians)."""

from __future__ import annotations

from ..words import Words
from .displacement import TURNED
from .hue import Hue
from .kind import View, register
from .mu import Mu

INK = Hue("torque", (0.36, 0.10, 0.42))
MOMENT = Mu(
    symbol="μ_M",
    unit="N·m",
    called=Words("力矩比例尺", "a moment scale"),
    listed=Words("力矩比例尺", "scale of moments"),
    example="5 N*m/mm",
)

TORQUE = register(
    View(
        name="torque",
        order=70,
        title=Words("力矩线图 $M$–$φ$", "Moment diagram $M$–$φ$"),
        called=Words("力矩线图", "the diagram of moments"),
        mu=MOMENT,
        across=TURNED,
        ink=INK,
        wide=True,
    )
)
