"""Dead centres and drag links driven from one position to the other by small steps of AB: a third party that knows of
no verdict. What serves goes through on one assembly, and what was rejected does not."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import degrees, pi, tau

import numpy as np
import numpy.typing as npt

from vecpoly.designs.two_positions import DeadCentre, DragLink
from vecpoly.solution import Solution

STEPS = 3601
SAME = 1e-5  # of the frame: two places of a pin; rad: two directions
GRAZED = 1e-7  # of the frame: what B lacks, or has left, at a dead point; neither is held against a verdict
Pins = Mapping[str, complex]
Places = npt.NDArray[np.complex128]


def led(pins: Pins, turn: float) -> tuple[Places, float]:
    """C while AB turns by so much from position 1, and what is left to the nearest dead point (mm; below zero: C cannot
    follow)."""
    a, d, b1, c1 = (pins[key] for key in ("A", "D", "B1", "C1"))
    b = a + (b1 - a) * np.exp(1j * np.linspace(0.0, turn, STEPS))
    coupler, rocker, base = abs(c1 - b1), abs(c1 - d), np.abs(b - d)
    left = min(float((coupler + rocker - base).min()), float((base - abs(coupler - rocker)).min()))
    base = np.maximum(base, SAME * abs(d - a) * GRAZED)  # B may come to D itself, a dead point
    along = (base**2 + rocker**2 - coupler**2) / (2 * base)
    side = np.sign(((d - b1).conjugate() * (c1 - b1)).imag)
    return d + (b - d) / base * (along - 1j * side * np.sqrt(np.maximum(rocker**2 - along**2, 0.0))), left


def _turned(c: Places, d: complex) -> float:
    return float(np.sum(np.angle((c[1:] - d) / (c[:-1] - d))))


def _aside(at: complex, wanted: float) -> float:
    """Between a direction and a wanted one (rad)."""
    return abs(float(np.angle(at * np.exp(-1j * wanted))))


def rests(solution: Solution) -> str:
    """Of a dead centre."""
    design = solution.problem.subject
    assert isinstance(design, DeadCentre)
    return _judged(solution, lambda pins: dead(pins, design))


def half_a_turn(solution: Solution) -> str:
    """Of a drag link."""
    design = solution.problem.subject
    assert isinstance(design, DragLink)
    return _judged(solution, lambda pins: dragged(pins, design))


def _judged(solution: Solution, fault: Callable[[Pins], str | None]) -> str:
    """What is wrong with the verdict on any candidate."""
    for one in solution.construction.candidates:
        found = fault(one.pins)
        if found is not None and (found == "") != (one.reason is None):
            return f"candidate {one.number} is {one.verdict}, but {found or 'goes through'}"
    return ""


def dead(pins: Pins, design: DeadCentre) -> str | None:
    """What keeps AB from bringing C from C₁ to C₂ by φ₁₂; "" where nothing does, None where it is on the edge."""
    size = abs(pins["D"])
    if min(abs(pins["B2"]), abs(pins["B2"] - pins["C2"])) < SAME * size:
        return None
    c, left = led(pins, design.phi_12.si)
    if abs(left) < GRAZED * size:
        return None
    if left < 0:
        return "AB meets a dead point"
    return "" if abs(c[-1] - pins["C2"]) < SAME * size else "C comes to another place"


def dragged(pins: Pins, design: DragLink) -> str | None:
    """What keeps AB from turning right round, or DC from turning by 180° from ψ₁ meanwhile; "", None likewise."""
    size, d = abs(pins["D"]), pins["D"]
    (c, _), (whole, left) = led(pins, 2 * pi / (design.K.si + 1)), led(pins, tau)
    if abs(left) < GRAZED * size:
        return None
    if left < 0:
        return "AB meets a dead point"
    if abs(abs(_turned(whole, d)) - tau) > SAME:
        return "DC does not turn right round"
    if abs(abs(_turned(c, d)) - pi) > SAME or abs(c[-1] - pins["C2"]) > SAME * size:
        return f"DC turns by {degrees(_turned(c, d)):.4g}°"
    aside = max(_aside(c[0] - d, design.psi_1.si), _aside(pins["B1"], design.phi_1.si))
    return "" if aside < SAME else f"a link starts {degrees(aside):.4g}° beside its angle"
