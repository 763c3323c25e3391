"""加速度多边形: the acceleration polygon."""

from __future__ import annotations

from ..words import Words
from .hue import Hue
from .kind import View, register
from .mu import Mu

View.ACCELERATION = register(
    View(
        name="acceleration",
        order=30,
        title=Words("加速度多边形", "Acceleration polygon"),
        called=Words("加速度多边形", "the acceleration polygon"),
        mu=Mu(
            symbol="μ_a",
            unit="m/s^2",
            called=Words("加速度比例尺", "an acceleration scale"),
            listed=Words("加速度比例尺", "scale of accelerations"),
            example="0.1 (m/s^2)/mm",
        ),
        ink=Hue("acceleration", (0.55, 0.05, 0.09)),
        tint=Hue("acceleration_tint", (0.98, 0.90, 0.89), is_tint=True),
        images=True,
        letters=("$p′$、$b′$、$c′$…", Words("加速度多边形的极点、各点的影像", "pole, images of points (acceleration)")),
    )
)
