"""Shaking force 惯性力 of a slider-crank: two-mass rod, counterweight, the polygon at φ, the hodograph over a turn."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees, pi

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, magnitude, number
from ....board.construction import Scale, View
from ....board.paper.marks import Dot, Lump, Role
from ....board.place import view_named
from ....devices.balancing.shaking import (
    COUNTERWEIGHT,
    FIRST,
    FORCE,
    FRACTION,
    LARGEST,
    MOST_C,
    RATIO,
    RECIPROCATING,
    ROTATING,
    SECOND,
    WHERE,
    ShakingForce,
)
from ....diagram.single import block, disc, pivot, rail, rod
from ....plane import Line, Points, nominal
from ....problem.problem import Scales
from ....words import Words
from ..bench import Bench, trial_board
from ..inclined import row_of
from ..registry import device_method
from ..rotor.scales import fitting
from .hodograph import Orders, best_fraction, farthest, parts, tip

HODOGRAPH = view_named("hodograph")
LONG, WIDE = 105.0, 104.0  # mm: crank and rod in line; across the hodograph
STATIONS = 24
KEYS = ("F_1", "F_2", "F_c")


def shaking_scales(device: ShakingForce, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    part = device.BS2.si / device.l.si
    first = (device.m3.si + device.m2.si * part) * device.r.si * device.n.si**2
    force = given.of(HODOGRAPH.mu) or fitting(2 * first * (1 + device.r.si / device.l.si) / WIDE)
    length = given.of(View.MECHANISM.mu) or fitting(device.size / LONG)
    return {View.MECHANISM: Scale.of(View.MECHANISM, length), HODOGRAPH: Scale.of(HODOGRAPH, force)}


@device_method(
    ShakingForce,
    title=Words(
        "曲柄滑块机构惯性力的部分平衡（矢端曲线）", "Shaking force of a slider-crank: hodograph and counterweight"
    ),
    source="机械原理, balance of a slider-crank: two-mass rod, counterweight on the crank, hodograph of the force",
    example="engine-single",
    scales=shaking_scales,
    called=View.MECHANISM.title,
)
def draw_shaking(bench: Bench, device: ShakingForce) -> None:
    """Masses, both orders, the fraction, the force at φ and over the turn."""
    _sketch(bench, device)
    moving, rotating = _masses(bench, device)
    orders = _orders(bench, device, moving)
    place = _circles(bench, orders)
    c = _fraction(bench, device, orders)
    _counterweight(bench, device, moving, rotating, c)
    _at(bench, device, orders, place, c)
    _over_a_turn(bench, device, orders, place, c)


def _sketch(bench: Bench, device: ShakingForce) -> None:
    board, view = bench.board, View.MECHANISM
    mm = board.scale_of(view).value
    board.section(Words("机构简图", "The mechanism"))
    board.step(
        Words(
            "按 $μ_l$ 画出机构简图，$φ$ 自外死点量起；配重 $m_c$ 装在曲柄的反方向。",
            "Draw the mechanism to the scale $μ_l$; $φ$ is measured from the outer dead centre. The counterweight "
            "$m_c$ "
            "sits opposite to the crank.",
        ),
        view,
    )
    way = complex(np.exp(1j * device.at.si))
    b = board.lay_off(0j, way, device.r.si / mm)
    c, _ = board.arc_on_line(Line(0j * b, 1 + 0j * b), b, device.l.si / mm, Words("滑块 C", "slider C"))
    end = complex(nominal(c))
    board.depict(view, rail(end - complex(18, 5), end + complex(18, -5), end), rod("link 1", 0j, b))
    board.join(view, 0j, c, Role.CENTRE)
    board.depict(view, rod("link 2", b, c), block("link 3", c, 1 + 0j), pivot(0j, "A"))
    weight = -way * device.r_c.si / mm
    board.join(view, 0j, weight, Role.HIDDEN)
    board.depict(view, disc("counterweight", weight, 2.5, Lump.COUNTERWEIGHT))
    for at, letter in ((b, "B"), (c, "C")):
        board.plot(view, at, letter, Dot.JOINT)
    board.plot(view, weight, "m_c", Dot.NONE)
    board.angle(view, 0j, 1 + 0j, device.at.si % (2 * pi), 10.0, "φ")


def _masses(bench: Bench, device: ShakingForce) -> tuple[Quantity, Quantity]:
    """The rod as masses at B and C."""
    board = bench.board
    board.section(Words("质量代换", "Two-mass rod"))
    board.step(
        Words(
            "连杆的质量 $m_2$ 代换到 $B$、$C$ 两点：$B$ 处随曲柄转动的质量 $m_B$，$C$ 处往复的质量 $m_C$。",
            "The mass $m_2$ of the rod is put at $B$ and $C$: $m_B$ turns with the crank, $m_C$ reciprocates.",
        )
    )
    rod_, span = magnitude("m_2", device.m2.si, "kg"), magnitude("l", device.l.si * 1e3, "mm")
    arm = magnitude("l_{BS2}", device.BS2.si * 1e3, "mm")
    rotating = bench.worked(ROTATING, magnitude("m_1", device.m1.si, "kg") + rod_ * ((span - arm) / span))
    moving = bench.worked(RECIPROCATING, magnitude("m_3", device.m3.si, "kg") + rod_ * (arm / span))
    return moving, rotating


def _orders(bench: Bench, device: ShakingForce, moving: Quantity) -> Orders:
    """F_1 = m_C r ω² and F_2 = λ F_1."""
    board = bench.board
    ratio = device.r.si / device.l.si
    board.step(
        Words(
            "往复质量的惯性力取两项：$F_1 cos φ$ + $F_2 cos 2φ$（略去的各项约为 $λ^3$/4，"
            f"即 $F_1$ 的 {number(25 * ratio**3, 2)} %）。",
            "Two terms of the inertia force of the reciprocating mass are taken, $F_1 cos φ$ + $F_2 cos 2φ$ (those "
            f"neglected are about $λ^3$/4, {number(25 * ratio**3, 2)} % of $F_1$).",
        )
    )
    crank = magnitude("r", device.r.si, "m")
    lamb = bench.worked(RATIO, crank / magnitude("l", device.l.si, "m"))
    speed = magnitude("ω", device.n.si, "rad/s")
    first = bench.worked(FIRST, moving * crank * speed.squared())
    second = bench.worked(SECOND, lamb * first)
    to_paper = board.to_paper
    return Orders(first=to_paper(HODOGRAPH, first.value), second=to_paper(HODOGRAPH, second.value))


def _circles(bench: Bench, orders: Orders) -> View:
    board = bench.board
    board.section(Words("惯性力的矢端曲线", "Hodograph of the shaking force"))
    place = HODOGRAPH
    board.step(
        Words(
            "以 $O$ 为圆心，按 $μ_P$ 以 $F_1$、$F_2$ 为半径作两圆：大圆上方向角为 $φ$ 的点、小圆上方向角为 $2φ$ 的点"
            "在缸心线（$x$ 轴）"
            "上的投影就是一阶、二阶惯性力。",
            "About $O$ draw to the scale $μ_P$ two circles of radii $F_1$ and $F_2$: the point at $φ$ on the larger "
            "and "
            "the point at $2φ$ on the smaller, projected onto the cylinder ($x$ axis), give the forces of first and "
            "second order.",
        ),
        place,
    )
    board.plot(place, 0j, "O", Dot.POLE)
    for radius in (orders.first, orders.second):
        board.circle(place, 0j, radius, Role.CENTRE)
    reach = float(nominal(orders.first)) * 1.3
    board.join(place, -reach + 0j, reach + 0j, Role.CENTRE)
    board.plot(place, reach + 0j, "x", Dot.NONE)
    return place


def _fraction(bench: Bench, device: ShakingForce, orders: Orders) -> float:
    """c as given; else that with which the largest force of the turn is least, by trial on scratch paper."""
    if not device.seeks:
        return device.c.si
    bench.board.step(
        Words(
            "在草图上试取不同的 $c$，使矢端曲线上离 $O$ 最远的点最近：",
            "On scratch paper try fractions $c$ until the farthest point of the hodograph is as near to $O$ as can be:",
        )
    )
    ideal = Orders(first=float(nominal(orders.first)), second=float(nominal(orders.second)))
    c = best_fraction(trial_board(bench.board), ideal, MOST_C)
    bench.stated(FRACTION, c + 0.0 * np.abs(orders.first))
    return c


def _counterweight(bench: Bench, device: ShakingForce, moving: Quantity, rotating: Quantity, c: float) -> None:
    bench.board.step(
        Words(
            "配重平衡全部转动质量和往复质量的 $c$ 倍：",
            "The counterweight balances all of the rotating mass, and the part $c$ of the reciprocating one:",
        )
    )
    whole = rotating + magnitude("c", c, "") * moving
    bench.worked(
        COUNTERWEIGHT, whole * (magnitude("r", device.r.si * 1e3, "mm") / magnitude("r_c", device.r_c.si * 1e3, "mm"))
    )


def _at(bench: Bench, device: ShakingForce, orders: Orders, place: View, c: float) -> None:
    """The polygon at φ: both orders along the cylinder, then the force of the counterweight, against the crank."""
    board = bench.board
    board.step(
        Words(
            f"$φ$ = {number(degrees(device.at.si), 5)}° 时：沿 $x$ 轴先后画一阶、二阶惯性力，再画配重多余部分的离心"
            "力 $c F_1$"
            "（与曲柄反向），自 $O$ 到末端即机架所受的惯性力 $F$：",
            f"At $φ$ = {number(degrees(device.at.si), 5)}°: along the $x$ axis draw the forces of first and second "
            "order, then the centrifugal force $c F_1$ of what the counterweight has to spare, against the crank; from "
            "$O$ to the end is the force $F$ on the frame:",
        ),
        place,
    )
    corners: list[Points] = [0j]
    for part, key in zip(parts(board, orders, device.at.si, c, KEYS), KEYS, strict=True):
        corners.append(corners[-1] + part)
        board.arrow(place, corners[-2], corners[-1], Role.GIVEN, key=key, label=_LABELS[key])
    end = board.locate(place, "q", corners[-1])
    board.plot(place, end, "q")
    board.arrow(place, 0j, end, Role.RESULT, key=FORCE.key, label=FORCE.symbol)
    bench.measured(FORCE, place, 0j * end, end, "O q")


_LABELS = {"F_1": "F_1 cos φ", "F_2": "F_2 cos 2φ", "F_c": "c F_1"}


def _over_a_turn(bench: Bench, device: ShakingForce, orders: Orders, place: View, c: float) -> None:
    """The hodograph through 24 places, and its farthest point."""
    board = bench.board
    ideal = Orders(first=float(nominal(orders.first)), second=float(nominal(orders.second)))
    turns = np.linspace(0, 2 * pi, STATIONS + 1)
    points = tip(trial_board(board), ideal, turns, c)
    board.step(
        Words(
            "每隔 15° 重复，连成矢端曲线，它对称于气缸轴线（$360° − φ$ 处的力同样大）；"
            "离 $O$ 最远的点 $m$ 给出一周内最大的惯性力：",
            "Repeat every 15° and join the ends: the hodograph, symmetric about the line of the cylinder (the force is "
            "as large at $360° − φ$). Its point $m$ farthest from $O$ gives the largest force of the turn:",
        ),
        place,
    )
    board.curve(place, [complex(at) for at in np.asarray(points)], Role.RESULT)
    where, _ = farthest(trial_board(board), ideal, c)
    end = board.locate(place, "m", tip(board, orders, where, c))
    board.join(place, 0j, end, Role.CONSTRUCTION)
    board.plot(place, end, "m")
    bench.measured(LARGEST, place, 0j * end, end, "O m")
    if not device.seeks:
        turn = degrees(where) + 0.0 * np.abs(orders.first)
        bench.stated(WHERE, turn, row_of(sym(WHERE.symbol), f" = {number(degrees(where), 5)}°"))
