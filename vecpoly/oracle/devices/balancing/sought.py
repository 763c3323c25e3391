"""Masses that are sought: the sum of all couples about the reference plane is 0, then that of all products."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator, Mapping
from math import acos, degrees, sqrt

from ....devices.balancing.mass import RotorMass
from ....devices.balancing.rotor import Rotor
from ....devices.balancing.sought import answers_of, no_polygon, parallel_couples, reference, unknowns
from .directions import direction

ALIKE = 1e-6  # sine between two directions that are one
Vectors = dict[str, complex]  # product (kg·m) of each mass


def sought_answers(device: Rotor) -> Iterator[tuple[str, complex | float]]:
    """The known couples, then of each answer what is found."""
    first, unit = reference(device.masses), device.weighing
    here = device.masses[first].place
    for name, mass in device.masses.items():
        if name != first and "m" not in mass.unknown:
            yield f"C_{name}", mass.product * abs(mass.place - here)
    solutions = sorted(_couples(device.masses, first), key=lambda one: _order(one, device.masses))
    for which, found in zip(answers_of(device.masses), solutions, strict=True):
        found[first] = -sum(found.values())
        for name, vector in found.items():
            radius = device.masses[name].r
            assert radius is not None
            if "m" in device.masses[name].unknown:
                sense = 1.0 if "at" in device.masses[name].unknown else _along(vector, device.masses[name])
                yield f"m_{name}{which}", sense * abs(vector) / radius.si * unit.masses
            if "at" in device.masses[name].unknown:
                yield f"theta_{name}{which}", direction(vector)


def _along(vector: complex, mass: RotorMass) -> float:
    return 1.0 if (vector * rect(1, -mass.at.si)).real >= 0 else -1.0


def _order(found: Vectors, masses: Mapping[str, RotorMass]) -> float:
    """Answers are numbered by the first direction that was sought."""
    name = next((name for name, key in unknowns(masses) if key == "at"), next(iter(found)))
    return direction(found[name])


def _couples(masses: Mapping[str, RotorMass], first: str) -> list[Vectors]:
    """The products of all others, such that ΣW z = 0 about the reference plane."""
    here = masses[first].place
    arm = {name: mass.place - here for name, mass in masses.items()}
    known = {name: mass.vector for name, mass in masses.items() if not mass.unknown}
    rest = -sum((vector * arm[name] for name, vector in known.items()), 0j)
    keys = unknowns(masses)
    names = list(dict.fromkeys(name for name, _ in keys))
    if len(names) == 1:
        return [known | {names[0]: rest / arm[names[0]]}]
    pairs = _two(rest, [(masses[name], arm[name]) for name in names])
    return [known | {name: couple / arm[name] for name, couple in zip(names, pair, strict=True)} for pair in pairs]


def _two(rest: complex, masses: list[tuple[RotorMass, float]]) -> list[tuple[complex, complex]]:
    """Two couples with the sum `rest`, of each its direction or its size known."""
    (one, arm), (other, span) = masses
    if "at" in one.unknown and "at" in other.unknown:
        return _triangle(rest, one.product * abs(arm), other.product * abs(span))
    if "m" in one.unknown and "m" in other.unknown:
        u, v = rect(1, one.at.si), rect(1, other.at.si)
        if abs((u.conjugate() * v).imag) < ALIKE:
            raise parallel_couples(degrees(one.at.si), degrees(other.at.si))
        first = (rest.conjugate() * v).imag / (u.conjugate() * v).imag * u
        return [(first, rest - first)]
    if "m" in one.unknown:
        return _line_and_arc(rest, rect(1, one.at.si), other.product * abs(span))
    return [pair[::-1] for pair in _line_and_arc(rest, rect(1, other.at.si), one.product * abs(arm))]


def _triangle(rest: complex, a: float, b: float) -> list[tuple[complex, complex]]:
    """By the law of cosines."""
    c = abs(rest)
    small, middle, largest = sorted((a, b, c))
    if largest >= small + middle:
        raise no_polygon(largest - small - middle, largest, small + middle)
    turn = acos((a * a + c * c - b * b) / (2 * a * c))
    return [(first, rest - first) for first in (rest / c * rect(a, turn), rest / c * rect(a, -turn))]


def _line_and_arc(rest: complex, u: complex, size: float) -> list[tuple[complex, complex]]:
    """t u + v = rest with |v| given: a quadratic for t."""
    along, across = (rest * u.conjugate()).real, (rest * u.conjugate()).imag
    if abs(across) >= size:
        raise no_polygon(abs(across) - size, abs(across), size)
    half = sqrt(size * size - across * across)
    return [(t * u, rest - t * u) for t in (along - half, along + half)]
