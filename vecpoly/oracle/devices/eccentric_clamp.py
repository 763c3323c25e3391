"""Exact answers for an eccentric clamp:
Newton on the three equations of equilibrium with the pin's friction couple, bisection for e."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ...devices.eccentric_clamp import EccentricClamp
from ...errors import LockedError
from ...words import Words
from .registry import Values, answers
from .sliding import boundary

Vector = npt.NDArray[np.float64]


@answers(EccentricClamp)
def eccentric_clamp(device: EccentricClamp) -> Values:
    """Reactions as vectors (N), the force on the handle, efficiency, arm of R_21 with F removed (m), limit of e (m)."""
    turn, f = device.turn, device.f.si
    force, r31 = _equilibrium(device, f, device.radius)
    ideal, _ = _equilibrium(device, 0.0, 0.0)
    arm = _arm(device, device.e.si)
    values: dict[str, complex | float] = {
        "phi": float(np.degrees(np.arctan(f))),
        "R_21": _press(device, f),
        "F": force,
        "R_31": r31,
        "F_0": ideal,
        "eta": ideal / force,
        "h": arm,
        "self_locking": float(arm <= device.radius * (1 + 1e-12)),
    }
    return values | ({"e_limit": _limit(device)} if device.limited and turn else {})


def _press(device: EccentricClamp, f: float) -> complex:
    """What the work does on the disc while the clamp closes:
    Q up, f Q against the sliding of the disc's lowest point."""
    return device.Q.si * complex(-device.turn * f, 1.0)


def _contact(device: EccentricClamp, e: float) -> complex:
    return e * complex(np.cos(device.theta.si), np.sin(device.theta.si)) - 1j * device.R.si


def _equilibrium(device: EccentricClamp, f: float, rho: float) -> tuple[float, complex]:
    """F and R_31 from two components and the moments about A, with the friction couple ρ |R_31| against the turning."""
    press, pull = _press(device, f), complex(np.cos(device.F.si), np.sin(device.F.si))
    lever = device.lever.si
    turning = (np.conj(lever * np.exp(1j * device.handle.si)) * pull).imag
    resisting = (np.conj(_contact(device, device.e.si)) * press).imag

    def excess(x: Vector) -> Vector:
        size = np.hypot(x[1], x[2])
        return np.array(
            [
                x[0] * pull.real + press.real + x[1],
                x[0] * pull.imag + press.imag + x[2],
                (x[0] * turning + resisting - device.turn * rho * size) / lever,
            ]
        )

    x = np.array([device.Q.si, -press.real, -press.imag])
    for _ in range(60):
        size = np.hypot(x[1], x[2])
        rub = -device.turn * rho / (lever * size)
        slope = np.array([[pull.real, 1.0, 0.0], [pull.imag, 0.0, 1.0], [turning / lever, rub * x[1], rub * x[2]]])
        step = np.linalg.solve(slope, excess(x))
        x = x - step
        if np.abs(step).max() < 1e-13 * device.Q.si:
            break
    if x[0] <= 0 or np.abs(excess(x)).max() > 1e-9 * device.Q.si:
        raise LockedError(
            Words(
                f"手柄上的力不能使夹具克服 Q = {device.Q.text} 继续运动：f = {device.f.text}、"
                f"rho = {1e3 * rho:g} mm 时，力对 A 的力臂小于摩擦所需；请加长手柄，或减小 f 或 rho",
                f"no force on the handle keeps this clamp moving against Q = {device.Q.text}: with f = "
                f"{device.f.text} and rho = {1e3 * rho:g} mm its arm about A is too short for the friction; "
                "lengthen the handle or lower f or rho",
            )
        )
    return float(x[0]), complex(x[1], x[2])


def _arm(device: EccentricClamp, e: float) -> float:
    """Arm about A of the reaction of the work when the clamp begins to open, positive where it opens."""
    back = complex(device.turn * device.f.si, 1.0)
    return float(-device.turn * (np.conj(_contact(device, e)) * back).imag / abs(back))


def _limit(device: EccentricClamp) -> float:
    """The eccentricity at which the arm reaches ρ."""
    high = device.R.si
    while _arm(device, high) < device.radius:
        high *= 2
    return boundary(lambda e: _arm(device, e) < device.radius, 0.0, high)
