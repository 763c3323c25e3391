"""Steady motion: the greatest surplus of work, the flywheel, the fastest and the slowest place.

T = ½ (J_F + J_e) ω². With a given δ the flywheel is exact (Wittenbauer): of all places the highest of E − ½ J_e ω_max²
and the lowest of E − ½ J_e ω_min² tell J_F = (a − b) / (δ ω_m²). With a given flywheel the mean energy is found by
which (ω_max + ω_min) / 2 = ω_m.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ...errors import EquilibriumError
from ...foundation.slotted import replace
from ...mechanism.asked.machine import PHI_MAX, PHI_MIN, equally
from ...mechanism.machine import Machine, Steady, flywheel_of
from ...mechanism.model import Mechanism
from ...words import Words
from ..state import Reals
from .course import Course, course
from .extremes import Top, highest, lowest

ROUNDS, CLOSE = 60, 1e-13  # of the mean speed
EVEN = 1e-9  # of the energies of a period: a change that is rounding


@dataclass(frozen=True, slots=True, kw_only=True)
class Evenness:
    """What is known of a steady motion: fastest and slowest place (ψ, ω), δ, the flywheel J_F (kg·m²)."""

    fastest: Top
    slowest: Top
    delta: float
    flywheel: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Tangents:
    """Wittenbauer's tangents on the E–J_e loop: slopes ½ ω² (J/(kg·m²)), where each cuts the axis J_e = 0 (J), and the
    places that they touch."""

    steep: float
    flat: float
    upper: Top
    lower: Top

    @property
    def cut(self) -> float:
        """a − b (J)."""
        return self.upper.value - self.lower.value


def surplus(of: Course) -> tuple[Top, Top]:
    """The highest and the lowest point of the work ∫ M dψ: between them is ΔW_max (J)."""
    return (highest(of, lambda e, j: e, lambda e, j, m, r: m), lowest(of, lambda e, j: e, lambda e, j, m, r: m))


def tangents(of: Course, speed: float, delta: float) -> Tangents:
    """The two tangents for this mean speed and unevenness."""
    steep, flat = (speed**2 * (1 + sign * delta / 2) ** 2 / 2 for sign in (1, -1))
    return Tangents(
        steep=steep,
        flat=flat,
        upper=highest(of, lambda e, j: e - steep * j, lambda e, j, m, r: m - steep * r),
        lower=lowest(of, lambda e, j: e - flat * j, lambda e, j, m, r: m - flat * r),
    )


def evenness(of: Course, run: Steady) -> Evenness:
    """The motion as even as is allowed, or as the flywheel that is there makes it (none where nothing is said)."""
    if run.delta is None:
        return with_flywheel(of, run.speed, run.flywheel or 0.0)
    found = tangents(of, run.speed, run.delta)
    wheel = flywheel_of(found.cut, run.speed, run.delta)
    if wheel <= 0:
        return with_flywheel(of, run.speed, 0.0)
    top, low = (run.speed * (1 + sign * run.delta / 2) for sign in (1, -1))
    return Evenness(
        fastest=replace(found.upper, value=top),
        slowest=replace(found.lower, value=low),
        delta=run.delta,
        flywheel=wheel,
    )


def with_flywheel(of: Course, speed: float, wheel: float) -> Evenness:
    """The steady motion with this flywheel; EquilibriumError where the machine would stand still on its way."""
    least = -surplus(of)[1].value  # so much energy at the beginning leaves none at the lowest point
    top, low = surplus(of)
    scale = max(top.value - low.value, 1e-300)

    def middle(energy: float) -> float:
        fast, slow = _speeds(of, energy, wheel)
        return (fast.value + slow.value) / 2 - speed

    start = least + 1e-12 * scale
    if middle(start) > 0:
        raise EquilibriumError(
            Words(
                f"平均角速度 {speed:.5g} rad/s 太低，飞轮 J_F = {wheel:.5g} kg·m² 储存的动能不足以渡过亏功段："
                "机器会在途中停住；请加大飞轮或转速",
                f"at a mean speed of {speed:.5g} rad/s a flywheel of J_F = {wheel:.5g} kg·m² does not store what the "
                "deficit takes: the machine stops on its way; give it a larger flywheel, or a higher speed",
            ),
            code="stalls",
            numbers={"omega_m": speed, "J_F": wheel},
        )
    far = start + scale
    while middle(far) < 0:
        far = least + 2 * (far - least)
    energy = _root(middle, start, far, CLOSE * speed)
    fast, slow = _speeds(of, energy, wheel)
    return Evenness(fastest=fast, slowest=slow, delta=(fast.value - slow.value) / speed, flywheel=wheel)


def _root(miss: Callable[[float], float], low: float, high: float, close: float) -> float:
    """The root of a rising function by false position, the stale end halved; close: a miss that is rounding."""
    (a, fa), (b, fb) = (low, miss(low)), (high, miss(high))
    for _ in range(ROUNDS):
        if abs(fb) <= close or fa == fb:
            break
        x = (a * fb - b * fa) / (fb - fa)
        y = miss(x)
        a, fa = (b, fb) if y * fb < 0 else (a, fa / 2)
        b, fb = x, y
    return b


def _speeds(of: Course, energy: float, wheel: float) -> tuple[Top, Top]:
    """The fastest and the slowest place where the period begins with this kinetic energy: ω² = 2 (T_0 + E) / J."""

    def square(e: Reals, j: Reals) -> Reals:
        return 2 * (energy + e) / (wheel + j)

    def slope(e: Reals, j: Reals, m: Reals, r: Reals) -> Reals:
        return m * (wheel + j) - (energy + e) * r

    fast, slow = highest(of, square, slope), lowest(of, square, slope)
    return replace(fast, value=float(np.sqrt(fast.value))), replace(slow, value=float(np.sqrt(max(slow.value, 0.0))))


@lru_cache(maxsize=32)
def _found(mech: Mechanism, machine: Machine) -> tuple[Course, Evenness]:
    """A period of the machine, and how evenly it runs."""
    assert machine.steady is not None
    of = course(mech, machine.loads)
    top, low = surplus(of)
    _refuse_even(of, top.value - low.value, machine.steady.speed)
    return of, evenness(of, machine.steady)


def one_place(mech: Mechanism, machine: Machine, asked: Collection[str]) -> None:
    """EquilibriumError where it is asked at which place the machine is fastest or slowest, and two places are."""
    of, found = _found(mech, machine)
    for key, top in ((PHI_MAX.key, found.fastest), (PHI_MIN.key, found.slowest)):
        if key in asked and top.rival is not None:
            raise equally(key, *sorted((_told(mech, of, top.psi), _told(mech, of, top.rival))))


@lru_cache(maxsize=32)
def steady_values(mech: Mechanism, machine: Machine) -> dict[str, float]:
    """Every quantity of `asked.machine.STEADY` by its key; J_F is 0 where the machine is even enough without."""
    run = machine.steady
    assert run is not None
    of, found = _found(mech, machine)
    top, low = surplus(of)
    values = {
        "dW_max": top.value - low.value,
        "J_F": found.flywheel,
        PHI_MAX.key: _told(mech, of, found.fastest.psi),
        PHI_MIN.key: _told(mech, of, found.slowest.psi),
        "omega_max": found.fastest.value,
        "omega_min": found.slowest.value,
        "delta": found.delta,
    }
    if run.delta is not None:
        values["J_F_areas"] = flywheel_of(top.value - low.value, run.speed, run.delta)
    return values


def _told(mech: Mechanism, of: Course, psi: float) -> float:
    """The drive's angle there as the problem tells it (deg), within the period."""
    return float((of.degrees(psi) - np.degrees(mech.drive.lead)) % np.degrees(of.period))


def _refuse_even(of: Course, swing: float, speed: float) -> None:
    """EquilibriumError where neither the work nor the inertia changes over the period, but by rounding."""
    mean, most = of.inertias[:, 0], float(np.max(np.abs(of.inertias[:, 0])))
    varies = max(float(np.ptp(mean)), float(np.max(np.abs(of.inertias[:, 1:]), initial=0.0)))
    whole = max(abs(of.constant) * of.period, most * speed**2 / 2)
    if varies > EVEN * most or swing > EVEN * whole:
        return
    raise EquilibriumError(
        Words(
            "驱动与阻力处处平衡，等效转动惯量也不变：速度没有波动，没有最快和最慢的位置，也不需要飞轮；请只求常数力矩",
            "what drives is everywhere what resists, and the equivalent inertia does not change: the speed is even, no "
            "place is the fastest or the slowest and no flywheel is needed; ask for the constant moment alone",
        ),
        code="even",
    )
