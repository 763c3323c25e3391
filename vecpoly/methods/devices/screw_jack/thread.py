"""The thread of a screw jack: unrolled it is an inclined plane, and the force polygon of the nut on it gives M_2."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees, pi

import numpy as np

from ....algebra.formula import Node, Row, Txt, named
from ....algebra.quantity import Of, Quantity, Times, magnitude
from ....algebra.worked import keyed_in, stated, worked
from ....board.construction import View
from ....devices.screw_jack import ALPHA, PHI, PHI_V, RATIOS, TAN_ALPHA, ScrewJack
from ....names import Named
from ....plane import Points, nominal
from ....words import Words
from ..bench import NO_SCALE, Bench
from ..equilibrium import OFF_N, balance, given, letter, sought
from ..inclined import friction_angle, leaned
from ..sketches.dimensions import millimetres
from ..sketches.screw_jack import nut_apart, unrolled


@dataclass(slots=True, kw_only=True)
class Thread:
    """What has been found so far: lengths in mm, angles in degrees; the direction of the slope as drawn."""

    mean: Quantity
    alpha: Quantity
    phi: Quantity
    along: Points


def plain(count: int) -> Quantity:
    """A plain number as a factor of formulas."""
    return Quantity(Txt(str(count)), float(count), "")


def unroll(bench: Bench, device: ScrewJack) -> Thread:
    """Mean diameter, lead, lead angle, friction angle; the thread unrolled."""
    board = bench.board
    sketch = board.open_pane(View.MECHANISM, "thread", Words("螺纹沿中径展开", "Thread unrolled at its mean diameter"))
    board.step(
        Words(
            "将螺纹沿中径 $d_2$ 展开成斜面，其倾角即螺纹升角 $α$，螺母相当于斜面上的滑块：",
            "Unrolled at its mean diameter $d_2$ the thread is an inclined plane whose slope is "
            "the lead angle $α$, and the nut a block on it:",
        ),
        sketch,
    )
    mean = board.compute("d_2", (millimetres("d", device.d.si) + millimetres("d_1", device.d1.si)) / plain(2), "mm")
    pitch = millimetres("p", device.p.si)
    lead = board.compute("L", Times(device.starts, pitch), "mm") if device.starts > 1 else pitch
    tan = bench.worked(TAN_ALPHA, lead / (Quantity(Txt("π"), pi, "") * mean))
    steep = np.degrees(np.arctan(tan.value))
    alpha = bench.stated(ALPHA, steep, _arctan(named("α"), magnitude(TAN_ALPHA.symbol, tan.value, "")))
    along = unrolled(
        bench, sketch, float(nominal(mean.value)), float(nominal(lead.value)), "p" if device.starts == 1 else "L"
    )
    return Thread(mean=mean, alpha=alpha, phi=_friction(bench, device), along=along)


def _friction(bench: Bench, device: ScrewJack) -> Quantity:
    """The friction angle of the thread; of a V-thread with the equivalent coefficient f_v."""
    board = bench.board
    if device.beta is None:
        board.step(Words("螺纹副的摩擦角：", "The friction angle of the thread is:"))
        return friction_angle(bench, PHI, device.thread, "f" if device.f else "f_s")
    board.step(
        Words(
            "三角螺纹的牙侧面倾斜 $β$，同样的载荷产生更大的法向反力，以当量摩擦系数 $f_v$ 代替 $f$，"
            "相应的当量摩擦角为 $φ_v$：",
            "The flanks of the V-thread are inclined by $β$ and the same load gives larger normal "
            "reactions: an equivalent coefficient $f_v$ replaces $f$, with the friction angle "
            "$φ_v$:",
        )
    )
    f = magnitude("f" if device.f else "f_s", device.thread.si, "")
    wedge = board.compute("f_v", f / Of("cos", magnitude("β", degrees(device.beta.si), "deg")), "")
    lean = float(np.degrees(np.arctan(wedge.value)))
    return bench.stated(PHI_V, lean, worked(named(PHI_V.symbol), Of("arctan", wedge), "deg"))


def _arctan(name: Node, of: Quantity) -> Row:
    """α = arctan 0.0512 = 2.93°: the tangent was found in the line before."""
    angle = Of("arctan", of)
    return Row((name, Txt(" = "), keyed_in(angle), stated(Quantity(name, angle.value, "deg")).items[-1]), angle)


def nut_polygon(bench: Bench, device: ScrewJack, jack: Thread) -> Quantity:
    """The nut on the slope: Q + F_t + R = 0; M_2/Q = F_t d_2 / 2Q."""
    board, phi = bench.board, lean_symbol(jack.phi)
    apart = board.open_pane(View.BODY, "nut", Words("螺母受力图（上升）", "Free body of the nut, going up"), NO_SCALE)
    plan = board.open_pane(View.FORCE, "thread", Words("螺母的力多边形", "Force polygon of the nut"))
    load, push, press_on = _forces(bench, device)
    board.step(_taken(phi, load.symbol, push.symbol, press_on.symbol), plan)
    lean = leaned(1j * jack.along, jack.along, jack.phi.value)
    nut_apart(bench, apart, jack.along, lean, phi, (load.symbol, push.symbol, press_on.symbol))
    inclined = OFF_N if phi == "φ" else Words("与 $n$ 成 $φ_v$", "$φ_v$ from $n$")
    weight, drive = given(bench, plan, load, device.trial, -1j), sought(push, 1 + 0j, Words("水平", "horizontal"))
    closed = balance(bench, plan, 0j, weight, drive, sought(press_on, lean, inclined))
    ends = closed.ends[push.key]
    letter(bench, plan, {"a": closed.ends[load.key][0], "b": ends[0], "c": ends[1]})
    reading = board.measure(*ends, "b c")
    measured = board.compute(push.symbol, board.mu(plan) * reading, "N")
    m2 = bench.worked(RATIOS[1], measured * jack.mean / Times(2, magnitude(load.symbol, device.trial, "N")))
    bench.read_off(RATIOS[1], plan, reading, "b c", factor=f"d_2/(2{load.symbol}) ·")
    board.compute(RATIOS[1].symbol, jack.mean * Of("tan", jack.alpha + jack.phi) / plain(2), "mm")
    return m2


def _forces(bench: Bench, device: ScrewJack) -> tuple[Named, Named, Named]:
    """Q, F_t and R; where Q is sought, those of the round load for which the polygon is drawn, which is told."""
    if device.Q is not None:
        return Named("Q", "Q", "N"), Named("F_t", "F_t", "N"), Named("R", "R", "N")
    bench.board.step(
        Words(
            f"各力均与载荷成正比，载荷待求，故先取 $Q_1$ = {device.trial:g} N 作图。",
            f"The load is sought, and all forces are proportional to it: draw for the load $Q_1$ = {device.trial:g} N.",
        )
    )
    return Named("Q_1", "Q_1", "N"), Named("F_t1", "F_{t1}", "N"), Named("R_1", "R_1", "N")


def _taken(phi: str, load: str, push: str, press_on: str) -> Words:
    """The nut taken as a free body: symbols of the friction angle and of the three forces."""
    return Words(
        f"取螺母为分离体，受轴向载荷 ${load}$、中径处的圆周力 ${push}$ 和螺纹的总反力 "
        f"${press_on}$。螺母沿斜面上升，${press_on}$ 自法线 $n$ 逆滑动方向偏转 ${phi}$。"
        f"按 $μ_F$ 作力多边形：$ab$ 代表 ${load}$，过 $b$ 作水平线，过 $a$ 作 ${press_on}$ "
        f"的方向线，交于 $c$。由 ${push} = {load} tan(α + {phi})$ 可用公式核对。",
        f"On the nut act the axial load ${load}$, the tangential force ${push}$ "
        f"at the mean diameter and the total reaction ${press_on}$ of the thread. The "
        f"nut moves up the slope, so ${press_on}$ is turned from the normal $n$ by "
        f"${phi}$ against the sliding. Draw the force polygon to the scale $μ_F$: $ab$ stands "
        f"for ${load}$; a horizontal line through $b$ and the direction of "
        f"${press_on}$ through $a$ meet at $c$. The formula ${push} = {load} tan(α + "
        f"{phi})$ serves as a check.",
    )


def lean_symbol(phi: Quantity) -> str:
    """φ, or φ_v of a V-thread."""
    return "φ" if phi.node == named("φ") else "φ_v"
