"""Rotors with all that the manual allows of one: holes and keyways of other depths and materials, measured products,
drills, two holes in place of one, bolt circles, listed places, pairs that are told, one sign, steps, a grade, bodies.

The third opinion works out every answer from the data alone, without the oracle.
"""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Iterator
from math import cos, degrees, pi, sqrt

import numpy as np

from vecpoly.devices.balancing.mass import RotorMass
from vecpoly.devices.balancing.plane import RotorPlane
from vecpoly.devices.balancing.rotor import Rotor
from vecpoly.solution import Solution

from ..family import family

NEAR = 1e-6  # of what is largest
FLOOR = 1e-7  # kg·m: of the drawn value of a rotor in balance


def as_worked(solution: Solution) -> str:
    """Every answer that is asked, beside what follows from the data."""
    rotor = solution.problem.subject
    assert isinstance(rotor, Rotor)
    unit = rotor.weighing
    worth = {unit.product: unit.products, unit.mass: unit.masses, "mm": 1e3, "μm": 1e6, "deg": 1.0, "yes/no": 1.0}
    for key, (value, size) in _worked(rotor):
        answer = solution.answers.get(key)
        if answer is None:
            continue
        found = answer.exact
        off = (
            (found - value + 180) % 360 - 180
            if answer.reading.unit == "deg"
            else found / worth[answer.reading.unit] - value
        )
        if not abs(off) <= NEAR * size:
            return f"{key}: {found:g}, by the data {value * worth[answer.reading.unit]:g} {answer.reading.unit}"
    return ""


def _worked(rotor: Rotor) -> Iterator[tuple[str, tuple[float, float]]]:
    """Key → value in SI, and the size against which it is judged."""
    products = {name: _product(one) for name, one in rotor.masses.items()}
    whole = sum(map(abs, products.values()))
    for name, one in rotor.masses.items():
        yield f"W_{name}", (abs(products[name]), whole)
        if one.hole is not None or one.keyway is not None:
            yield f"m_{name}", (abs(products[name]) / _si(one.r), abs(products[name]) / _si(one.r))
    yield "W_S", (abs(sum(products.values())), whole)
    centre = rotor.tolerance.z.si if rotor.tolerance is not None and rotor.tolerance.z is not None else None
    stations = {end: (0.0 if plane.z is None else plane.z.si) for end, plane in rotor.planes.items()}
    for end, plane in rotor.planes.items():
        others = [z for name, z in stations.items() if name != end]
        part = {name: _lever(_z(one), stations[end], others) for name, one in rotor.masses.items()}
        if others:
            yield from ((f"W_{name}{end}", (abs(w) * part[name], whole)) for name, w in products.items())
        needed = -sum(w * part[name] for name, w in products.items())
        span = sum(abs(w * part[name]) for name, w in products.items())
        yield from _corrected(end, plane, needed, span)
        if (grade := rotor.tolerance) is not None:
            eccentric = grade.G.si / grade.n.si
            allowed = grade.mass.si * eccentric
            mine = (
                allowed if not others else allowed * (0.5 if centre is None else _lever(centre, stations[end], others))
            )
            yield "e_per", (eccentric, eccentric)
            yield "U_per", (allowed, allowed)
            yield f"U_per{end}", (mine, allowed)


def _corrected(end: str, plane: RotorPlane, needed: complex, span: float) -> Iterator[tuple[str, tuple[float, float]]]:
    yield f"W_b{end}", (abs(needed), span)
    clear = abs(needed) > 0.02 * span
    if clear:
        yield f"theta_b{end}", (degrees(phase(needed)), 360.0)
    if plane.hole is not None:
        yield from _drilled(end, plane, needed, span, clear)
        return
    if plane.r is not None:
        yield f"m_b{end}", (abs(needed) / plane.r.si, span / plane.r.si)


def _drilled(
    end: str, plane: RotorPlane, needed: complex, span: float, clear: bool
) -> Iterator[tuple[str, tuple[float, float]]]:
    r, density, b = _si(plane.r), _si(plane.density), _si(plane.b)
    each = abs(needed) / r if plane.spread is None else abs(needed) / (2 * r * cos(plane.spread.si))
    most = span / r
    if clear:
        yield f"theta_h{end}", (degrees(phase(-needed)), 360.0)
    yield f"m_b{end}", (abs(needed) / r, most)
    if plane.through:
        size = sqrt(4 * each / (pi * density * b))
        yield f"d_b{end}", (size, sqrt(4 * most / (pi * density * b)) if clear else 1.0)
    else:
        across = pi / 4 * _si(plane.hole) ** 2 * density
        yield f"h_b{end}", (each / across, most / across)


