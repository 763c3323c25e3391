"""Influence coefficient 影响系数法: V_1 − V_0 is what the trial weight does; turned and scaled it cancels V_0."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, magnitude, number
from ....board.paper.marks import Dot, Role
from ....devices.balancing.field import EFFECT_PHASE, TURN, FieldBalancing, Trial, bearing, coefficient, effect, weight
from ....devices.balancing.unclear import check_effect
from ....devices.balancing.vibration import Vibration
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..inclined import row_of
from ..rotor.polygon import heading, stated_bearing
from .view import rotor_seen, vibrations, weight_seen

AHEAD, ARC = 16.0, 12.0  # mm: how far a vector is drawn on; radius of the angle


def by_coefficient(bench: Bench, device: FieldBalancing) -> None:
    """The triangle O a b, the coefficient, the angle by which the trial weight is turned, and its size."""
    (trial,) = device.trials
    rotor_seen(bench, device)
    a, b = _triangle(bench, device, trial)
    moved = _effect(bench, device, trial, a, b)
    _correction(bench, device, trial, (a, b), moved)


def _triangle(bench: Bench, device: FieldBalancing, trial: Trial) -> tuple[Points, Points]:
    """V_0 and V_1 from one pole."""
    board, view = bench.board, vibrations(device)
    board.section(Words("振动矢量图", "Vibration vectors"))
    board.step(
        Words(
            f"自极点 $O$ 按 ${view.mu.symbol}$ 画出初始振动 $V_0$ = $Oa$ 和加试重后的振动 $V_1$ = $Ob$（长度为振幅，"
            "方向为相位）。",
            f"From the pole $O$ draw to the scale ${view.mu.symbol}$ the first vibration $V_0$ = $Oa$ and that with "
            "the "
            "trial weight $V_1$ = $Ob$: lengths are amplitudes, directions phases.",
        ),
        view,
    )
    board.plot(view, 0j, "O", Dot.POLE)
    tips = (_tip(bench, device, *one) for one in (("V_0", device.initial, "a"), ("V_1", trial.reading, "b")))
    a, b = tips
    return a, b


def _tip(bench: Bench, device: FieldBalancing, key: str, shown: Vibration, letter: str) -> Points:
    board, view = bench.board, vibrations(device)
    tip = board.lay_off(0j, heading(shown.degrees), board.to_paper(view, shown.size), key=key)
    tip = board.locate(view, letter, tip)
    board.arrow(view, 0j, tip, Role.GIVEN, key=key, label=key)
    board.plot(view, tip, letter)
    return tip


def _effect(bench: Bench, device: FieldBalancing, trial: Trial, a: Points, b: Points) -> Quantity:
    """ab: what the trial weight alone does; over its product, the coefficient."""
    board, view, named = bench.board, vibrations(device), effect(device.unit)
    board.step(
        Words(
            "$ab$ = $V_1$ − $V_0$ 就是试重单独引起的振动（效应）$V_t$；除以试重的质径积即影响系数 $α$：",
            "The vector $ab$ = $V_1$ − $V_0$ is what the trial weight alone does, its effect $V_t$; over the product "
            "of the trial weight it is the influence coefficient $α$:",
        ),
        view,
    )
    board.arrow(view, a, b, Role.RESULT, key=named.key, label=named.symbol)
    moved = bench.measured(named, view, a, b, "a b")
    check_effect(device, float(nominal(np.abs(b - a))) * board.scale_of(view).value)
    stated_bearing(bench, EFFECT_PHASE, b - a, 0.0)
    product = _weight(trial) * magnitude("r_t", trial.r.si * 1e3, "mm")
    bench.worked(coefficient(device.unit), moved / product)
    return moved


def _weight(trial: Trial) -> Quantity:
    return magnitude("m_t", trial.m.si * 1e3, "g")


def _correction(
    bench: Bench, device: FieldBalancing, trial: Trial, tips: tuple[Points, Points], moved: Quantity
) -> None:
    """Turn the trial weight by β, from the effect to the vector that is left over, reversed; scale it."""
    board, view = bench.board, vibrations(device)
    (a, b), stays = tips, device.correct.trial == "left"
    corner, symbol, shown = (b, "V_1", trial.reading) if stays else (a, "V_0", device.initial)
    board.step(_told(symbol, stays), view)
    if stays:
        board.join(view, b, b + (b - a) / np.abs(b - a) * AHEAD, Role.HIDDEN)
    turn = np.degrees(board.gauge(0j * a, -corner / (b - a))) % 360.0
    way = float(nominal(turn))
    board.angle(view, corner, (b - a) / np.abs(b - a), np.radians(way - 360.0 * (way > 180.0)), ARC, TURN.symbol)
    beta = bench.stated(TURN, turn, row_of(sym(TURN.symbol), f" = {number(way, 5)}°"))
    whole = _weight(trial) * (magnitude(symbol, shown.size, device.unit) / moved)
    if trial.r.si != device.correct.r.si:
        whole = whole * (magnitude("r_t", trial.r.si * 1e3, "mm") / magnitude("r_b", device.correct.r.si * 1e3, "mm"))
    bench.worked(weight(""), whole)
    sum_of = magnitude("θ_t", degrees(trial.at.si), "deg") + beta
    at = sum_of.value % 360.0
    text = f" = $θ_t$ + $β$ = {number(degrees(trial.at.si), 5)}° + {number(way, 5)}° = {number(float(nominal(at)), 5)}°"
    bench.stated(bearing(""), at, row_of(sym(bearing("").symbol), text))
    weight_seen(bench, device, float(nominal(at)), weight("").symbol, bearing("").symbol)


def _told(symbol: str, stays: bool) -> Words:
    keeps = Words(
        "试重留在转子上，还须消除 $V_1$。", "The trial weight stays on the rotor; what is left to cancel is $V_1$. "
    )
    gone = Words("试重取下，须消除 $V_0$。", "The trial weight is taken off; what is to be cancelled is $V_0$. ")
    return (keeps if stays else gone) + Words(
        f"校正质量的效应应等于 −${symbol}$：把试重转过自 $V_t$ 到 −${symbol}$ 的角 $β$（转向与相位相同），并按 "
        f"${symbol}$/$V_t$ 放大。",
        f"The effect of the correction must be −${symbol}$: turn the trial weight by the angle $β$ from $V_t$ to "
        f"−${symbol}$, in the sense of the phases, and scale it by ${symbol}$/$V_t$.",
    )
