"""位移线图: how far a cam's follower has moved, over the angle of the cam; and the loop of s over ds/dφ."""

from __future__ import annotations

from ..foundation.slotted import replace
from ..words import Words
from .hue import Hue
from .kind import View, register
from .mu import Mu

INK = Hue("displacement", (0.30, 0.16, 0.02))
STROKE = Mu(
    symbol="μ_s",
    unit="m",
    called=Words("位移比例尺", "a displacement scale"),
    listed=Words("位移比例尺", "scale of displacements"),
    example="0.001 m/mm",
)
SWING = Mu(
    symbol="μ_{ψ}",
    unit="rad",
    called=Words("摆角比例尺", "a scale of swings"),
    listed=Words("摆角比例尺", "scale of swings"),
    example="0.6 deg/mm",
    degrees=True,
)
TURNED = Mu(
    symbol="μ_{φ}",
    unit="rad",
    called=Words("转角比例尺", "an angle scale"),
    listed=Words("转角比例尺", "scale of angles"),
    example="0.04 rad/mm",
)
DIVIDED = replace(TURNED, example="2.5 deg/mm", degrees=True)

DISPLACEMENT = register(
    View(
        name="displacement",
        order=5,
        title=Words("位移线图 $s$–$φ$", "Displacement diagram $s$–$φ$"),
        called=Words("位移线图", "the displacement diagram"),
        mu=STROKE,
        across=DIVIDED,
        ink=INK,
        wide=True,
    )
)
ANGULAR = register(
    View(
        name="swing",
        order=6,
        title=Words("角位移线图 $ψ$–$φ$", "Angular displacement diagram $ψ$–$φ$"),
        called=Words("角位移线图", "the diagram of swings"),
        mu=SWING,
        across=DIVIDED,
        ink=INK,
        wide=True,
    )
)
LOOP = register(
    View(
        name="loop",
        order=7,
        title=Words("$s$–d$s$/d$φ$ 线图", "$s$ over d$s$/d$φ$"),
        called=Words("$s$–d$s$/d$φ$ 线图", "the diagram of $s$ over d$s$/d$φ$"),
        mu=STROKE,
        ink=INK,
    )
)
