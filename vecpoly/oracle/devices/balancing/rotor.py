"""A rotor in balance: ΣF = 0 and, in two planes, ΣM = 0 about the origin, as one linear system in space."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator
from math import cos, degrees, nan, pi, sqrt

import numpy as np

from ....devices.balancing import asked
from ....devices.balancing.asked import CLOSES
from ....devices.balancing.plane import RotorPlane
from ....devices.balancing.refused import check_holes, check_signs, nothing_to_share, too_deep
from ....devices.balancing.rotor import Rotor
from ..registry import Values, answers
from .directions import direction, turned_to
from .places import resolved, rounded
from .sought import sought_answers

Found = Iterator[tuple[str, complex | float]]


@answers(Rotor)
def rotor(device: Rotor) -> Values:
    """Masses, products, shares, what balances each plane, what is permitted."""
    if device.sought:
        return dict(sought_answers(device))
    balancing = _balancing(device)
    found = dict(_products(device))
    left: dict[str, complex] = {}
    for end, plane in device.planes.items():
        found |= dict(_corrected(device, end, plane, balancing[end]))
        left[end] = -balancing[end]
        if plane.step is not None:
            left[end] = _left(plane, balancing[end])
            found[f"W_r{end}"] = left[end] * device.weighing.products
    if device.tolerance is not None:
        found |= dict(_graded(device, left))
    return found


def _balancing(device: Rotor) -> dict[str, complex]:
    """The products (kg·m) that balance each plane."""
    forces = np.array([mass.vector for mass in device.masses.values()])
    if device.static:
        return {"": complex(-forces.sum())}
    z = np.array([mass.place for mass in device.masses.values()])
    at = np.array([plane.at for plane in device.correct.values()])
    system = np.vstack([np.ones(2), at])
    one, other = np.linalg.solve(system.astype(complex), -np.array([forces.sum(), (forces * z).sum()]))
    return dict(zip(device.ends, (complex(one), complex(other)), strict=True))


def _products(device: Rotor) -> Found:
    unit = device.weighing
    for name, mass in device.masses.items():
        if mass.U is None:
            yield f"m_{name}", mass.size * unit.masses
        yield f"W_{name}", mass.product * unit.products
    if device.static:
        return
    for end, other in (device.ends, device.ends[::-1]):
        span = device.correct[other].at - device.correct[end].at
        for name, mass in device.masses.items():
            yield f"W_{name}{end}", abs(mass.vector) * (device.correct[other].at - mass.place) / span * unit.products
    yield from _verdicts(device)


def _verdicts(device: Rotor) -> Found:
    """Static: ΣW closes; dynamic: ΣW and ΣW z close, in both planes."""
    force = sum(mass.vector for mass in device.masses.values())
    whole = sum(abs(mass.vector) for mass in device.masses.values())
    yield "W_S", complex(force) * device.weighing.products
    yield "static", float(abs(force) <= CLOSES * whole)
    yield "dynamic", float(all(abs(one) <= CLOSES * whole for one in _balancing(device).values()))


def _corrected(device: Rotor, end: str, plane: RotorPlane, balance: complex) -> Found:
    unit = device.weighing
    whole = sum(abs(mass.vector) for mass in device.masses.values())
    yield f"W_b{end}", balance * unit.products
    turned = abs(balance) > CLOSES * whole
    yield f"theta_b{end}", direction(balance) if turned else nan
    if plane.r is None:
        return
    yield f"m_b{end}", abs(balance) / plane.r.si * unit.masses
    if plane.hole is not None:
        yield f"theta_h{end}", direction(-balance) if turned else nan
        yield from _drilled(end, plane, balance)
    if plane.places is not None:
        if not turned:
            raise nothing_to_share(end)
        shares = resolved(plane, balance)
        check_signs(plane, balance, shares)
        for which, (at, share) in enumerate(shares, 1):
            yield f"theta_b{end}_{which}", turned_to(degrees(at))
            yield f"W_b{end}_{which}", share * unit.products
            yield f"m_b{end}_{which}", share / plane.r.si * unit.masses


def _drilled(end: str, plane: RotorPlane, balance: complex) -> Found:
    """A hole is opposite to the weight that it stands for; of two each takes W/(2 cos spread)."""
    assert plane.r is not None and plane.b is not None and plane.density is not None and plane.hole is not None
    mass, density, deep = abs(balance) / plane.r.si, plane.density.si, plane.b.si
    each = mass if plane.spread is None else mass / (2 * cos(plane.spread.si))
    wide = sqrt(4 * each / (pi * deep * density)) if plane.through else plane.hole.si
    check_holes(plane, wide)
    if plane.through:
        yield f"d_b{end}", 1e3 * wide
        return
    depth = 4 * each / (pi * plane.hole.si**2 * density)
    if depth > deep:
        raise too_deep(plane, each, depth)
    yield f"h_b{end}", 1e3 * depth


def _left(plane: RotorPlane, balance: complex) -> complex:
    """What unbalance rounded weights leave."""
    assert plane.step is not None and plane.r is not None
    step = plane.step.si * plane.r.si
    if plane.places is None:
        return rounded(abs(balance), step) * balance / abs(balance) - balance if balance else 0j
    return sum((rect(rounded(share, step), at) for at, share in resolved(plane, balance)), 0j) - balance


def _graded(device: Rotor, left: dict[str, complex]) -> Found:
    grade, unit = device.tolerance, device.weighing
    assert grade is not None
    yield "e_per", 1e6 * grade.G.si / grade.n.si
    yield "U_per", grade.mass.si * grade.G.si / grade.n.si * unit.products
    for end, permitted in device.permitted().items():
        yield f"U_per{end}", permitted * unit.products
        yield asked.within(end).key, float(abs(left[end]) <= permitted)
