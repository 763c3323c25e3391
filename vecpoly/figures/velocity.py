"""速度多边形: the velocity polygon."""

from __future__ import annotations

from ..words import Words
from .hue import Hue
from .kind import View, register
from .mu import Mu

INK = Hue("velocity", (0.03, 0.17, 0.50))
SCALE = Mu(
    symbol="μ_v",
    unit="m/s",
    called=Words("速度比例尺", "a velocity scale"),
    listed=Words("速度比例尺", "scale of velocities"),
    example="0.01 (m/s)/mm",
)

View.VELOCITY = register(
    View(
        name="velocity",
        order=20,
        title=Words("速度多边形", "Velocity polygon"),
        called=Words("速度多边形", "the velocity polygon"),
        mu=SCALE,
        ink=INK,
        tint=Hue("velocity_tint", (0.88, 0.92, 0.98), is_tint=True),
        images=True,
        letters=("$p$、$b$、$c$…", Words("速度多边形的极点、各点的影像", "pole, images of points (velocity)")),
    )
)
