"""How a run will go, tried out before it is drawn: between which speeds, how large its figures will be."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import assert_never

import numpy as np
import numpy.typing as npt

from ....devices.dynamics.characteristic import Characteristic, Kloss, Measured, Polynomial, highest
from ....devices.dynamics.run_up import RunUp
from ....errors import NotAskedError
from ....words import Words
from ...diagrams.strip import Strip, root, strips

Array = npt.NDArray[np.float64]
Moment = Callable[[Array], Array]
TRIED, FAR, BEYOND = 2001, 1e4, 1.08  # places tried for a crossing; rad/s; of the last speed: how far curves are drawn


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """One run: its name, what drives and what resists, its first and last speed, the steady one if there is one."""

    name: str
    driving: Moment
    resisting: Moment
    start: float
    goal: float
    corners: tuple[float, ...]
    steady: float | None = None

    @property
    def low(self) -> float:
        """The lower of both speeds."""
        return min(self.start, self.goal)

    @property
    def high(self) -> float:
        """The higher one."""
        return max(self.start, self.goal)

    @property
    def last(self) -> float:
        """How far the characteristics are drawn."""
        return BEYOND * (self.steady or self.high)

    def inverse(self, omega: Array) -> Array:
        """1/|ΔM|."""
        return 1 / np.abs(self.driving(omega) - self.resisting(omega))

    @property
    def stops(self) -> tuple[float, ...]:
        """The lower speed, every corner of a characteristic that is passed, the higher one."""
        return (self.low, *sorted({w for w in self.corners if self.low < w < self.high}), self.high)

    def cut(self) -> tuple[Strip, ...]:
        """The strips of the run."""
        return strips(self.inverse, self.stops)

    def total(self, to: float) -> float:
        """∫ dω/|ΔM| from the first speed to this one."""
        inner = sorted(w for w in self.corners if self.start < w < to)
        parts = strips(self.inverse, (self.start, *inner, to))
        return sum(float(self.inverse(np.array(one.places)) @ np.array(one.weights)) for one in parts)


def courses(device: RunUp) -> tuple[Course, ...]:
    """The run-up; or the run-down, and the same with the brake."""
    load, corners = moment(device.load), corners_of(device.load)
    if device.motor is not None:
        motor = moment(device.motor)
        steady = None if device.goal is not None else _steady(device, motor, load)
        goal = device.goal if steady is None else device.share * steady
        assert goal is not None
        both = tuple(sorted({*corners, *corners_of(device.motor)}))
        return (
            Course(
                name="run", driving=motor, resisting=load, start=device.start.si, goal=goal, corners=both, steady=steady
            ),
        )
    free = Course(
        name="free", driving=_nothing, resisting=load, start=device.start.si, goal=device.end, corners=corners
    )
    if device.brake is None:
        return (free,)
    held = device.brake.si
    braked = Course(
        name="braked",
        driving=_nothing,
        resisting=lambda omega: load(omega) + held,
        start=device.start.si,
        goal=device.end,
        corners=corners,
    )
    return free, braked


def _nothing(omega: Array) -> Array:
    return np.zeros_like(omega)


def corners_of(curve: Characteristic | None) -> tuple[float, ...]:
    """The speeds at which a characteristic bends at once."""
    return curve.speeds if isinstance(curve, Measured) else ()


def _steady(device: RunUp, motor: Moment, load: Moment) -> float:
    """Where the characteristics cross for the first time, the motor's coming from above."""
    assert device.motor is not None
    known = [highest(one) for one in (device.motor, device.load) if one is not None]
    most = min(known)
    bound = most if np.isfinite(most) else max(2 * device.start.si, 1.0)

    def surplus(omega: float) -> float:
        return float(motor(np.array([omega]))[0] - load(np.array([omega]))[0])

    while not np.isfinite(most) and surplus(bound) > 0 and bound < FAR:
        bound *= 2
    tried: Sequence[float] = np.linspace(device.start.si, bound, TRIED).tolist()
    pair = next(((a, b) for a, b in itertools.pairwise(tried) if surplus(a) > 0 >= surplus(b)), None)
    if pair is None:
        raise NotAskedError(
            Words(
                f"直到 {bound:.4g} rad/s 两特性曲线没有稳定的交点；请用 to 给出终了转速",
                f"up to {bound:.4g} rad/s the characteristics have no stable crossing; say by 'to' where "
                "the run-up ends",
            ),
            code="no-steady",
            numbers={"omega": bound},
        )
    return root(surplus, *pair)


def moment(curve: Characteristic | None) -> Moment:
    """The ordinate of a characteristic at many speeds."""
    match curve:
        case None:
            return _nothing
        case Polynomial(terms=terms):
            return lambda omega: sum((term * omega**n for n, term in enumerate(terms)), 0.0 * omega)
        case Kloss():
            return lambda omega: _kloss(curve, omega)
        case Measured(speeds=speeds, sizes=sizes):
            return lambda omega: np.interp(omega, speeds, sizes)
        case _:
            assert_never(curve)


def _kloss(motor: Kloss, omega: Array) -> Array:
    """M_k 2 / (s/s_k + s_k/s); nothing at the synchronous speed."""
    s = 1 - omega / motor.synchronous
    ratio = np.where(s == 0, np.inf, s) / motor.slip
    found: Array = np.where(s == 0, 0.0, 2 * motor.greatest / (ratio + 1 / ratio))
    return found
