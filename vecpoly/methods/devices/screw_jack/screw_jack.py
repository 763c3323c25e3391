"""A screw jack: the thread unrolled is an inclined plane, its force polygon gives the moment;
the collar adds its own."""

from __future__ import annotations

from math import floor, isfinite, log10

import numpy as np

from ....algebra.formula import Node, Row, Txt, named
from ....algebra.quantity import FIGURES, Of, Quantity, Sum, Times, magnitude, number
from ....board.construction import View
from ....devices.screw_jack import (
    BACK,
    DRIVE,
    ETA,
    ETA_BACK,
    ETA_THREAD,
    LOAD,
    MOMENTS,
    RATIOS,
    SELF_LOCKING,
    ScrewJack,
)
from ....foundation.slotted import replace
from ....plane import Reals, nominal
from ....words import Words
from ..bench import NO_SCALE, Bench
from ..registry import device_method
from ..sketches.dimensions import millimetres
from ..sketches.screw_jack import collar_ring, nut_in_cone
from .thread import Thread, lean_symbol, nut_polygon, plain, unroll

_SOURCE = "机械原理, screw jack: square thread and ring-shaped collar"


@device_method(ScrewJack, title=Words("螺旋千斤顶", "Screw jack"), source=_SOURCE, example="5-5")
def draw_screw_jack(bench: Bench, device: ScrewJack) -> None:
    """M = M_1 + M_2, M_2 = F_t d_2 / 2 with F_t from the polygon of the nut on the unrolled thread; η = M_0 / M."""
    board = bench.board
    board.section(Words("螺纹中的摩擦力矩", "Moment of friction in the thread"))
    jack = unroll(bench, device)
    m2 = nut_polygon(bench, device, jack)
    board.section(Words("支承环面的摩擦力矩", "Moment of friction at the collar"))
    m1 = _collar(bench, device)
    board.section(Words("效率与载荷", "Efficiency and load"))
    m0 = _efficiency(bench, jack, m1, m2)
    _moments(bench, device, m1, m2, m0)
    board.section(Words("螺纹的自锁", "Self-locking of the thread"))
    _locked(bench, jack)
    _back(bench, jack, m1, m0)


def _collar(bench: Bench, device: ScrewJack) -> Quantity:
    """M_1/Q = f (D³ − d_0³) / 3 (D² − d_0²): an even pressure on a ring."""
    board, rub = bench.board, "f" if device.f else "f_c"
    ring = board.open_pane(View.MECHANISM, "collar", Words("支承环面", "Collar ring"))
    board.step(
        Words(
            "载荷均布在内径 $d_0$、外径 $D$ 的环面上，压强 $q = 4Q/[π(D^2 − d_0^2)]$；半径 $r$ 处宽 d$r$ 的圆环上的摩"
            f"擦力矩为 ${rub} q · 2π r^2$d$r$，自 $r = d_0/2$ 积分到 $D/2$ 即得 $M_1$。注意 $D$、$d_0$ 是直径，"
            "系数为 1/3（用半径时才是 2/3）：",
            "The load is uniformly distributed over the ring between the diameters $d_0$ and $D$, with "
            "the pressure $q = 4Q/[π(D^2 − d_0^2)]$; on a ring of radius $r$ and width d$r$ "
            f"friction has the moment ${rub} q · 2π r^2$d$r$; the integral from $r = d_0/2$ to "
            "$D/2$ is $M_1$. Since $D$ and $d_0$ are diameters, the factor is 1/3 (2/3 goes with radii):",
        ),
        ring,
    )
    outer, inner = millimetres("D", device.D.si), millimetres("d_0", device.d0.si)
    radii = [float(board.to_paper(ring, float(nominal(q.value)) / 2e3)) for q in (outer, inner)]
    collar_ring(bench, ring, *radii)
    f = magnitude(rub, device.collar.si, "")
    return bench.worked(RATIOS[0], f * (outer.cubed() - inner.cubed()) / Times(3, outer.squared() - inner.squared()))


def _efficiency(bench: Bench, jack: Thread, m1: Quantity, m2: Quantity) -> Quantity:
    """M = M_1 + M_2; M_0 = Q d_2 tan α / 2 would do without friction; η = M_0 / M."""
    bench.board.step(
        Words(
            "提升重物所需的总力矩 $M$ 和不计摩擦时的理想力矩 $M_0$ 为：",
            "The moment $M$ that lifts the load and the ideal moment $M_0$ without friction are:",
        )
    )
    whole = bench.worked(RATIOS[2], m1 + m2)
    m0 = bench.worked(RATIOS[3], jack.mean * Of("tan", jack.alpha) / plain(2))
    bench.board.step(
        Words(
            "千斤顶的效率等于理想力矩与实际力矩之比；只计螺纹时为 $η_s$：",
            "The efficiency is the ratio of the ideal to the actual moment; $η_s$ is that of the thread alone:",
        )
    )
    bench.worked(ETA, m0 / whole)
    bench.worked(ETA_THREAD, m0 / m2)
    return m0