def placed_well(solution: Solution) -> str:
    """Weights at places: they make up what is needed, are neighbours of it or those that are told, and of one sign
    where only one is allowed; what rounding leaves is what they lack."""
    rotor = solution.problem.subject
    assert isinstance(rotor, Rotor)
    unit, found = rotor.weighing, {key: one.exact for key, one in solution.answers.items()}
    for end, plane in rotor.planes.items():
        if plane.places is None or f"m_b{end}_2" not in found or f"W_b{end}" not in found:
            continue
        ways = [rect(1.0, found[f"theta_b{end}_{i}"] * pi / 180) for i in (1, 2)]
        masses = [found[f"m_b{end}_{i}"] / unit.masses for i in (1, 2)]
        needed = solution.answers[f"W_b{end}"].exact_vector or 0j
        made = sum(m * _si(plane.r) * way for m, way in zip(masses, ways, strict=True))
        size = max(abs(needed) / unit.products, *(abs(m) * _si(plane.r) for m in masses), FLOOR)
        if abs(made - needed / unit.products) > NEAR * size:
            return f"plane {end}: the weights make {made:g}, needed is {needed / unit.products:g} kg·m"
        if plane.only is not None and any(m * (1 if plane.only == "add" else -1) < -NEAR * size for m in masses):
            return f"plane {end}: {masses} where one may only {plane.only}"
        allowed = [rect(1.0, one.si) for one in (plane.use or plane.places)]
        if any(min(abs(way - one) for one in allowed) > 1e-6 for way in ways):
            return f"plane {end}: {ways} are not among the places"
        if wrong := _rounded(end, plane, masses, ways, solution):
            return wrong
    return ""


def _rounded(end: str, plane: RotorPlane, masses: list[float], ways: list[complex], solution: Solution) -> str:
    answer, unit = solution.answers.get(f"W_r{end}"), solution.problem.subject.weighing  # type: ignore[union-attr]
    if plane.step is None or answer is None:
        return ""
    step = plane.step.si
    if any(abs(m / step % 1 - 0.5) < 1e-6 for m in masses):
        return ""  # midway: either
    left = sum((m - round(m / step) * step) * _si(plane.r) * way for m, way in zip(masses, ways, strict=True))
    off = abs(abs(left) - answer.exact / unit.products)
    return (
        ""
        if off < NEAR * step * _si(plane.r)
        else f"W_r{end}: {answer.exact:g}, by the steps {abs(left) * unit.products:g}"
    )


def both(solution: Solution) -> str:
    """Sizes, and places."""
    return as_worked(solution) or placed_well(solution)


def _product(one: RotorMass) -> complex:
    """m r, negative of what is cut away (kg·m)."""
    if one.U is not None:
        return rect(one.U.si, one.at.si)
    if one.m is not None:
        return rect(one.m.si * _si(one.r), one.at.si)
    thick, density = _si(one.b), _si(one.density)
    if one.keyway is not None:
        return -rect(one.keyway.si * _si(one.depth) * thick * density * _si(one.r), one.at.si)
    deep = thick if one.depth is None else one.depth.si
    return -rect(pi / 4 * _si(one.hole) ** 2 * deep * density * _si(one.r), one.at.si)


def _lever(z: float, here: float, others: list[float]) -> float:
    return 1.0 if not others else (others[0] - z) / (others[0] - here)


def _z(one: RotorMass) -> float:
    return 0.0 if one.z is None else one.z.si


def _si(value: object) -> float:
    return float(value.si)  # type: ignore[attr-defined]


