"""A gear by generation (范成法): reference circle, line of action, limits of undercut, thickness of the teeth."""

from __future__ import annotations

from math import degrees, pi, sin, tan

import numpy as np

from ....algebra.formula import Txt
from ....algebra.quantity import Quantity, Times, magnitude
from ....board.construction import Scale, View
from ....board.paper.marks import Dot, Role
from ....devices.gears.generation import RA, RB, RF, S_TIP, START, X_MIN, Z_MIN, GearGeneration, R, S
from ....foundation.slotted import replace
from ....plane import Line, Points, Reals, nominal
from ....problem.problem import Scales
from ....words import Words
from ..bench import Bench
from ..cam.read.readings import length
from ..cam.scales import fitting
from ..registry import device_method
from .places import draw_places, draw_tooth
from .rack import VIEW, Rack, contact, place_rack
from .start import crossing, cuts_in
from .teeth import judge_undercut, whole_teeth
from .tip import pointed

TALL, WIDE, PITCHES = 130.0, 158.0, 1.25  # mm: the tip radius, the figure; of the circles to either side
DEGREE = Quantity(Txt("(180°/π)"), degrees(1.0), "deg", "57.296")
TWO = Quantity(Txt("2"), 2.0, "")


def gear_scales(gear: GearGeneration, given: Scales) -> dict[View, Scale]:
    """As given, or as large as a page allows."""
    across = 2 * gear.size * sin(_opening(gear))
    return {VIEW: Scale.of(VIEW, given.of(VIEW.mu) or fitting(max(gear.size / TALL, across / WIDE)))}


def _opening(gear: GearGeneration) -> float:
    """How far the circles are drawn to either side of the tooth (rad)."""
    return min(PITCHES * 2 * pi / gear.z, pi / 2)


