"""Flywheels that cannot be: a speed that does not vary, a machine that stops on the way, a rim with no room inside; and
extreme speeds that stand at several places."""

from __future__ import annotations

from collections.abc import Collection
from math import pi

from ...errors import FaultError
from ...units.reading import Quantity
from ...words import Words
from .asked import PHI_MAX, PHI_MIN, letter
from .given import Areas, Torques
from .lobes import levels
from .rim import Rim

EVEN = 1e-9  # of the work of the largest moment over the period: what is rounded, and no fluctuation
ALIKE = 1e-6  # of ΔW_max: by how much two energies may differ that are one
STOPS = 2.0  # δ with which ω_min = ω_m (1 − δ/2) is nothing


def check_it_varies(load: Torques | Areas) -> None:
    """FaultError where what drives is everywhere what is overcome."""
    if isinstance(load, Torques) and load.swing <= EVEN * max(map(abs, load.highest)) * load.period:
        raise FaultError(
            Words(
                "驱动力矩处处等于阻力矩，速度没有波动，不需要飞轮；M_d、M_r（或功率）中至少一个应随转角变化，"
                "如 [[0 deg, 0 N*m], [180 deg, 90 N*m]]",
                "what drives is everywhere what is overcome: the speed does not vary and no flywheel is needed; M_d or "
                "M_r (or the powers) must change with the angle, e.g. [[0 deg, 0 N*m], [180 deg, 90 N*m]]",
            ),
            code="contradiction",
            keys=("M_d", "M_r", "powers"),
        )


def check_it_goes_on(swing: float, inertia: Quantity, speed: float) -> None:
    """FaultError where the inertia that is given does not carry the machine over its deficit."""
    least = swing / (STOPS * speed**2)
    if inertia.si > least:
        return
    delta = swing / (inertia.si * speed**2)
    raise FaultError(
        Words(
            f"J = {inertia.text} 储存的动能不足以渡过亏功段：δ = ΔW_max/(J ω_m²) = {delta:.4g} 不小于 2，"
            f"ω_min 将不大于零，机器会停住；J 应大于 {least:.4g} kg·m²",
            f"J = {inertia.text} stores too little energy for the deficit: δ = ΔW_max/(J ω_m²) = {delta:.4g} is not "
            f"below 2, ω_min would not be above zero and the machine stops; J must exceed {least:.4g} kg·m²",
        ),
        "J",
        code="out-of-range",
        numbers={"delta": delta, "J": least},
    )


def check_it_has_room(rim: Rim, inertia: float) -> None:
    """FaultError where the rim with this moment of inertia is no thinner than its mean diameter."""
    least = (4 * max(inertia, 0.0) / (pi * rim.density.si * rim.ratio.si)) ** 0.2
    if rim.D.si > least:
        return
    raise FaultError(
        Words(
            f"D = {rim.D.text}：按 J_F = {inertia:.4g} kg·m²，轮缘厚度 h 将不小于平均直径 D，做不成轮缘；"
            f"D 应大于 {1e3 * least:.4g} mm（通常大得多），或放宽 δ",
            f"D = {rim.D.text}: with J_F = {inertia:.4g} kg·m² the rim would be no thinner than its mean diameter, "
            f"no rim at all; D must exceed {1e3 * least:.4g} mm (by far, as a rule), or delta be larger",
        ),
        "rim",
        code="out-of-range",
        numbers={"D": least},
    )


def ties(load: Torques, asked: Collection[str]) -> tuple[Words, ...]:
    """What is told where the energy is greatest, or least, at several places of the period: one of them is answered."""
    at_each = levels(load.works)[:-1]
    told = []
    for one, end, zh, en in ((PHI_MAX, max(at_each), "大", "greatest"), (PHI_MIN, min(at_each), "小", "least")):
        there = [letter(n) for n, level in enumerate(at_each) if abs(level - end) <= ALIKE * load.swing]
        if one.key in asked and len(there) > 1:
            told.append(
                Words(
                    f"角速度在 {'、'.join(there)} 各处同为最{zh}；{one.key} 答其中第一处",
                    f"the speed is {en} at {', '.join(there)} alike; {one.key} tells the first of them",
                )
            )
    return tuple(told)
