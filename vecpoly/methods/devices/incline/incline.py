"""A block on an inclined plane: up, down and without friction on one polygon; self-locking as geometry and as η' ≤
0."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity
from ....board.construction import View
from ....devices.incline import PHI, REACTION, Incline
from ....plane import Points
from ....words import Words
from ..bench import Bench
from ..inclined import Press, angle, body, concur, friction_angle, leaned, press, pull
from ..registry import device_method
from .limit import limit_slope
from .polygon import Slope, draw_polygon
from .sketch import HIGH, block_on, draw_drive, sketch


@device_method(
    Incline,
    title=Words("斜面上滑块的力分析", "Forces on a block on an inclined plane"),
    source="机械原理, friction on an inclined plane: total reaction, friction cone, self-locking",
    example="5-1",
)
def draw_incline(bench: Bench, device: Incline) -> None:
    """Sketch, friction angle, limit slope, the block apart, up, without friction, down."""
    board = bench.board
    board.section(Words("简图与摩擦角", "Sketch and friction angle"))
    board.step(
        Words(
            "画出简图（长度不按比例）：滑块 1 在斜面 2 上，受重力 $Q$ 和与水平成 $β$ 角的力 $F$。求摩擦角：",
            "Sketch, lengths not to scale: block 1 on the plane 2 under its weight $Q$ and the "
            "force $F$ at $β$ to the horizontal. The friction angle is:",
        ),
        View.MECHANISM,
    )
    phi = friction_angle(bench, PHI, device.f)
    alpha = angle("α", device.alpha.si) if device.alpha else Quantity(sym("α"), phi.value, "deg")
    along, force = np.exp(1j * np.radians(alpha.value)), np.exp(1j * device.beta.si)
    sketch(bench, along, force)
    limit_slope(bench, phi)
    _apart(bench, along, force, phi, device.alpha is None)
    draw_polygon(bench, device, Slope(alpha=alpha, phi=phi, along=along, force=force))


def _apart(bench: Bench, along: Points, force: Points, phi: Quantity, limit: bool) -> None:
    board = bench.board
    at = "，$α = φ$" if limit else "", ", $α = φ$" if limit else ""
    board.section(Words(f"正行程与反行程{at[0]}", f"Driving up and sliding down{at[1]}"))
    place = board.open_pane(View.BODY, "up", Words("滑块受力图（正行程）", "Free body of the block, driven up"))
    board.step(
        Words(
            "取滑块为分离体。滑块相对斜面的速度 $v_12$ 沿斜面向上，摩擦力沿斜面向下，故 $R_21$ 自法线 $n$ 向下滑一"
            "侧偏转 $φ$，与 $v_12$ 成 $90° + φ$。$Q$ 已知，$F$、$R_21$ 方向已知，只有两个未知的大小；"
            "三力汇交于一点。",
            "Take the block as a free body. It slides up the plane ($v_12$), so friction acts "
            "down the plane and $R_21$ is turned from the normal $n$ by $φ$ down the slope: it "
            "makes $90° + φ$ with $v_12$. The load $Q$ is known, $F$ and $R_21$ in direction, so that two "
            "magnitudes are unknown; the three forces are concurrent.",
        ),
        place,
    )
    normal = 1j * along
    reaction = leaned(normal, along, phi.value)
    body(bench, place, "link 1", *block_on(along, 0j))
    middle = 0.5 * HIGH * normal
    foot = middle - reaction * (0.5 * HIGH / (reaction * np.conj(normal)).real)
    press(
        bench,
        place,
        Press(symbol=REACTION.symbol, at=foot, normal=normal, along=reaction, slides=along, speed="v_{12}"),
    )
    top = middle + 1j * (0.5 * HIGH / normal.imag)
    draw_drive(bench, place, middle, along, force)
    pull(bench, place, top, -1j, "Q")
    concur(bench, place, middle, foot, top)