@device_method(
    GearGeneration,
    title=Words("渐开线齿廓的范成", "Generation of involute teeth by a rack"),
    source="机械原理, gears: generation, line of action, undercut, shift of the rack",
    example="gear-undercut",
    scales=gear_scales,
    called=Words("范成图", "Generation by the rack"),
)
def draw_generation(bench: Bench, gear: GearGeneration) -> None:
    """The circles, the rack, the limits of undercut, the tooth."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    radii = _circles(bench, gear, mm)
    rack = _rack(bench, gear, mm)
    base = length(bench, RB, VIEW, 0j, rack.foot, "O N")
    _limits(bench, gear, rack)
    thick = _thickness(bench, rack)
    aside = _start(bench, rack)
    _tip(bench, rack, radii, thick, base)
    board.step(
        Words(
            "使齿条节线在分度圆上作纯滚动，逐次画出齿条齿廓的位置，其包络线即被切齿轮的齿廓。",
            "Let the rack's rolling line roll on the reference circle and draw the rack in successive positions: "
            "the envelope of its flanks is the tooth.",
        ),
        VIEW,
    )
    draw_places(board, rack)
    draw_tooth(board, gear, mm, radii[1] / mm, aside)


def _circles(bench: Bench, gear: GearGeneration, mm: float) -> tuple[float, float]:
    """Reference, tip and root circle; gives the first two radii (m)."""
    board = bench.board
    board.section(Words("齿轮坯与齿条", "Blank and rack"))
    board.step(
        Words("作分度圆、齿顶圆和齿根圆：", "Draw the reference circle, the tip circle and the root circle:"), VIEW
    )
    m, z, x = magnitude("m", 1e3 * gear.m.si, "mm"), magnitude("z", float(gear.z), ""), magnitude("x", gear.x, "")
    ha, c = magnitude("h_a^{*}", gear.ha.si, ""), magnitude("c^{*}", gear.c.si, "")
    r = bench.worked(R, m * z / TWO)
    ra, rf = bench.worked(RA, r + (ha + x) * m), bench.worked(RF, r - (ha + c - x) * m)
    for found, symbol in ((r, R.symbol), (ra, RA.symbol), (rf, RF.symbol)):
        _ring(bench, gear, float(nominal(found.value)) / 1e3 / mm, symbol)
    board.plot(VIEW, 0j, "O", Dot.JOINT)
    return float(nominal(r.value)) / 1e3, float(nominal(ra.value)) / 1e3


def _ring(bench: Bench, gear: GearGeneration, radius: Reals, symbol: str, role: Role = Role.CENTRE) -> None:
    """A circle about O as far as it is drawn, its radius by name at its end."""
    reach = _opening(gear)
    bench.board.circle(VIEW, 0j, radius, role, start=pi / 2 - reach, sweep=2 * reach)
    bench.board.plot(VIEW, radius * np.exp(1j * (pi / 2 + reach)), symbol, Dot.NONE)


def _rack(bench: Bench, gear: GearGeneration, mm: float) -> Rack:
    board = bench.board
    board.step(
        Words(
            "节点 $P$ 在 $O$ 的正上方，齿条的中线离 $P$ 为 $x$$m$。过 $P$ 作啮合线，与齿条节线成 $α$ 角；由 $O$ 作其"
            "垂线，垂足 $N$ 为啮合线与基圆的切点，量得基圆半径：",
            "The pitch point $P$ lies straight above $O$, the rack's middle line $x$$m$ from it. The line of action "
            "passes through $P$ at the angle $α$ to the rolling line; the perpendicular from $O$ meets it at $N$, "
            "where it touches the base circle, whose radius is read:",
        ),
        VIEW,
    )
    rack = place_rack(board, gear, mm)
    board.join(VIEW, rack.foot, rack.pole + 1.4 * (rack.pole - rack.foot), Role.DIRECTION)
    board.join(VIEW, 0j, rack.foot, Role.CONSTRUCTION)
    board.join(VIEW, 0j, rack.pole, Role.CENTRE)
    _ring(bench, gear, np.abs(rack.foot), RB.symbol, Role.HIDDEN)
    board.right_angle(VIEW, rack.foot, rack.action.along, 1j * rack.action.along)
    board.plot(VIEW, rack.pole, "P", Dot.POINT)
    board.plot(VIEW, rack.foot, "N", Dot.POINT)
    return rack


def _limits(bench: Bench, gear: GearGeneration, rack: Rack) -> None:
    """The corner must not pass N: h = PQ is the depth of N under P."""
    board = bench.board
    board.section(Words("根切", "Undercut"))
    board.step(
        Words(
            "齿条齿顶线不超过 $N$ 时不根切。过 $N$ 作水平线交 $OP$ 于 $Q$，$h$ = $PQ$，由 $h_a^{*}$$m$ − $x$$m$ ≤ $h$ "
            "得：",
            "There is no undercut while the rack's tip line does not pass $N$. The horizontal through $N$ meets $OP$ "
            "at $Q$; with $h$ = $PQ$ the condition $h_a^{*}$$m$ − $x$$m$ ≤ $h$ gives:",
        ),
        VIEW,
    )
    level = board.parallel(rack.foot, 1 + 0j)
    axis = Line(rack.pole, board.turn(-1j))
    under = board.meet(level, axis, Words("$N$ 的水平线", "the horizontal through $N$"))
    board.join(VIEW, rack.foot, under, Role.CONSTRUCTION)
    board.plot(VIEW, under, "Q", Dot.POINT)
    scale = board.scale_of(VIEW)
    h = board.compute(
        "h", magnitude(scale.symbol, 1e3 * scale.value, "mm/mm") * board.measure(rack.pole, under, "P Q"), "mm"
    )
    m, ha = magnitude("m", 1e3 * gear.m.si, "mm"), magnitude("h_a^{*}", gear.ha.si, "")
    least = bench.worked(X_MIN, ha - h / m)
    teeth = bench.worked(Z_MIN, ha * m * magnitude("z", float(gear.z), "") / h)
    board.step(whole_teeth(gear, teeth.value, h.value / (1e3 * scale.value)))
    judge_undercut(bench, gear, least.value)


def _thickness(bench: Bench, rack: Rack) -> Quantity:
    """s on the reference circle is the width of the rack's space on the rolling line."""
    board = bench.board
    board.section(Words("齿厚", "Thickness"))
    board.step(
        Words(
            "分度圆齿厚等于齿条节线上的齿槽宽：节线与齿条两侧齿廓交于 $E$、$F$，量得：",
            "The thickness on the reference circle is the width of the rack's space on the rolling line, which meets "
            "the flanks at $E$ and $F$:",
        ),
        VIEW,
    )
    rolling = board.parallel(rack.pole, 1 + 0j)
    right = board.meet(rack.flank, rolling, Words("节线与齿廓", "the rolling line and the flank"))
    left = 2 * rack.pole - right
    up = rack.flank.at - rack.flank.along * rack.gear.ha.si * rack.module
    for side, letter in ((right, "E"), (left, "F")):
        board.plot(VIEW, side, letter, Dot.POINT)
    for a, b in ((up, rack.corner), (-np.conj(up), -np.conj(rack.corner))):
        board.join(VIEW, a, b, Role.GIVEN)
    board.join(VIEW, left, right, Role.CONSTRUCTION)
    return length(bench, S, VIEW, left, right, "F E")