@family("rotor anything", both, often=6)
def anything(rng: np.random.Generator) -> str:
    """Anything that a rotor's data may say."""
    two = bool(rng.random() < 0.5)
    light = rng.random() < 0.4
    planes = _planes(rng, two, light)
    text = "id: rotor\ntitle: A rotor\ndevice: rotor\ndata:\n"
    text += f"  disc: {{b: {rng.integers(20, 80)} mm, density: {rng.choice([7200, 7850, 2700])} kg/m^3}}\n  masses:\n"
    for n in range(1, int(rng.integers(1, 8)) + 1):
        z = f", z: {rng.integers(-300, 900)} mm" if two or rng.random() < 0.2 else ""
        text += f"    {n}: {{{_mass(rng, light)}, at: {rng.uniform(-180, 360):.1f} deg{z}}}\n"
    text += "  correct:\n" + "".join(f"    {name}: {{{', '.join(parts)}}}\n" for name, parts in planes.items())
    if rng.random() < 0.5:
        centre = f", z: {rng.integers(20, 380)} mm" if rng.random() < 0.6 else ""
        mass, speed = int(rng.integers(2, 200)), int(rng.integers(300, 6000))
        grade = f"G: {rng.choice([1, 2.5, 6.3, 16])} mm/s, mass: {mass} kg, n: {speed} r/min"
        text += f"  tolerance: {{{grade}{centre}}}\n"
    if rng.random() < 0.2:
        text += "  bodies: [{from: 0 mm, to: 300 mm, r: 120 mm}]\n"
    return text


def _mass(rng: np.random.Generator, light: bool) -> str:
    r = f"r: {rng.integers(25, 200)} mm"
    kind = rng.choice(["m", "m", "hole", "blind", "keyway", "U"])
    own = f", b: {rng.integers(25, 70)} mm" if rng.random() < 0.3 else ""
    own += f", density: {rng.choice([7850, 8900])} kg/m^3" if rng.random() < 0.2 else ""
    match kind:
        case "m":
            return f"m: {rng.uniform(1, 60):.1f} g, {r}" if light else f"m: {rng.uniform(0.2, 9):.2f} kg, {r}"
        case "hole":
            return f"hole: {rng.integers(5, 15) if light else rng.integers(15, 60)} mm, {r}{own}"
        case "blind":
            return f"hole: {rng.integers(5, 40)} mm, depth: {rng.integers(3, 20)} mm, {r}{own}"
        case "keyway":
            return f"keyway: {rng.integers(4, 20)} mm, depth: {rng.integers(3, 10)} mm, {r}{own}"
        case _:
            return f"U: {rng.uniform(50, 5000):.0f} g*mm" if light else f"U: {rng.uniform(0.02, 0.9):.3f} kg*m"


def _planes(rng: np.random.Generator, two: bool, light: bool) -> dict[str, list[str]]:
    names = [("I", "II"), ("A", "B"), ("L", "R")][int(rng.integers(3))]
    found = {}
    for name, z in zip(names, (0, int(rng.integers(400, 800))), strict=True):
        if name == names[1] and not two:
            break
        parts = [f"z: {z} mm"] if two or rng.random() < 0.3 else []
        found[name] = parts + _way(rng, light)
    return found


def _way(rng: np.random.Generator, light: bool) -> list[str]:
    """How a plane is corrected."""
    r, pitch = f"r: {rng.integers(60, 250)} mm", int(rng.choice([20, 30, 45, 60, 72, 90]))
    match int(rng.integers(7)):
        case 0:
            return []
        case 1:
            return [r]
        case 2:
            return [r, "hole: through"] + ([f"b: {rng.integers(20, 60)} mm"] if rng.random() < 0.3 else [])
        case 3:
            return [r, f"hole: {rng.integers(6, 40)} mm"] + (
                [f"spread: {rng.integers(5, 50)} deg"] if rng.random() < 0.5 else []
            )
        case 4:
            return [r, f"places: {pitch} deg", *_signed(rng, light)]
        case 5:
            start, gaps = rng.uniform(0, 90), rng.uniform(40, 110, int(rng.integers(2, 4)))
            turns = ", ".join(f"{start + sum(gaps[:i]):.0f} deg" for i in range(len(gaps) + 1))
            return [r, f"places: [{turns}]", *_signed(rng, light)]
        case _:
            first = int(rng.integers(0, 360 // pitch)) * pitch
            return [r, f"places: {pitch} deg", f"use: [{first} deg, {(first + pitch) % 360} deg]"]


def _signed(rng: np.random.Generator, light: bool) -> list[str]:
    only = [f"only: {rng.choice(['add', 'remove'])}"] if rng.random() < 0.5 else []
    return only + ([f"step: {'0.5 g' if light else '10 g'}"] if rng.random() < 0.4 else [])
