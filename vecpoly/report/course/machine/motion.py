"""The chapter on the machine's motion: equivalents, work over the period, the flywheel, the powers."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....algebra.quantity import number
from ....findings.machine.running import Running
from ....findings.shown import places
from ....findings.study.study import Study
from ....mechanism.asked.forces import load_symbol
from ....mechanism.asked.machine import Equivalent, equivalents
from ....words import Words
from ..numbering import Press
from ..results.plots import curve
from ..results.tabled import halved, tabled
from .flywheel import flywheel
from .powers import powers
from .sums import displayed, equivalents_of
from .work import work

_NOTHING = 1e-9  # of the greatest inertia: none


def sections(study: Study, press: Press, run: Running) -> list[dict[str, Any]]:
    """Each with its words, tables and figures."""
    parts = [_equivalent(study, press, run), work(study, press, run)]
    if run.found is not None:
        parts.append(flywheel(study, press, run))
    if run.trial is not None:
        parts.append(powers(study, press, run))
    return parts


def _equivalent(study: Study, press: Press, run: Running) -> dict[str, Any]:
    """J_e and M_e of the given loads, in a table and two curves."""
    to = equivalents(study.mech)[0]
    link = run.mech.number(to.link)
    keys = [key for key in (to.inertia.key, to.load.key) if study.varies(key)]
    every = 2 if run.of.period > 2 * np.pi * 1.5 else 1
    half = halved(study, keys, every) if keys else Words("", "")
    title = Words("等效转动惯量和等效力矩", "Equivalent inertia and moment")
    plots = [curve(study, press.lang, [key]) for key in keys]
    return {
        "title": title.of(press.lang),
        "lead": _lead(link).of(press.lang),
        "formulas": displayed(press, equivalents_of(link)),
        "words": [_said(run, link).of(press.lang), *([(_range(study, to) + half).of(press.lang)] if keys else [])],
        "tables": [tabled(study, press, keys, title, every=every)] if keys else [],
        "figures": press.figures(plots),
    }


def _lead(link: int | str) -> Words:
    """What the formulas that follow are taken from."""
    return Words(
        f"取构件 {link} 为等效构件。由动能相等、功率相等，得等效转动惯量和等效力矩：",
        f"Link {link} is the equivalent link. From equal energy and equal power its equivalent inertia and moment are:",
    )


def _said(run: Running, link: int | str) -> Words:
    """What does not enter, and the sign of M_e."""
    less = (
        Words(f"；${load_symbol(run.name)}$ 不计在内", f", without ${load_symbol(run.name)}$")
        if run.name
        else Words.same("")
    )
    return Words(
        f"式中只含速度比，与 $ω_{link}$ 的大小无关。$M_e$ 以逆时针为正{less.zh}。",
        f"Only ratios of velocities enter, whatever $ω_{link}$ is. $M_e$ is positive counter-clockwise{less.en}.",
    )


def _range(study: Study, to: Equivalent) -> Words:
    """Between what values J_e lies, and where."""
    found = study.extremes(to.inertia.key)
    if found.highest is None or found.lowest is None:
        return Words.same("")
    small = _NOTHING * found.highest.value
    (a, p), (b, q) = (
        (number(0.0 if spot.value < small else spot.value), places(study, found, spot))
        for spot in (found.lowest, found.highest)
    )
    return Words(
        f"$J_e$ 在 {a} kg·m²（{p.zh}）与 {b} kg·m²（{q.zh}）之间变化。",
        f"$J_e$ lies between {a} kg·m² ({p.en}) and {b} kg·m² ({q.en}).",
    )


def conclusion(study: Study, run: Running) -> list[Words]:
    """ΔW_max, and the flywheel; nothing where both are asked, and told as such."""
    asked = {ask.rel.key for ask in study.given.problem.asks}
    if "dW_max" in asked and (run.found is None or not asked.isdisjoint({"J_F", "J_F_areas"})):
        return []
    work_ = number(run.surplus, 4)
    if run.found is None or run.steady is None or run.steady.delta is None or run.by_areas is None:
        return [Words(f"最大盈亏功 $ΔW_{{max}}$ = {work_} J。", f"The maximum surplus of work is {work_} J.")]
    a, b, delta = number(run.by_areas, 4), number(run.found.flywheel, 4), number(run.steady.delta, 4)
    return [
        Words(
            f"最大盈亏功 $ΔW_{{max}}$ = {work_} J；要使 $δ$ ≤ {delta}，飞轮的转动惯量按最大盈亏功近似为 {a} kg·m²，"
            f"精确值为 {b} kg·m²。",
            f"The maximum surplus of work is {work_} J; $δ$ ≤ {delta} needs a flywheel of {b} kg·m² ({a} kg·m² by "
            "areas alone).",
        )
    ]