def _start(bench: Bench, rack: Rack) -> float:
    """r_s: the corner on the line of action, or where its path crosses the involute. Gives how far that is from OP."""
    board, gear = bench.board, rack.gear
    cut = cuts_in(board, gear, rack.mm)
    aside = crossing(board, gear, rack.mm) if cut else (rack.r - rack.tip) / tan(gear.alpha.si)
    board.step(
        Words(
            "齿条角点的轨迹（延伸渐开线）经试作与渐开线交于 $S$，其下的渐开线已被切去。切出 $S$ 时角点位于齿顶线上的 "
            "$S′$，$OS$ = $OS′$，量得：",
            "By trial the path of the rack's corner (a trochoid) crosses the involute in $S$; the involute below it "
            "is cut off. As it cuts $S$ the corner stands at $S′$ on the tip line, and $OS$ = $OS′$, which is read:",
        )
        if cut
        else Words(
            "齿条齿顶线与啮合线交于 $S′$，渐开线的起点 $S$ 在此切出，$OS$ = $OS′$，量得：",
            "The rack's tip line meets the line of action at $S′$, where $S$, the start of the involute, is cut; "
            "$OS$ = $OS′$, which is read:",
        ),
        VIEW,
    )
    low = board.lay_off(rack.pole, -1j, (gear.ha.si - gear.x) * rack.module)
    line = board.parallel(low, 1 + 0j)
    at: Points
    if cut:
        at = board.lay_off(low, -line.along, aside)
    else:
        at = board.meet(line, rack.action, Words("齿顶线与啮合线", "the tip line and the line of action"))
    board.join(VIEW, low, at, Role.CONSTRUCTION)
    board.plot(VIEW, at, "S′", Dot.POINT)
    length(bench, START, VIEW, 0j, at, "O S′")
    return aside


def _tip(bench: Bench, rack: Rack, radii: tuple[float, float], thick: Quantity, base: Quantity) -> None:
    """The flank touches the tip circle in K; it has rolled on by PK / r_b since P, and turned by ∠POK."""
    board = bench.board
    board.step(
        Words(
            "啮合线与齿顶圆交于 $K$，齿廓上的齿顶点在此啮合；自 $P$ 点啮合以来齿轮转过 $PK$/$r_b$，故齿顶半角为 "
            "$s$/2$r$ + $∠POK$ − $PK$/$r_b$：",
            "The line of action meets the tip circle at $K$, where the end of the flank is in contact; since the "
            "contact in $P$ the gear has turned by $PK$/$r_b$, so half the angle of the tip is $s$/2$r$ + $∠POK$ − "
            "$PK$/$r_b$:",
        ),
        VIEW,
    )
    at, _ = contact(board, rack, radii[1] / rack.mm)
    board.plot(VIEW, at, "K", Dot.POINT)
    board.join(VIEW, 0j, at, Role.CONSTRUCTION)
    board.join(VIEW, rack.pole, at, Role.DIRECTION)
    scale = board.scale_of(VIEW)
    mu = magnitude(scale.symbol, 1e3 * scale.value, "mm/mm")
    way = board.compute("PK", mu * board.measure(rack.pole, at, "P K"), "mm")
    angle = magnitude("∠POK", np.degrees(board.gauge(0j, rack.pole / at)), "deg")
    r = magnitude("r", 1e3 * radii[0], "mm")
    half = board.compute("ψ_a", DEGREE * thick / (TWO * r) + angle - DEGREE * way / base, "deg")
    thickness = Times(2, magnitude("r_a", 1e3 * radii[1], "mm") * half) / DEGREE
    if float(nominal(thickness.value)) > 0:
        tip = bench.worked(S_TIP, thickness)
    else:  # the flanks have met before
        tip = board.formula(S_TIP.symbol, thickness, S_TIP.unit)
        bench.stated(S_TIP, np.maximum(tip.value, 0.0))
    said = pointed(tip.value, 1e3 * rack.gear.m.si)
    board.remark(said)
    board.revise(replace(board.readings[S_TIP.key], remark=said))
