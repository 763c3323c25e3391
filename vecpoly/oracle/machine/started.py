"""What is asked of a motion from a state, by key; how it ended, in words."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import numpy as np

from ...errors import EquilibriumError
from ...mechanism.asked.machine import at_station
from ...mechanism.machine import Machine, Started
from ...mechanism.model import Mechanism
from ...words import Words
from .forward import Moved, Mover, Outcome
from .periodic import settled
from .power import power_flow
from .run import follow


@lru_cache(maxsize=16)
def motion_of(mech: Mechanism, machine: Machine) -> Moved:
    """The motion that the problem is about: from its state on, or one steady period. Raises EquilibriumError."""
    run = machine.started
    assert run is not None
    mover = Mover(mech, machine.loads, run.flywheel)
    if run.turned is None:
        return settled(mover, run.phi, run.omega)
    return follow(mover, run.phi, run.omega, run.turned, run.stations)


def started_values(mech: Mechanism, machine: Machine, keys: Iterable[str]) -> dict[str, float]:
    """Key → value of what is asked; EquilibriumError for a place that is not reached, a period that there is not."""
    run, asked = machine.started, tuple(keys)
    assert run is not None
    moved, mover = motion_of(mech, machine), Mover(mech, machine.loads, run.flywheel)
    (t, phi, omega), (fast, slow) = moved.end, moved.extremes
    mean = (abs(fast[1]) + abs(slow[1])) / 2
    values = {
        "omega_end": omega if moved.outcome is Outcome.REACHED else 0.0,
        "t_end": t,
        "phi_end": float(np.degrees(phi - mech.drive.lead)),
        "alpha_0": mover.acceleration(run.phi, run.omega),
        "T_cycle": t if run.turned is None else moved.period,
        "phi_max": _within(fast[0], mover),
        "phi_min": _within(slow[0], mover),
        "omega_max": fast[1],
        "omega_min": slow[1],
        "delta": (abs(fast[1]) - abs(slow[1])) / mean if mean else np.nan,
    }
    for way, (when, speed) in moved.passed.items():
        values |= {named.key: value for named, value in zip(at_station(way), (speed, when), strict=True)}
    flow = power_flow(mech, machine.loads, run.phi, run.omega, run.flywheel)
    values |= {f"power_{name}": power for name, power in flow.powers.items()}
    values |= {f"dT_{link}": gain for link, gain in flow.gains.items()}
    _refuse_missing(moved, run, values, asked, mech.drive.lead)
    return {key: float(values[key]) for key in asked if key in values}


def _within(phi: float, mover: Mover) -> float:
    """Degrees as the problem tells the drive's angle, within the period, or within a turn where there is none."""
    turn = 360.0 * mover.loads.turns
    return float(np.degrees(phi - mover.mech.drive.lead) % (np.degrees(mover.period) if mover.range[2] else turn))


def _refuse_missing(moved: Moved, run: Started, values: dict[str, float], asked: tuple[str, ...], lead: float) -> None:
    every = {named.key for way in run.stations for named in at_station(way)}
    if lost := [key for key in asked if (key in every and key not in values) or np.isnan(values.get(key, 0.0))]:
        raise EquilibriumError(
            Words(f"{lost[0]} 不存在：", f"there is no {lost[0]}: ") + ending(moved, lead), code="not-reached"
        )


def ending(moved: Moved, lead: float = 0.0) -> Words:
    """How the motion ended: a stall is an answer. lead: of the drive's angle beside what is told of it (rad)."""
    t, phi, omega = moved.end
    place, when = f"{np.degrees(phi - lead):.5g}°", f"{t:.5g} s"
    match moved.outcome:
        case Outcome.REACHED:
            return Words(
                f"机器运转至 φ = {place}，历时 {when}，此时 ω = {omega:.5g} rad/s",
                f"the machine gets to φ = {place} after {when}, with ω = {omega:.5g} rad/s",
            )
        case Outcome.STALLED:
            return Words(f"机器于 φ = {place} 处停住（t = {when}）", f"the machine stalls at φ = {place} (t = {when})")
        case Outcome.OSCILLATES:
            ends = " ... ".join(f"{np.degrees(spot - lead):.5g}°" for _, spot in moved.turned[-2:])
            return Words(
                f"机器在 {ends} 之间往复摆动，周期 {moved.period:.5g} s",
                f"the machine swings to and fro between {ends}, with a period of {moved.period:.5g} s",
            )
