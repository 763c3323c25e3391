"""力多边形: the force polygon, beside the free body of its name."""

from __future__ import annotations

from ..words import Words
from .body import INK
from .hue import Hue
from .kind import View, register
from .mu import Mu

View.FORCE = register(
    View(
        name="force",
        order=50,
        title=Words("力多边形", "Force polygon"),
        called=Words("力多边形", "the force polygons"),
        mu=Mu(
            symbol="μ_F",
            unit="N",
            called=Words("力比例尺", "a force scale"),
            listed=Words("力比例尺", "scale of forces"),
            example="10 N/mm",
        ),
        ink=INK,
        tint=Hue("force_tint", (0.88, 0.95, 0.91), is_tint=True),
        beside=View.BODY,
    )
)
