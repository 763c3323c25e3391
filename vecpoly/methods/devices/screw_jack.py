"""A screw jack: the thread unrolled is an inclined plane, its force polygon gives the moment; the collar adds its own."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees, pi

import numpy as np

from ...board.construction import Pane, View
from ...board.marks import AngleMark, Arc, Note, Role, Segment
from ...devices.base import Length
from ...devices.screw_jack import (
    ALPHA,
    BACK,
    DRIVE,
    ETA,
    ETA_BACK,
    ETA_THREAD,
    LOAD,
    MOMENTS,
    PHI,
    PHI_V,
    RATIOS,
    SELF_LOCKING,
    TAN_ALPHA,
    ScrewJack,
)
from ...formula import Node, Row, Txt, named
from ...names import Named
from ...plane import Points, nominal, unit
from ...quantity import Of, Quantity, Sum, Times, magnitude, number
from ...words import Words
from .bench import Bench
from .dimensions import dimension
from .inclined import Press, balance, body, friction_angle, given, leaned, letter, press, pull, row_of, sought
from .registry import device_method

_SOURCE = "机械原理, screw jack: square thread and ring-shaped collar"


NUT = 10.0  # mm: half the length of the nut as sketched


@dataclass(slots=True, kw_only=True)
class _Jack:
    """What has been found so far; lengths in mm, angles in degrees."""

    mean: Quantity
    lead: Quantity
    alpha: Quantity
    phi: Quantity


@device_method(ScrewJack, title=Words("螺旋千斤顶", "Screw jack"), source=_SOURCE, example="5-5")
def draw_screw_jack(bench: Bench, device: ScrewJack) -> None:
    """M = M_1 + M_2, M_2 = F_t d_2 / 2 with F_t from the polygon of the nut on the unrolled thread; η = M_0 / M."""
    board = bench.board
    board.section(Words("螺纹中的摩擦", "Friction in the thread"))
    jack = _thread(bench, device)
    m2 = _polygon(bench, device, jack)
    board.section(Words("支承环面的摩擦与效率", "Friction of the collar, and efficiency"))
    m1 = _collar(bench, device)
    m0 = _efficiency(bench, jack, m1, m2)
    _moments(bench, device, m1, m2, m0)
    _back(bench, jack, m1, m0)


def _mm(symbol: str, written: Length) -> Quantity:
    return magnitude(symbol, written.si * 1e3, "mm")


def _pure(count: int) -> Quantity:
    return Quantity(Txt(str(count)), float(count), "")


def _thread(bench: Bench, device: ScrewJack) -> _Jack:
    """Mean diameter, lead, lead angle, friction angle."""
    board = bench.board
    board.step(Words("将螺纹沿中径 $d_2$ 展开成斜面，斜面的升角即螺纹升角 $α$：", "Unroll the thread at its mean diameter $d_2$ into an inclined plane; its slope is the lead angle $α$:"))
    mean = board.compute("d_2", (_mm("d", device.d) + _mm("d_1", device.d1)) / _pure(2), "mm")
    pitch = _mm("p", device.p)
    lead = board.compute("L", Times(device.starts, pitch), "mm") if device.starts > 1 else pitch
    tan = bench.worked(TAN_ALPHA, lead / (Quantity(Txt("π"), pi, "") * mean))
    steep = float(np.degrees(np.arctan(tan.value)))
    alpha = bench.stated(ALPHA, steep, Row((named("α"), Txt(f" = arctan {number(float(tan.value))} = {number(steep, 5)}°"))))
    if device.beta is None:
        board.step(Words("螺纹副的摩擦角：", "The friction angle of the thread:"))
        return _Jack(mean=mean, lead=lead, alpha=alpha, phi=friction_angle(bench, PHI, device.thread, "f" if device.f else "f_s"))
    board.step(Words("三角螺纹的侧面倾斜 $β$，同样的载荷产生更大的法向力，以当量摩擦系数 $f_v$ 代替 $f$，相应的摩擦角为 $φ_v$：",
                     "The flanks of the V-thread lean by $β$, the same load presses them harder: an equivalent coefficient $f_v$ stands in for $f$, with the friction angle $φ_v$:"))
    f = magnitude("f" if device.f else "f_s", device.thread.si, "")
    wedge = board.compute("f_v", f / Of("cos", magnitude("β", degrees(device.beta.si), "deg")), "")
    lean = float(np.degrees(np.arctan(wedge.value)))
    phi = bench.stated(PHI_V, lean, row_of(named(PHI_V.symbol), f" = arctan $f_v$ = arctan {number(float(wedge.value))} = {number(lean)}°"))
    return _Jack(mean=mean, lead=lead, alpha=alpha, phi=phi)


def _polygon(bench: Bench, device: ScrewJack, jack: _Jack) -> Quantity:
    """The nut on the slope: Q + F_t + R = 0; M_2/Q = F_t d_2 / 2Q."""
    board = bench.board
    sketch = board.open_pane(View.MECHANISM, "thread", Words("螺纹沿中径展开", "Thread unrolled at its mean diameter"))
    plan = board.open_pane(View.FORCE, "thread", Words("螺母的力多边形", "Force polygon of the nut"))
    known = device.Q is not None
    load, push, press_on = (Named("Q", "Q", "N"), Named("F_t", "F_t", "N"), Named("R", "R", "N"))
    if not known:
        load, push, press_on = Named("Q_0", "Q_0", "N"), Named("F_t0", "F_{t0}", "N"), Named("R_0", "R_0", "N")
        board.step(Words(f"各力与载荷成正比，故可先任取载荷 $Q_0$ = {device.trial:g} N 作图。", f"All forces are proportional to the load: draw for any load, say $Q_0$ = {device.trial:g} N."))
    board.step(Words(f"螺母受轴向载荷 ${load.symbol}$、中径处的圆周力 ${push.symbol}$ 和螺纹的反力 ${press_on.symbol}$。螺母沿斜面上升，反力自法线向后偏 $φ$；由三力平衡作力多边形。",
                     f"On the nut act the axial load ${load.symbol}$, the force ${push.symbol}$ at the mean diameter and the thread's reaction ${press_on.symbol}$. "
                     f"The nut moves up the slope, so the reaction leans back from the normal by $φ$; the three close a polygon."), plan)
    along = _slope(bench, device, jack, sketch, (load.symbol, push.symbol, press_on.symbol))
    lean = leaned(1j * along, along, jack.phi.value)
    closed = balance(bench, plan, 0j, given(bench, plan, load, device.trial, -1j), sought(push, 1 + 0j, Words("水平", "level")),
                     sought(press_on, lean, Words("偏法线 $φ$", "$φ$ off normal")))
    ends = closed.ends[push.key]
    letter(bench, plan, {"a": closed.ends[load.key][0], "b": ends[0], "c": ends[1]})
    reading = board.measure(*ends, "b c")
    measured = board.compute(push.symbol, board.mu(plan) * reading, "N")
    m2 = bench.worked(RATIOS[1], measured * jack.mean / Times(2, magnitude(load.symbol, device.trial, "N")))
    bench.read_off(RATIOS[1], plan, reading, "b c")
    return m2


def _slope(bench: Bench, device: ScrewJack, jack: _Jack, place: Pane, symbols: tuple[str, str, str]) -> Points:
    """Draw the unrolled thread to scale with the nut on it and its forces; the direction of the slope as drawn."""
    board = bench.board
    base, height = (board.to_paper(place, mm / 1e3) for mm in (pi * float(jack.mean.value), float(jack.lead.value)))
    foot = board.lay_off(0j, 1 + 0j, base)
    top = board.lay_off(foot, 1j, height)
    along = unit(top)
    body(bench, place, 0j, foot, top)
    under, end = -24j, complex(nominal(foot))
    board.mark(place, *dimension(under, end + under, "π d_2"), Segment(a=0j, b=under, role=Role.CONSTRUCTION), Segment(a=end, b=end + under, role=Role.CONSTRUCTION),
               Note(at=complex(nominal(foot + top)) / 2, words=Words.same(f"${'p' if device.starts == 1 else 'L'}$")),
               AngleMark(at=0j, radius=0.2 * float(nominal(base)), start=0.0, sweep=float(nominal(np.angle(along))), label="α"))
    at = 0.65 * top
    normal = 1j * along
    body(bench, place, at - NUT * along, at + NUT * along, at + NUT * (along + normal), at + NUT * (normal - along))
    load, push, reaction = symbols
    pull(bench, place, at + NUT * normal, -1j, load)
    pull(bench, place, at + NUT * (0.5 * normal - along), 1 + 0j, push)
    press(bench, place, Press(symbol=reaction, at=at, normal=normal, along=leaned(normal, along, jack.phi.value), angle="φ" if device.beta is None else "φ_v"))
    return along


def _collar(bench: Bench, device: ScrewJack) -> Quantity:
    """M_1/Q = f (D³ − d_0³) / 3 (D² − d_0²): an even pressure on a ring."""
    board = bench.board
    ring = board.open_pane(View.MECHANISM, "collar", Words("支承环面", "Ring of the collar"))
    board.step(Words("载荷均布在内外径为 $d_0$、$D$ 的环面上，对环面积分微小摩擦力矩。注意 $D$、$d_0$ 是直径，系数为 1/3（用半径时才是 2/3）：",
                     "The load is spread evenly over the ring between $d_0$ and $D$; sum the moments of friction over its area. "
                     "$D$ and $d_0$ are diameters: the factor is 1/3 (2/3 goes with radii):"), ring)
    outer, inner = _mm("D", device.D), _mm("d_0", device.d0)
    radii = [float(board.to_paper(ring, float(nominal(q.value)) / 2e3)) for q in (outer, inner)]
    for radius, level, symbol in zip(radii, (-radii[0] - 7, 0), ("D", "d_0"), strict=True):
        board.mark(ring, Arc(centre=0j, radius=radius, start=0.0, sweep=2 * pi, role=Role.GIVEN), *dimension(complex(-radius, level), complex(radius, level), symbol))
    board.mark(ring, *(Segment(a=complex(x, 0), b=complex(x, -radii[0] - 9), role=Role.CONSTRUCTION) for x in (-radii[0], radii[0])))
    f = magnitude("f" if device.f else "f_c", device.collar.si, "")
    return bench.worked(RATIOS[0], f * (outer.cubed() - inner.cubed()) / Times(3, outer.squared() - inner.squared()))


def _efficiency(bench: Bench, jack: _Jack, m1: Quantity, m2: Quantity) -> Quantity:
    """M = M_1 + M_2; M_0 = Q d_2 tan α / 2 would do without friction; η = M_0 / M."""
    bench.board.step(Words("提升重物所需的总力矩，以及没有摩擦时的理想力矩 $M_0$：", "The moment that lifts the load, and the moment $M_0$ that would do without friction:"))
    whole = bench.worked(RATIOS[2], m1 + m2)
    m0 = bench.worked(RATIOS[3], jack.mean * Of("tan", jack.alpha) / _pure(2))
    bench.board.step(Words("千斤顶的效率为理想力矩与实际力矩之比；只计螺纹时为 $η_s$：", "The efficiency is the ideal moment over the actual one; of the thread alone it is $η_s$:"))
    bench.worked(ETA, m0 / whole)
    bench.worked(ETA_THREAD, m0 / m2)
    return m0


def _moments(bench: Bench, device: ScrewJack, m1: Quantity, m2: Quantity, m0: Quantity) -> None:
    """F l = M: the load that a force lifts, or the force that a load needs; then the moments in N·m."""
    whole = Quantity(_bracketed(named("M/Q")), m1.value + m2.value, "mm")
    arm = _mm("l", device.lever)
    if device.F:
        bench.board.step(Words("由 $F l = M$ 求能提升的载荷：", "From $F l = M$ follows the load that is lifted:"))
        load = bench.worked(LOAD, magnitude("F", device.F.si, "N") * arm / whole).value
    else:
        bench.board.step(Words("由 $F l = M$ 求手柄上的力：", "From $F l = M$ follows the force on the lever:"))
        load = device.trial
        bench.worked(DRIVE, magnitude("Q", load, "N") * whole / arm)
    in_kn = magnitude("Q", load / 1e3, "kN")
    bench.board.step(Words("各力矩（$Q$ 以 kN 计）：", "The moments ($Q$ in kN):"))
    for name, ratio in zip(MOMENTS, (m1, m2, whole, m0), strict=True):
        bench.worked(name, in_kn * (ratio if ratio is whole else Quantity(_bracketed(ratio.node), ratio.value, "mm")))


def _bracketed(node: Node) -> Node:
    return Row((Txt("("), node, Txt(")")))


def _back(bench: Bench, jack: _Jack, m1: Quantity, m0: Quantity) -> None:
    """Under the load alone: the thread locks where α ≤ φ; M' = M_1 + Q d_2 tan(φ − α) / 2 lowers the load."""
    alpha, phi = jack.alpha, jack.phi
    name = "φ" if phi.node == named("φ") else "φ_v"
    bench.board.step(Words("载荷作用下螺纹能否自动松退：反力须能偏到法线另一侧。", "Can the load turn the screw back? The reaction then leans to the other side of the normal."))
    steep, lean = (number(float(nominal(q.value))) for q in (alpha, phi))
    locks = np.asarray(alpha.value <= phi.value * (1 + 1e-12))
    sign, zh, en = ("≤", "螺纹自锁", "the thread locks itself") if bool(nominal(locks)) else (">", "螺纹不自锁", "the thread does not lock itself")
    bench.judged(SELF_LOCKING, locks, Words(f"$α$ = {steep}° {sign} ${name}$ = {lean}°，{zh}。",
                                            f" $α$ = {steep}° {sign} ${name}$ = {lean}°: {en}."))
    bench.board.step(Words("放下重物所需的力矩（负值表示须加力矩制动），及载荷反向驱动时的效率（$η′ ≤ 0$ 即自锁）：",
                           "The moment that lowers the load (negative: that holds it back), and the efficiency when the load drives ($η′ ≤ 0$: it cannot):"))
    back = bench.worked(BACK, m1 + jack.mean * Of("tan", phi - alpha) / _pure(2))
    bench.worked(ETA_BACK, Sum((back / m0,), (-1,)))
