"""The rim of a flywheel: its mass, its section, its speed."""

from __future__ import annotations

from ....algebra.formula import Txt
from ....algebra.quantity import Quantity, Rooted, magnitude, number
from ....devices.dynamics import asked
from ....devices.dynamics.rim import Rim
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from ..speeds import PI
from .inertia import FOUR

HALF = Quantity(Txt("0.5"), 0.5, "")


def rim_of(bench: Bench, rim: Rim, inertia: Quantity, omega: Quantity) -> None:
    """m = 4 J_F / D²; of its section b h = m / (π D ρ); the speed of its outside; the annulus as it really is."""
    board = bench.board
    board.section(Words("轮缘", "Rim"))
    board.step(Words("设轮缘质量集中在平均直径 $D$ 上：", "Let the mass of the rim lie on its mean diameter $D$:"))
    d = magnitude("D", rim.D.si, "m")
    mass = bench.worked(asked.RIM_MASS, FOUR * inertia / d.squared())
    section = board.compute("S", mass / (PI * d * magnitude("ρ", rim.density.si, "kg/m^3")), "m^2")
    ratio = magnitude("(b/h)", rim.ratio.si, "")
    h = bench.worked(asked.RIM_H, Rooted(section / ratio))
    bench.worked(asked.RIM_B, ratio * h)
    _speed(bench, rim, h, omega)
    board.step(
        Words(
            "按真实的圆环校核转动惯量（内半径 $R_1 = (D − h)/2$，外半径 $R_2$）：",
            "Check the moment of inertia of the actual annulus, with the inner radius $R_1 = (D − h)/2$ and the outer "
            "radius $R_2$:",
        )
    )
    inner, outer = (magnitude(f"R_{n}", rim.D.si / 2 + sign * h.value / 2, "m") for n, sign in ((1, -1), (2, 1)))
    bench.worked(asked.RIM_J, HALF * mass * (inner.squared() + outer.squared()))


def _speed(bench: Bench, rim: Rim, h: Quantity, omega: Quantity) -> None:
    board = bench.board
    board.step(
        Words(
            "求轮缘外圆（半径 $R_2 = (D + h)/2$）的线速度：",
            "Find the speed of the outside of the rim, of radius $R_2 = (D + h)/2$:",
        )
    )
    outer = magnitude("R_2", rim.D.si / 2 + h.value / 2, "m")
    v = bench.worked(asked.RIM_SPEED, omega * outer)
    if rim.v_max is not None:
        safe = v.value <= rim.v_max.si
        most = number(rim.v_max.si)
        zh, en = ("不超过", "does not exceed") if bool(nominal(safe)) else ("超过", "exceeds")
        told = Words(f"{zh}许用值 {most} m/s。", f" It {en} the allowed {most} m/s.")
        bench.judged(asked.RIM_SAFE, safe, told, v.value)
