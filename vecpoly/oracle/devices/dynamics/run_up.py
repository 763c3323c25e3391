"""Exact run-up and run-down: scipy finds the steady speed, integrates 1/ΔM and ω/ΔM, and follows the speed in time."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, tau
from typing import assert_never

import numpy as np

from ....devices.dynamics import run_up as asked
from ....devices.dynamics.characteristic import Characteristic, Kloss, Measured, Polynomial, highest
from ....devices.dynamics.run_up import RunUp
from ....errors import NotAskedError
from ....words import Words
from ..registry import Values, answers

Moment = Callable[[float], float]
TRIED, FAR = 4000, 1e4  # places in which the steady speed is looked for; rad/s beyond which there is none


@answers(RunUp)
def run_up(device: RunUp) -> Values:
    """Everything that may be asked."""
    load = _moment(device.load)
    if device.motor is None:
        return _down(device, load)
    motor = _moment(device.motor)

    def surplus(omega: float) -> float:
        return motor(omega) - load(omega)

    found: dict[str, complex | float] = {asked.START.key: motor(0.0)}
    goal = device.goal
    if goal is None:
        steady = _steady(device, surplus)
        goal = device.share * steady
        found[asked.STEADY.key] = steady
        if device.linear:
            found[asked.CONSTANT.key] = device.J.si / (surplus(0.0) - surplus(1.0))
    _refuse_slow(surplus, device.start.si, goal)
    time, angle = _integrals(device, surplus, device.start.si, goal)
    found |= {asked.TIME.key: time, asked.TURNS.key: angle / tau}
    if device.at is not None:
        found[asked.THEN.key] = _after(device, surplus, device.at.si)
    return found


def _down(device: RunUp, load: Moment) -> Values:
    _refuse_idle(device, load)
    time, angle = _integrals(device, load, device.end, device.start.si)
    found: dict[str, complex | float] = {asked.TIME.key: time, asked.TURNS.key: angle / tau}
    if device.brake is not None:
        brake = device.brake.si
        time, angle = _integrals(device, lambda omega: load(omega) + brake, device.end, device.start.si)
        found |= {asked.TIME_BRAKED.key: time, asked.TURNS_BRAKED.key: angle / tau}
    return found


def _refuse_idle(device: RunUp, load: Moment) -> None:
    """Raise NotAskedError where nothing slows the machine down at a speed on its way."""
    low, high = device.end, device.start.si
    tried = {*np.linspace(low, high, TRIED).tolist(), *(one for one in _corners(device.load) if low <= one <= high)}
    idle = max((one for one in tried if load(one) <= 0), default=None)
    if idle is not None:
        raise NotAskedError(
            Words(
                f"在 {idle:.6g} rad/s 处阻力矩为 {load(idle):.4g} N·m，转速降不到该值以下；"
                "请用 to 给出更高的终了转速，或改 load",
                f"at {idle:.6g} rad/s {load(idle):.4g} N·m resist: the speed never falls below that; let the run end "
                "above it (to), or change the load",
            ),
            code="never-stops",
            numbers={"omega": idle, "M_r": load(idle)},
        )


def _integrals(device: RunUp, surplus: Moment, low: float, high: float) -> tuple[float, float]:
    """The time (s) and the angle (rad) from one speed to the other."""
    from scipy.integrate import quad

    corners = sorted({one for curve in (device.motor, device.load) for one in _corners(curve) if low < one < high})
    inertia, time, angle = device.J.si, 0.0, 0.0
    for a, b in zip([low, *corners], [*corners, high], strict=True):
        time += quad(lambda w: inertia / surplus(w), a, b, epsabs=0, epsrel=1e-12, limit=400)[0]
        angle += quad(lambda w: inertia * w / surplus(w), a, b, epsabs=0, epsrel=1e-12, limit=400)[0]
    return time, angle


def _after(device: RunUp, surplus: Moment, time: float) -> float:
    """ω after a time, by the differential equation."""
    from scipy.integrate import solve_ivp

    run = solve_ivp(
        lambda t, w: [surplus(float(w[0])) / device.J.si],
        (0.0, time),
        [device.start.si],
        method="DOP853",
        rtol=1e-12,
        atol=1e-12,
        max_step=time / 100,
    )
    return float(run.y[0, -1])


def _steady(device: RunUp, surplus: Moment) -> float:
    """The first speed above the start at which the moments are equal."""
    from scipy.optimize import brentq

    if (left := surplus(device.start.si)) <= 0:
        raise _slows_down(device.start.si, left)
    most = min(highest(curve) for curve in (device.motor, device.load) if curve is not None)
    bound = most if np.isfinite(most) else _bound(surplus, device.start.si)
    tried = np.linspace(device.start.si, bound, TRIED)
    above = np.array([surplus(float(w)) > 0 for w in tried])
    turned = np.flatnonzero(above[:-1] & ~above[1:])
    if not turned.size:
        raise _no_steady(bound)
    at = int(turned[0])
    return float(brentq(surplus, tried[at], tried[at + 1], xtol=1e-13, rtol=4 * np.finfo(float).eps))


def _bound(surplus: Moment, start: float) -> float:
    """A speed at which the load is greater."""
    bound = max(2 * start, 1.0)
    while surplus(bound) > 0 and bound < FAR:
        bound *= 2
    return bound


def _slows_down(start: float, left: float) -> NotAskedError:
    return NotAskedError(
        Words(
            f"在 start = {start:.6g} rad/s 处驱动力矩比阻力矩小 {-left:.4g} N·m，机器降速而不是起动；"
            "start 应低于稳定转速",
            f"at the start, {start:.6g} rad/s, the driving moment is {-left:.4g} N·m less than that of the load: the "
            "machine slows down and this is no run-up; start below the steady speed",
        ),
        code="no-steady",
        numbers={"omega": start, "M": left},
    )


def _no_steady(bound: float) -> NotAskedError:
    return NotAskedError(
        Words(
            f"直到 {bound:.4g} rad/s（{bound * 30 / pi:.4g} r/min）驱动力矩始终大于阻力矩，没有稳定转速；"
            "请用 to 给出终了转速",
            f"up to {bound:.4g} rad/s ({bound * 30 / pi:.4g} r/min) the driving moment is the greater: there is no "
            "steady speed; say by 'to' where the run-up ends",
        ),
        code="no-steady",
        numbers={"omega": bound},
    )


def _refuse_slow(surplus: Moment, start: float, goal: float) -> None:
    """Raise NotAskedError where the run-up ends before its goal, or has it behind."""
    if goal <= start:
        raise NotAskedError(
            Words(
                f"终了转速 {goal:.6g} rad/s 不高于初速度 {start:.6g} rad/s；请加大 to 或减小 start",
                f"the run-up begins at {start:.6g} rad/s, which is not below its end, {goal:.6g} rad/s; let it end "
                "higher (to), or start lower",
            ),
            code="out-of-range",
            numbers={"start": start, "goal": goal},
        )
    low = next((float(w) for w in np.linspace(start, goal, TRIED) if surplus(float(w)) <= 0), None)
    if low is not None:
        raise NotAskedError(
            Words(
                f"由 {start:.6g} rad/s 起动达不到 {goal:.6g} rad/s：在 {low:.6g} rad/s 处驱动力矩不大于阻力矩",
                f"from {start:.6g} rad/s it never comes to {goal:.6g} rad/s: at {low:.6g} rad/s the driving moment "
                "does not exceed that of the load",
            ),
            code="out-of-range",
            numbers={"start": start, "goal": goal, "at": low},
        )


def _corners(curve: Characteristic | None) -> tuple[float, ...]:
    return curve.speeds if isinstance(curve, Measured) else ()


def _moment(curve: Characteristic | None) -> Moment:
    match curve:
        case None:
            return lambda omega: 0.0
        case Polynomial(terms=terms):
            return lambda omega: float(np.polyval(terms[::-1], omega))
        case Kloss(greatest=greatest, slip=slip, synchronous=speed):
            return lambda omega: 2 * greatest * slip * (1 - omega / speed) / ((1 - omega / speed) ** 2 + slip**2)
        case Measured(speeds=speeds, sizes=sizes):
            return lambda omega: float(np.interp(omega, speeds, sizes))
        case _:
            assert_never(curve)
