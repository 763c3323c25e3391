"""机械特性曲线 M–ω, and what is summed up along it: the time of a run-up is the area under J/ΔM over ω."""

from __future__ import annotations

from ..words import Words
from .kind import View, register
from .mu import Mu
from .torque import INK, MOMENT
from .wheels import TURNS

CHARACTERISTIC = register(
    View(
        name="characteristic",
        order=76,
        title=Words("机械特性曲线 $M$–$ω$", "Mechanical characteristics $M$–$ω$"),
        called=Words("机械特性曲线", "the characteristics"),
        mu=MOMENT,
        across=TURNS.mu,
        ink=INK,
        wide=True,
    )
)
SPEED = register(
    View(
        name="speed",
        order=78,
        title=Words("转速曲线 $ω$–$t$", "Speed $ω$ over time $t$"),
        called=Words("转速曲线", "the curve of the speed"),
        mu=TURNS.mu,
        across=Mu(
            symbol="μ_t",
            unit="s",
            called=Words("时间比例尺", "a time scale"),
            listed=Words("时间比例尺", "scale of times"),
            example="0.1 s/mm",
        ),
        ink=INK,
        wide=True,
    )
)
INVERSE = register(
    View(
        name="inverse",
        order=77,
        title=Words("$y$ = $1/ΔM$ 线图 $y$–$ω$", "$y$ = $1/ΔM$ versus $ω$"),
        called=Words("$1/ΔM$ 线图", "the diagram of $1/ΔM$"),
        mu=Mu(
            symbol="μ_y",
            unit="1/(N·m)",
            called=Words("力矩倒数比例尺", "a scale of inverse moments"),
            listed=Words("力矩倒数比例尺", "scale of inverse moments"),
            example="0.0002 (1/(N*m))/mm",
        ),
        across=TURNS.mu,
        ink=INK,
        wide=True,
    )
)
