"""A rotor balanced in place: the complex influence coefficient; arcs by the law of cosines."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator
from itertools import combinations
from math import acos

from ....devices.balancing.field import FieldBalancing
from ....devices.balancing.unclear import check_effect, check_spread, no_meeting
from ..registry import Values, answers
from .directions import direction


@answers(FieldBalancing)
def field_balancing(device: FieldBalancing) -> Values:
    """With phases by the coefficient; else by the point where arcs meet."""
    return dict(_by_coefficient(device) if device.phased else _by_arcs(device))


def _by_coefficient(device: FieldBalancing) -> Iterator[tuple[str, float]]:
    (trial,) = device.trials
    v0, v1 = (rect(one.size, one.phase or 0.0) for one in (device.initial, trial.reading))
    effect = v1 - v0
    check_effect(device, abs(effect))
    alpha = effect / rect(trial.m.si * trial.r.si, trial.at.si)
    rest = v0 if device.correct.trial == "removed" else v1
    product = -rest / alpha
    yield "V_t", abs(effect)
    yield "phi_t", direction(effect)
    yield "alpha", abs(alpha) * 1e-6
    yield "beta", direction(-rest / effect)
    yield "m_b", 1e3 * abs(product) / device.correct.r.si
    yield "theta_b", direction(product)


def _by_arcs(device: FieldBalancing) -> Iterator[tuple[str, float]]:
    if len(device.trials) == 2:
        found = sorted(_meetings(device, 0, 1), key=direction)
        for which, q in enumerate(found, 1):
            yield from _weight(device, q, f"_{which}")
        return
    corners = [_nearest(device, i, j) for i, j in combinations(range(3), 2)]
    spread = max(abs(a - b) for a, b in combinations(corners, 2))
    q = sum(corners) / 3
    check_spread(device, spread, abs(q))
    yield from _weight(device, q, "")
    yield "spread", spread


def _weight(device: FieldBalancing, q: complex, way: str) -> Iterator[tuple[str, float]]:
    trial = device.trials[0]
    check_effect(device, abs(q))
    yield f"V_t{way}", abs(q)
    yield f"m_b{way}", 1e3 * trial.m.si * device.initial.size / abs(q) * trial.r.si / device.correct.r.si
    yield f"theta_b{way}", direction(q)


def _meetings(device: FieldBalancing, i: int, j: int) -> tuple[complex, complex]:
    """Where the arcs of two runs meet: about V_0 at the angle of the trial weight, with the reading as radius."""
    (one, other) = (rect(device.initial.size, device.trials[k].at.si) for k in (i, j))
    a, b = (device.trials[k].reading.size for k in (i, j))
    line = other - one
    c = abs(line)
    gap = max(c - a - b, abs(a - b) - c)
    if gap >= 0:
        raise no_meeting(i + 1, j + 1, gap, device.unit)
    turn = acos((a * a + c * c - b * b) / (2 * a * c))
    return one + line / c * rect(a, turn), one + line / c * rect(a, -turn)


def _nearest(device: FieldBalancing, i: int, j: int) -> complex:
    """Of the two meetings the one nearer to the third arc."""
    (k,) = {0, 1, 2} - {i, j}
    third, size = rect(device.initial.size, device.trials[k].at.si), device.trials[k].reading.size
    return min(_meetings(device, i, j), key=lambda q: abs(abs(q - third) - size))
