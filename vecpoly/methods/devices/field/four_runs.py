"""Four runs without phase 三圆法: arcs with the readings as radii meet at Q; OQ is the effect of the trial weight."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import degrees

import numpy as np

from ....algebra.quantity import Expr, Quantity, magnitude
from ....board.paper.marks import Dot, Role
from ....devices.balancing.field import FieldBalancing, bearing, effect, spread, weight
from ....devices.balancing.unclear import check_effect, check_spread, no_meeting
from ....errors import AssemblyError
from ....plane import Points, ahead, cross, distance, nominal, unit
from ....words import Words
from ..bench import Bench
from ..rotor.polygon import heading, stated_bearing
from .view import rotor_seen, vibrations, weight_seen

HALF = 0.35  # rad: to either side of a meeting that an arc is drawn
LEVEL = 1e-6  # sine of the angle under which directions are one line


def by_arcs(bench: Bench, device: FieldBalancing) -> None:
    """The circle of the first reading, the arcs of the others, Q; of two arcs both answers."""
    rotor_seen(bench, device)
    centres = _circle(bench, device)
    if len(centres) == 2:
        _both(bench, device, centres)
        return
    corners = [_corner(bench, device, centres, i, j) for i, j in combinations(range(3), 2)]
    for k, corner in enumerate((corners[0], corners[0], corners[1])):
        _radius(bench, device, centres, k, corner)
    _centroid(bench, device, corners)


def _circle(bench: Bench, device: FieldBalancing) -> list[Points]:
    """Points at the angles of the trial weights, on a circle of radius V_0."""
    board, view = bench.board, vibrations(device)
    board.section(Words("三圆法", "The four-run method"))
    board.step(
        Words(
            f"以 $O$ 为圆心、$V_0$ 为半径（按 ${view.mu.symbol}$）作圆，在圆上标出各试重的方位点 1、2…；"
            "再以各点为圆心、以该次读数 $V_1$、$V_2$… 为半径作弧。",
            f"About $O$ draw a circle of radius $V_0$ (to the scale ${view.mu.symbol}$) and mark on it the angles of "
            "the "
            "trial weights, 1, 2 …; about these points swing arcs with the readings $V_1$, $V_2$ … as radii.",
        ),
        view,
    )
    board.plot(view, 0j, "O", Dot.POLE)
    radius = board.to_paper(view, device.initial.size)
    board.circle(view, 0j, radius, Role.CENTRE)
    centres = []
    for i, trial in enumerate(device.trials, 1):
        at = board.locate(view, str(i), board.lay_off(0j, heading(degrees(trial.at.si)), radius, key=f"P_{i}"))
        board.join(view, 0j, at, Role.CONSTRUCTION)
        board.plot(view, at, str(i))
        centres.append(at)
    board.plot(view, centres[0] / 2, "V_0", Dot.NONE)
    return centres


def _meetings(bench: Bench, device: FieldBalancing, centres: Sequence[Points], i: int, j: int) -> tuple[Points, Points]:
    board, view = bench.board, vibrations(device)
    one, other = (board.to_paper(view, device.trials[k].reading.size) for k in (i, j))
    try:
        return board.arcs(centres[i], one, centres[j], other, Words("两次试重的弧", "the arcs of two runs"))
    except AssemblyError:
        c = float(nominal(np.abs(centres[i] - centres[j]))) * board.scale_of(view).value
        a, b = (device.trials[k].reading.size for k in (i, j))
        raise no_meeting(i + 1, j + 1, max(c - a - b, abs(a - b) - c), device.unit) from None


def _corner(bench: Bench, device: FieldBalancing, centres: Sequence[Points], i: int, j: int) -> Points:
    """Of two meetings the one nearer to the third arc."""
    (k,) = {0, 1, 2} - {i, j}
    size = bench.board.to_paper(vibrations(device), device.trials[k].reading.size)
    pair = _meetings(bench, device, centres, i, j)
    near = min(pair, key=lambda q: abs(float(nominal(distance(centres[k], q) - size))))
    _swung(bench, device, centres, (i, j), near)
    return bench.board.either(near)


def _swung(bench: Bench, device: FieldBalancing, centres: Sequence[Points], runs: tuple[int, ...], at: Points) -> None:
    """The arcs of these runs, a good way to either side of where they meet."""
    board, view = bench.board, vibrations(device)
    for k in runs:
        way = float(np.angle(nominal(at - centres[k])))
        radius = board.to_paper(view, device.trials[k].reading.size)
        board.circle(view, centres[k], radius, start=way - HALF, sweep=2 * HALF)


def _radius(bench: Bench, device: FieldBalancing, centres: Sequence[Points], k: int, at: Points) -> None:
    """The radius of an arc, which is a reading, with its symbol."""
    board, view = bench.board, vibrations(device)
    end = ahead(centres[k], unit(at - centres[k]), board.to_paper(view, device.trials[k].reading.size))
    board.join(view, centres[k], end, Role.CONSTRUCTION)
    board.plot(view, (centres[k] + end) / 2, f"V_{k + 1}", Dot.NONE)


def _centroid(bench: Bench, device: FieldBalancing, corners: list[Points]) -> None:
    """Three arcs rarely concur: the centroid of their small triangle, and how large that is."""
    board, view = bench.board, vibrations(device)
    named = spread(device.unit)
    sides = [(np.abs(a - b), (a, b)) for a, b in combinations(corners, 2)]
    _, longest = max(sides, key=lambda side: float(nominal(side[0])))
    board.step(
        Words(
            "读数有误差，三弧一般不交于一点，而围成一个小三角形；取其形心为 $Q$。三角形最长的边 $Δ$ 反映读数的误差：",
            "Owing to reading errors the three arcs do not meet at one point but enclose a small triangle, whose "
            "centroid is $Q$. Its longest side $Δ$ is a measure of these errors:",
        ),
        view,
    )
    board.tint(view, tuple(corners))
    board.plot(view, (longest[0] + longest[1]) / 2, "Δ", Dot.NONE)
    bench.measured(named, view, *longest, "Δ")
    q = board.locate(view, "Q", (corners[0] + corners[1] + corners[2]) / 3)
    size = float(nominal(np.abs(q))) * board.scale_of(view).value
    check_spread(device, float(nominal(np.abs(longest[0] - longest[1]))) * board.scale_of(view).value, size)
    _answer(bench, device, q, "Q", "")


def _both(bench: Bench, device: FieldBalancing, centres: Sequence[Points]) -> None:
    """Two arcs leave two answers; a third run would decide."""
    board, view = bench.board, vibrations(device)
    pair = _meetings(bench, device, centres, 0, 1)
    board.step(_why_both(centres), view)
    ordered = sorted(pair, key=lambda q: float(np.degrees(np.angle(nominal(q)))) % 360.0)
    for which, at in enumerate(ordered, 1):
        _swung(bench, device, centres, (0, 1), at)
        for k in (0, 1) if which == 1 else ():
            _radius(bench, device, centres, k, at)
        _answer(bench, device, board.locate(view, f"Q_{which}", at), f"Q_{which}", f"_{which}")


def _why_both(centres: Sequence[Points]) -> Words:
    """The meetings mirror each other in the line of the centres; with O on it their distances from O are equal."""
    one, other = (complex(nominal(at)) for at in centres)
    on_it = abs(float(cross(one, other))) < LEVEL * abs(one) * abs(other)
    where = (
        Words(
            "试重方位点 1、2 与 $O$ 共线，两弧的交点 $Q_1$、$Q_2$ 关于这条直线对称，$OQ_1$ = $OQ_2$，"
            "故校正质量大小相同，方位对称于这条直线",
            "the trial points 1, 2 and $O$ are collinear, and the intersections $Q_1$, $Q_2$ of the arcs are mirror "
            "images in that line: $OQ_1$ = $OQ_2$, so that the corrections are equal and lie symmetrically about it",
        )
        if on_it
        else Words(
            "两弧的交点 $Q_1$、$Q_2$ 关于圆心连线 12 对称",
            "the intersections $Q_1$, $Q_2$ of the arcs are mirror images in the line 12 of their centres",
        )
    )
    return (
        Words("只有两次试重：", "There were only two trial runs: ")
        + where
        + Words(
            "；两个解都符合读数（只测大小，不测相位），须在该直线以外的方位再试一次才能取舍。",
            "; both fit the readings, which have a size and no phase. A third run off that line decides.",
        )
    )


def _answer(bench: Bench, device: FieldBalancing, q: Points, letter: str, way: str) -> None:
    """m_b = m_t V_0/OQ r_t/r_b, on the rotor in the direction of Q."""
    board, view, named = bench.board, vibrations(device), effect(device.unit, way)
    board.plot(view, q, letter)
    board.step(
        Words(
            f"$O{letter}$ 为试重的效应，校正质量装在 ${letter}$ 的方向上：",
            f"The vector $O{letter}$ is the effect of the trial weight; the correction is to be placed in the "
            f"direction of ${letter}$:",
        ),
        view,
    )
    board.arrow(view, 0j, q, Role.RESULT, key=named.key, label=named.symbol)
    moved = bench.measured(named, view, 0j * q, q, f"O {letter}")
    check_effect(device, float(nominal(np.abs(q))) * board.scale_of(view).value)
    bench.worked(weight(way), _weight(device, moved))
    stated_bearing(bench, bearing(way), q, 0.0)
    turn = float(nominal(bench.board.found[bearing(way).key]))
    weight_seen(bench, device, turn, weight(way).symbol, bearing(way).symbol)


def _weight(device: FieldBalancing, moved: Quantity) -> Expr:
    trial = device.trials[0]
    whole = magnitude("m_t", trial.m.si * 1e3, "g") * (magnitude("V_0", device.initial.size, device.unit) / moved)
    if trial.r.si == device.correct.r.si:
        return whole
    return whole * (magnitude("r_t", trial.r.si * 1e3, "mm") / magnitude("r_b", device.correct.r.si * 1e3, "mm"))
