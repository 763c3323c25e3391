"""Inertia forces of an in-line engine: amplitudes of the sums over all cylinders as functions of time."""

from __future__ import annotations

from cmath import exp
from collections.abc import Iterator
from math import nan

from ....devices.balancing.asked import CLOSES
from ....devices.balancing.engine import ORDERS, InlineEngine
from ..registry import Values, answers
from .directions import direction


@answers(InlineEngine)
def in_line_engine(device: InlineEngine) -> Values:
    """First order ω², second order λ ω²."""
    return dict(_found(device))


def _found(device: InlineEngine) -> Iterator[tuple[str, float]]:
    ratio = device.r.si / device.l.si
    yield "lambda", ratio
    product, rate = device.m.si * device.r.si, device.n.si**2
    for times, order in enumerate(ORDERS, 1):
        cranks = [exp(1j * times * crank.si) for crank in device.cranks]
        size = product * rate * (ratio if times > 1 else 1.0)
        force = sum(cranks)
        couple = sum(z * crank for z, crank in zip(device.z, cranks, strict=True))
        yield f"W_{order}", product * abs(force)
        yield f"theta_{order}", _turned(force, float(len(cranks)))
        yield f"F_{order}", size * abs(force)
        yield f"C_{order}", product * abs(couple)
        yield f"theta_M{order}", _turned(couple, sum(map(abs, device.z)))
        yield f"M_{order}", size * abs(couple)


def _turned(total: complex, whole: float) -> float:
    return direction(total) if abs(total) > CLOSES * whole else nan