def _moments(bench: Bench, device: ScrewJack, m1: Quantity, m2: Quantity, m0: Quantity) -> None:
    """F l = M: the load that a force lifts, or the force that a load needs; then the moments in N·m."""
    whole = Quantity(_bracketed(named("M/Q")), m1.value + m2.value, "mm")
    arm = millimetres("l", device.lever.si)
    if device.F:
        bench.board.step(
            Words(
                "由 $F l = M$ 求手柄上的力 $F$ 所能提升的载荷：",
                "Moments on the lever, $F l = M$, give the load that the force $F$ on the lever lifts:",
            )
        )
        load = bench.worked(LOAD, magnitude("F", device.F.si, "N") * arm / whole).value
    else:
        bench.board.step(Words("由 $F l = M$ 求手柄上的力：", "Moments on the lever, $F l = M$, give the force on it:"))
        load = device.trial
        bench.worked(DRIVE, magnitude("Q", load, "N") * whole / arm)
    in_kn = replace(magnitude("Q", load / 1e3, "kN"), told=_thousandth(load))
    bench.board.step(Words("各力矩的大小（$Q$ 以 kN 计）：", "The moments are ($Q$ in kN):"))
    for name, ratio in zip(MOMENTS, (m1, m2, whole, m0), strict=True):
        bench.worked(name, in_kn * (ratio if ratio is whole else Quantity(_bracketed(ratio.node), ratio.value, "mm")))


def _thousandth(load: Reals) -> str:
    """The load in kN with the figures that it has in N, in all lines; by a mistake it may come out below zero."""
    size = float(nominal(load))
    whole = floor(log10(abs(size))) + 1 if isfinite(size) and size else 0
    return number(size / 1e3, max(FIGURES, whole))


def _bracketed(node: Node) -> Node:
    return Row((Txt("("), node, Txt(")")))


def _locked(bench: Bench, jack: Thread) -> None:
    """Under the load alone the reaction stands against it, at α from the normal: the thread locks where α ≤ φ."""
    board, name = bench.board, lean_symbol(jack.phi)
    place = board.open_pane(View.BODY, "cone", Words("去掉 $F$ 后螺母的受力", "The nut with $F$ removed"), NO_SCALE)
    board.step(
        Words(
            "去掉 $F$ 后（不计环面摩擦），螺母只受 $Q$ 和螺纹的总反力 $R$，静止时二力共线，$R$ 竖直，"
            f"与法线 $n$ 的夹角等于 $α$；$α ≤ {name}$ 时 $R$ 在摩擦锥内，无论 $Q$ 多大螺母都不会自行松退。",
            "With $F$ removed, and leaving aside the friction of the collar, only $Q$ and the "
            "total reaction $R$ of the thread act on the nut. At rest they are collinear: $R$ is "
            f"vertical and makes the angle $α$ with the normal $n$. Where $α ≤ {name}$ it lies "
            "within the friction cone, and the nut does not turn back however large $Q$ is.",
        ),
        place,
    )
    nut_in_cone(bench, place, jack.along, jack.phi.value, name)
    alpha, phi = jack.alpha, jack.phi
    steep, lean = (number(float(nominal(q.value))) for q in (alpha, phi))
    locks = np.asarray(alpha.value <= phi.value * (1 + 1e-12))
    sign, zh, en = (
        ("≤", "螺纹自锁", "the thread is self-locking")
        if bool(nominal(locks))
        else (">", "螺纹不自锁", "the thread is not self-locking")
    )
    bench.judged(
        SELF_LOCKING,
        locks,
        Words(
            f"$α$ = {steep}° {sign} ${name}$ = {lean}°，{zh}。",
            f" Here $α$ = {steep}° {sign} ${name}$ = {lean}°: {en}.",
        ),
        alpha.value,
        phi.value,
    )


def _back(bench: Bench, jack: Thread, m1: Quantity, m0: Quantity) -> None:
    """M' = M_1 + Q d_2 tan(φ − α) / 2 lowers the load."""
    bench.board.step(
        Words(
            "放下重物时各摩擦力矩反向，所需的力矩为 $M′$（以放下的转向为正；为负时重物自行下降，须制动）；"
            "以载荷为驱动力时的效率 $η′ = −M′/M_0$，$η′ ≤ 0$ 时载荷不能自行下降：",
            "Lowering the load reverses all friction; it takes the moment $M′$, positive in the "
            "sense of lowering (negative: the load runs down and must be braked). "
            "With the load driving, the efficiency is $η′ = −M′/M_0$; "
            "where $η′ ≤ 0$ the load does not sink by itself:",
        )
    )
    back = bench.worked(BACK, m1 + jack.mean * Of("tan", jack.phi - jack.alpha) / plain(2))
    bench.worked(ETA_BACK, Sum((back / m0,), (-1,)))
