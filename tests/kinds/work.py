"""M–φ 图: the moment over the angle of a turn; an area is the work, μ_M μ_φ for a square millimetre."""

from __future__ import annotations

from vecpoly.figures.hue import Hue
from vecpoly.figures.kind import View, register
from vecpoly.figures.mu import Mu
from vecpoly.words import Words

WORK = register(
    View(
        name="work",
        order=60,
        title=Words("等效力矩图", "Moment over the angle"),
        called=Words("力矩图", "the diagram of moments"),
        mu=Mu(
            symbol="μ_M",
            unit="N·m",
            called=Words("力矩比例尺", "a moment scale"),
            listed=Words("力矩比例尺", "scale of moments"),
            example="5 N*m/mm",
        ),
        across=Mu(
            symbol="μ_{φ}",
            unit="rad",
            called=Words("转角比例尺", "an angle scale"),
            listed=Words("转角比例尺", "scale of angles"),
            example="0.05 rad/mm",
        ),
        ink=Hue("work", (0.36, 0.10, 0.42)),
        wide=True,
    )
)
