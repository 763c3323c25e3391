"""The steady motion that a machine settles to, and how it is told: turn after turn, then the fixed point itself."""

from __future__ import annotations

import numpy as np

from ...errors import EquilibriumError
from ...words import Words
from .forward import Moved, Mover, Outcome
from .run import follow

TURNS = 200  # of running in
SETTLED, SECANTS = 1e-11, 12  # of ω: two turns alike


def settled(mover: Mover, phi: float, omega: float) -> Moved:
    """One period of the steady motion, from the same place φ (rad) on; ω: where the running-in begins (rad/s).

    Raises EquilibriumError where the machine stalls, swings to and fro, or never settles.
    """
    period = _turn(mover)
    last = np.nan
    for turn in range(TURNS):
        moved = follow(mover, phi, omega, period)
        if moved.outcome is not Outcome.REACHED:
            raise EquilibriumError(
                _ends(moved, turn, mover.mech.drive.lead), code="not-steady", numbers={"turns": turn}
            )
        last, omega = omega, moved.end[2]
        if abs(omega - last) < 1e-4 * abs(omega):
            break
    else:
        raise EquilibriumError(_runs_away(omega), code="not-steady", numbers={"turns": TURNS, "omega": omega})
    return follow(mover, phi, _fixed(mover, phi, last, omega), period)


def _turn(mover: Mover) -> float:
    """The way of the drive that is a period (rad); where it does not turn right round, a turn that it never makes."""
    return mover.period if mover.range[2] else 2 * np.pi * mover.loads.turns


def _fixed(mover: Mover, phi: float, last: float, omega: float) -> float:
    """The speed with which a period begins as it ends, by secants; last, omega: two turns running, nearly settled."""

    def missed(speed: float) -> float:
        return follow(mover, phi, speed, _turn(mover)).end[2] - speed

    a, b = (last, omega - last), (omega, missed(omega))
    for _ in range(SECANTS):
        if abs(b[1]) <= SETTLED * abs(b[0]) or a[1] == b[1]:
            break
        new = b[0] - b[1] * (b[0] - a[0]) / (b[1] - a[1])
        a, b = b, (new, missed(new))
    return b[0]


def _ends(moved: Moved, turn: int, zero: float) -> Words:
    """zero: the position of the drive of which 0 is told (rad)."""
    t, phi, _ = moved.end
    place = f"{np.degrees(phi - zero):.5g}°"
    return Words(
        f"机器不能达到稳定运转：第 {turn + 1} 转中于 $φ$ = {place} 处停住（t = {t:.4g} s）；请加大驱动力矩、飞轮或"
        "初速度",
        f"the machine does not come to a steady motion: in turn {turn + 1} it stops at φ = {place} (t = {t:.4g} s); "
        "give it a stronger drive, a larger flywheel, or a faster start",
    )


def _runs_away(omega: float) -> Words:
    return Words(
        f"{TURNS} 转后仍未稳定，角速度已达 {omega:.5g} rad/s：驱动力矩不随转速减小，或阻力太小；请写 motor 特性",
        f"after {TURNS} turns it has not settled, and turns at {omega:.5g} rad/s: the drive does not weaken with "
        "speed, or too little resists; write a motor",
    )
