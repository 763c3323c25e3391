"""The section on the flywheel: by areas, exact by the two tangents, and tried out by the true motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....algebra.quantity import magnitude, number
from ....algebra.worked import figures_for
from ....findings.machine.running import Confirmed, Evenness, Running, Tangents
from ....findings.study.study import Study
from ....mechanism.machine import Steady
from ....words import Words
from ..numbering import Press
from ..results.plots import Plotted, given
from .work import of_period, where

_HEADER = {
    "zh": ["方法", "算式", "$J_F$ /(kg·m²)", "与精确值之差"],
    "en": ["Method", "Formula", "$J_F$ /(kg·m²)", "Off by"],
}


def flywheel(study: Study, press: Press, run: Running) -> dict[str, Any]:
    """Words, the two flywheels side by side, the speed of the true motion."""
    assert run.found is not None and run.steady is not None
    needed = run.cuts is not None and run.found.flywheel > 0
    told = [_needed(study, run, run.cuts) if needed and run.cuts is not None else _given(study, run)]
    told += [_tried(run, run.trial, run.found)] if run.trial is not None else []
    return {
        "title": Words("飞轮的转动惯量", "The flywheel").of(press.lang),
        "words": [w.of(press.lang) for w in told],
        "tables": [_table(press, run, run.cuts)] if needed and run.cuts is not None else [],
        "figures": press.figures([speed(study, press.lang, run)]) if run.trial is not None else [],
    }


def _needed(study: Study, run: Running, cuts: Tangents) -> Words:
    steady = run.steady
    assert steady is not None and steady.delta is not None
    upper, lower = (where(study, run, top.psi) for top in (cuts.upper, cuts.lower))
    opening = (number(steady.speed, 5), number(steady.delta, 4))
    return Words(
        f"平均角速度 $ω_m$ = {opening[0]} rad/s，许用不均匀系数 [$δ$] = {opening[1]}。略去 $J_e$ 的变化时 $J_F$ = "
        f"$ΔW_{{max}}$/($ω_m^2$[$δ$])；计及 $J_e$ 的变化时，在能量–质量图上作斜率为 $ω_{{max}}^2$/2 = "
        f"{number(cuts.steep, 5)} 和 $ω_{{min}}^2$/2 = {number(cuts.flat, 5)} 的两条切线，切点在 {upper} 和 {lower}，"
        f"两切线在 $E$ 轴上的截距之差除以 $ω_m^2$[$δ$] 即为 $J_F$ 的精确值。",
        f"The mean speed is $ω_m$ = {opening[0]} rad/s, the coefficient of speed fluctuation "
        f"allowed [$δ$] = {opening[1]}. With the changes "
        "of $J_e$ left "
        f"out $J_F$ = $ΔW_{{max}}$/($ω_m^2$[$δ$]). With them, two tangents are laid on the loop of $E$ versus $J_e$, "
        "with the slopes "
        f"$ω_{{max}}^2$/2 = {number(cuts.steep, 5)} and $ω_{{min}}^2$/2 = {number(cuts.flat, 5)}; they touch it at "
        f"{upper} and {lower}, "
        "and what they cut off the $E$ axis, divided by $ω_m^2$[$δ$], is $J_F$ exactly (Wittenbauer).",
    )


def _given(study: Study, run: Running) -> Words:
    """A flywheel that is there, or none needed."""
    found = run.found
    assert found is not None
    fast, slow = (where(study, run, top.psi) for top in (found.fastest, found.slowest))
    wheel, delta = number(found.flywheel, 4), number(found.delta, 4)
    speeds = tuple(number(top.value, 5) for top in (found.fastest, found.slowest))
    opening = (
        Words("不加飞轮即已满足要求。", "No flywheel is needed. ")
        if run.steady is not None and run.steady.delta is not None
        else Words(f"已有飞轮 $J_F$ = {wheel} kg·m²。", f"The flywheel that is there has $J_F$ = {wheel} kg·m². ")
    )
    return opening + Words(
        f"$ω_{{max}}$ = {speeds[0]} rad/s（{fast}），$ω_{{min}}$ = {speeds[1]} rad/s（{slow}），不均匀系数 $δ$ = "
        f"{delta}。",
        f"$ω_{{max}}$ = {speeds[0]} rad/s ({fast}), $ω_{{min}}$ = {speeds[1]} rad/s ({slow}): the coefficient of speed "
        f"fluctuation is $δ$ = "
        f"{delta}.",
    )


def _tried(run: Running, trial: Confirmed, found: Evenness) -> Words:
    off = number(abs(trial.delta - found.delta), 2)
    missed = number(abs(trial.missed), 2)
    return Words(
        f"校核：装上此飞轮，由最快位置以 $ω_{{max}}$ 开始，数值积分运动方程 $J$ d$ω$/d$t$ + ½$ω^2$ d$J$/d$φ$ = $M$ 一"
        "个周期，"
        f"得 $δ$ = {number(trial.delta, 6)}，与上面由能量求得的相差 {off}；周期末的角速度与开始时相差 $ω_m$ 的 "
        f"{missed}。",
        "Tried out: with this flywheel the equation of motion $J$ d$ω$/d$t$ + ½$ω^2$ d$J$/d$φ$ = $M$ is integrated "
        "over a period from "
        f"the fastest place on. It gives $δ$ = {number(trial.delta, 6)}, which is {off} off what follows from the "
        "energies above; "
        f"the speed at the end of the period is off that at its beginning by {missed} of $ω_m$.",
    )


def _divided(works: Sequence[float], steady: Steady) -> list[str]:
    """What each J_F is worked out from, all with the figures that one of them needs: 1234.5 / (12.566² × 0.05)."""
    digits = max(_digits(work, steady) for work in works)
    below = f"({number(steady.speed, digits)}² × {number(steady.delta or 0.0, digits)})"
    return [f"{number(work, digits)} / {below}" for work in works]


def _digits(work: float, steady: Steady) -> int:
    speed, delta = magnitude("ω_m", steady.speed, "rad/s"), magnitude("δ", steady.delta or 0.0, "")
    expr = magnitude("W", work, "J") / (speed.squared() * delta)
    return figures_for(expr, number(float(np.asarray(expr.value)), 5), 5)


def _table(press: Press, run: Running, cuts: Tangents) -> str:
    assert run.found is not None and run.steady is not None and run.by_areas is not None
    exact, steady = run.found.flywheel, run.steady
    calculations = _divided((run.surplus, cuts.cut), steady)
    rows = [
        (
            Words("按最大盈亏功（近似）", "by areas (approximate)").of(press.lang),
            calculations[0],
            number(run.by_areas, 5),
            f"{100 * (run.by_areas / exact - 1):+.2f} %".replace("-", "−"),
        ),
        (
            Words("按能量–质量图（精确）", "by Wittenbauer's tangents (exact)").of(press.lang),
            calculations[1],
            number(exact, 5),
            "—",
        ),
    ]
    return press.table(Words("飞轮的转动惯量", "Moment of inertia of the flywheel"), _HEADER[press.lang], rows, "lcrr")


def speed(study: Study, lang: str, run: Running) -> Plotted:
    """The speed over the input link's angle, all through the period, its ends included."""
    assert run.steady is not None and run.found is not None
    top, low = run.found.fastest, run.found.slowest
    marks = tuple((run.of.degrees(one.psi), abs(one.value)) for one in (top, low))
    link = run.mech.number(run.mech.drive.link)
    title = Words(f"装飞轮后的 $ω_{link}$（虚线为平均值）", f"$ω_{link}$ with the flywheel (dashed: mean)")
    angle, at = of_period(run)
    line = (angle, _speeds(run, run.found, at))
    return given(study, lang, line, (f"ω_{{{link}}}", "rad/s"), title, marks=marks, level=run.steady.speed)


def _speeds(run: Running, found: Evenness, at: NDArray[np.float64]) -> NDArray[np.float64]:
    """The speed at places of every piece: ½ (J_e + J_F) ω² has grown by the work done since the fastest place."""
    of, top = run.of, np.array([found.fastest.psi])
    first, height = (float(of.at(rows, top)[0]) for rows in (of.inertias, of.works))
    energy = (first + found.flywheel) * found.fastest.value**2 / 2 + of.of_pieces(of.works, at).ravel() - height
    return np.asarray(np.sqrt(2 * energy / (of.of_pieces(of.inertias, at).ravel() + found.flywheel)), np.float64)
