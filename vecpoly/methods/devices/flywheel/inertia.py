"""The flywheel's moment of inertia from ΔW_max, or the δ that there is; the extreme speeds."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import Txt
from ....algebra.quantity import Quantity, magnitude
from ....devices.dynamics import asked
from ....devices.dynamics.flywheel import GRAVITY, Flywheel
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from ..speeds import PI, THIRTY, angular_velocity, turns_a_minute
from .words import ENOUGH, EXTREME, INERTIA_SECTION, SPEED, SPEED_SECTION, UNEVEN, UNEVEN_SECTION

ONE, TWO, FOUR = (Quantity(Txt(f"{value:g}"), value, "") for value in (1.0, 2.0, 4.0))


def mean_speed(bench: Bench, wheel: Flywheel) -> Quantity:
    """ω_m = π n / 30."""
    bench.board.section(SPEED_SECTION)
    bench.board.step(SPEED)
    return angular_velocity(bench.board, "ω_m", wheel.speed)


def moment_of_inertia(bench: Bench, wheel: Flywheel, swing: Quantity, omega: Quantity) -> Quantity | None:
    """J_F where δ is allowed; None where δ was sought."""
    bench.board.section(UNEVEN_SECTION if wheel.delta is None else INERTIA_SECTION)
    wheel_has = None if wheel.J is None else magnitude("J", wheel.J.si, "kg·m^2")
    sought = None if wheel.delta is None else _sought(bench, wheel, swing, omega, wheel_has)
    wanted = sought is not None and nominal(sought.value) > 0
    _unevenness(bench, swing, omega, _all(wheel_has, sought), _allowed(wheel) if wanted else None)
    return sought


def _allowed(wheel: Flywheel) -> Quantity:
    return magnitude("[δ]", wheel.delta.si if wheel.delta else 0.0, "")


def _sought(bench: Bench, wheel: Flywheel, swing: Quantity, omega: Quantity, has: Quantity | None) -> Quantity:
    """J_F = ΔW_max / (ω_m² [δ]) − J, and 0 where that is negative."""
    board, allowed = bench.board, _allowed(wheel)
    board.step(
        Words(
            "由 $ΔW_{max}$ 和许用不均匀系数求所需的转动惯量" + ("，减去已有的 $J$ 即为飞轮的：" if has else "："),
            "From $ΔW_{max}$ and the allowed coefficient follows the moment of inertia"
            + (" that is needed, and less $J$, which is there, that of the flywheel:" if has else ":"),
        )
    )
    wanted = swing / (omega.squared() * allowed)
    if has is None:
        found = bench.worked(asked.J_F, wanted)
        bench.told_otherwise(asked.J_NEED, found)
    else:
        found = bench.worked(asked.J_F, bench.worked(asked.J_NEED, wanted) - has)
    if nominal(found.value) < 0:
        board.remark(ENOUGH)
        found = bench.stated(asked.J_F, np.maximum(found.value, 0.0))
    bench.worked(asked.GD2, FOUR * magnitude("g", GRAVITY, "m/s^2") * found)
    if wheel.shaft is not None:
        other = turns_a_minute("n_2", abs(wheel.shaft.si))
        n = turns_a_minute("n", wheel.speed)
        board.step(
            Words(
                "飞轮装在转速为 $n_2$ 的轴上时，动能不变：",
                "On the shaft of speed $n_2$ the flywheel must have the same energy:",
            )
        )
        bench.worked(asked.J_SHAFT, found * n.squared() / other.squared())
    return found


def _all(has: Quantity | None, found: Quantity | None) -> Quantity:
    """All that turns."""
    if has is None or found is None:
        one = has or found
        assert one is not None
        return one
    return magnitude("J_{Σ}", has.value + found.value, "kg·m^2")


def _unevenness(
    bench: Bench, swing: Quantity, omega: Quantity, whole: Quantity, allowed: Quantity | None = None
) -> None:
    """The extreme speeds at δ; at the allowed one, where the flywheel was made for it."""
    bench.board.step(UNEVEN if allowed is None else EXTREME)
    if allowed is None:
        delta = bench.worked(asked.DELTA, swing / (whole * omega.squared()))
    else:
        delta = bench.told_otherwise(asked.DELTA, allowed)
    for named, sign in ((asked.OMEGA_MAX, 1), (asked.OMEGA_MIN, -1)):
        factor = ONE + delta / TWO if sign > 0 else ONE - delta / TWO
        speed = bench.worked(named, omega * factor)
        turns = asked.N_MAX if sign > 0 else asked.N_MIN
        bench.worked(turns, THIRTY * speed / PI)
