"""库茨巴赫线图: velocities of the pitch points over their radii, and the angular velocities beside each other."""

from __future__ import annotations

from ..words import Words
from .kind import View, register
from .mu import LENGTH, Mu
from .velocity import INK, SCALE

RADII = register(
    View(
        name="radii",
        order=52,
        title=Words("线速度图", "Linear-velocity diagram"),
        called=Words("线速度图", "the linear-velocity diagram"),
        mu=LENGTH,
        across=SCALE,
        ink=INK,
    )
)
TURNS = register(
    View(
        name="turns",
        order=54,
        title=Words("角速度图", "Angular-velocity diagram"),
        called=Words("角速度图", "the angular-velocity diagram"),
        mu=Mu(
            symbol="μ_{ω}",
            unit="rad/s",
            called=Words("角速度比例尺", "a scale of angular velocities"),
            listed=Words("角速度比例尺", "scale of angular velocities"),
            example="0.2 (rad/s)/mm",
        ),
        ink=INK,
    )
)
