"""A clamping wedge, self-locking shown three ways:
two opposite reactions, the force that holds, the efficiency of slipping out."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Of, Quantity, Times
from ....board.construction import View
from ....devices.wedge_clamp import ETA_BACK, IDEAL, PHI, WedgeClamp
from ....plane import Points
from ....words import Words
from ..bench import Bench
from ..inclined import angle, between, body, friction_angle, numbered, pull, ray
from ..registry import device_method
from .by_force import by_force, wedge_polygon
from .by_geometry import by_geometry
from .shape import DEEP, LENGTH, corners


@device_method(
    WedgeClamp,
    title=Words("楔块夹具的自锁", "Self-locking of a wedge clamp"),
    source="机械原理, self-locking: by geometry of reactions, by force, by efficiency",
    example="5-2",
)
def draw_clamp(bench: Bench, device: WedgeClamp) -> None:
    """Sketch, friction angle, then the three ways."""
    board, slope = bench.board, np.exp(-1j * device.alpha.si)
    board.section(Words("简图与摩擦角", "Sketch and friction angle"))
    board.step(
        Words(
            "画出简图（长度不按比例）：楔块 3 在力 $F$ 作用下楔入工件 1 与构件 2 之间，夹紧后去掉 $F$，"
            "楔块可能向左退出。",
            "Sketch, lengths not to scale: $F$ drives wedge 3 in between workpiece 1 and body 2. "
            "After clamping $F$ is removed, and the wedge may slip out to the left.",
        ),
        View.MECHANISM,
    )
    _sketch(bench, slope)
    board.step(Words("求摩擦角：", "The friction angle is:"))
    phi = friction_angle(bench, PHI, device.f)
    by_geometry(bench, device, slope, phi)
    _by_efficiency(bench, device, slope, by_force(bench, device, slope, phi), phi)


def _sketch(bench: Bench, slope: Points) -> None:
    view, it = View.MECHANISM, corners(slope)
    body(bench, view, "link 3", *it)
    body(bench, view, "link 1", -6 + 0j, LENGTH + 6, complex(LENGTH + 6, -DEEP), complex(-6, -DEEP), fixed=True)
    above, low = it[3] + slope * 4, it[2] - slope * 4
    over = above + DEEP * 1j
    body(bench, view, "link 2", above, low, complex(low.real, over.imag), over)
    pull(bench, view, it[3] / 2, 1 + 0j, "F")
    ray(bench, view, it[2], 1 + 0j, 22.0)
    ray(bench, view, it[2], slope, 22.0)
    between(bench, view, it[2], 1 + 0j, slope, 16.0, "α")
    places = ((LENGTH + 9 - 1j * (DEEP / 2), "1"), ((above + low) / 2 + 3 + DEEP * 0.62j, "2"), (sum(it) / 4, "3"))
    numbered(bench, view, *places)


def _by_efficiency(bench: Bench, device: WedgeClamp, slope: Points, hold: Quantity, phi: Quantity) -> None:
    board = bench.board
    board.section(Words("方法三：由效率", "Method 3: the efficiency"))
    lead = Words(
        "设各面无摩擦，两反力都沿法线，求同一 $R_23$ 下的理想阻力 $F'_0$。",
        "Without friction both reactions lie along the normals; find the ideal resistance $F'_0$ for the same $R_23$. ",
    )
    place, _, c = wedge_polygon(bench, device, IDEAL, (-1j * slope, 1j), lead)
    board.step(
        Words(
            "楔块退出时 $R_23$ 为驱动力，$F'$ 为阻力，效率等于实际阻力与理想阻力之比。三角形 $abc_0$ 中 $F'_0 = "
            "R_23 sin α$，故 $η'$ 也可用公式核对；$η' ≤ 0$ 时自锁，仍得 $α ≤ 2φ$。",
            "While the wedge slips out $R_23$ drives and $F'$ resists; the efficiency is the "
            "ratio of the actual to the ideal resistance. In the triangle $abc_0$ $F'_0 = R_23 "
            "sin α$, which gives a formula for $η'$; $η' ≤ 0$ means self-locking: once more $α ≤ "
            "2φ$.",
        ),
        place,
    )
    ideal = bench.measured(IDEAL, place, c, 0j, "c_0 a")
    bench.worked(ETA_BACK, hold / ideal)
    alpha = angle("α", device.alpha.si)
    board.compute("η'", Of("sin", alpha - Times(2, phi)) / (Of("cos", phi) * Of("sin", alpha)), "")
