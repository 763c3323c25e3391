"""The function generator by Freudenstein's equation: three linear equations for three numbers.

cos φ = P0 cos ψ + P1 cos(ψ − φ) + P2, with P0 = c/a, P1 = −c/d, P2 = (a² + c² + d² − b²) / (2 a d); a and c have signs.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable
from dataclasses import dataclass
from math import cos, degrees, inf, pi, sqrt
from typing import Any

import numpy as np

from ...designs.generator.function_generator import FunctionGenerator
from ...designs.generator.refusals import checked
from ...designs.ranges import extremes
from ...designs.verdict import Verdict
from .inversion.defects import fourbar
from .registry import Linkage, synthesizes
from .sweep import greatest

_DEAD = 1e-9  # of the coupler and output link: the loop at a dead point
Pairs = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Signed:
    """Input and output link with their signs, the coupler, the frame (m)."""

    a: float
    b: float
    c: float
    d: float

    def pins(self, phi: float, psi: float) -> tuple[complex, complex]:
        """B and C at these angles."""
        return self.a * exp(1j * phi), self.d + self.c * exp(1j * psi)

    def reaches(self, phi: float) -> bool:
        """Whether the loop can be closed with the input link there."""
        base = sqrt(self.a**2 + self.d**2 - 2 * self.a * self.d * cos(phi))
        slack = _DEAD * (self.b + abs(self.c))
        return abs(self.b - abs(self.c)) - slack <= base <= self.b + abs(self.c) + slack

    def output(self, phi: Any, side: int) -> Any:
        """ψ with C on this side of BD (1: on the left), in (−π, π], at one φ or at many."""
        base = self.a * np.exp(1j * phi) - self.d
        cosine = (abs(base) ** 2 + self.c**2 - self.b**2) / (2 * abs(base) * abs(self.c))
        at_d = np.exp(-1j * side * np.arccos(np.clip(cosine, -1.0, 1.0)))
        return np.angle(base / abs(base) * at_d * (1 if self.c > 0 else -1))


@synthesizes(FunctionGenerator)
def function_generators(design: FunctionGenerator) -> list[Linkage]:
    """The one four-bar that has the pairs."""
    pairs = _pairs(design)
    p0, p1, p2 = _freudenstein(pairs)
    d = design.AD.si
    c = -checked("CD", p1) * d
    a = checked("AB", c / d / p0 if p0 else inf) * d
    found = _Signed(a=a, b=sqrt(max(a * a + c * c + d * d - 2 * a * d * p2, 0.0)), c=c, d=d)
    b_pins, c_pins = zip(*(found.pins(*pair) for pair in pairs), strict=True)
    verdict = _verdict(design, found, b_pins, c_pins)
    values = {
        **{key: 1e3 * abs(value) for key, value in zip(("AB", "BC", "CD", "AD"), (a, found.b, c, d), strict=True)},
        "delta_B": 0.0 if a > 0 else 180.0,
        "delta_C": 0.0 if c > 0 else 180.0,
        "P_0": p0,
        "P_1": p1,
        "P_2": p2,
    }
    if design.function is not None and verdict is Verdict.VALID:
        values["epsilon_max"] = degrees(greatest(_error(design, found, _side(b_pins[0], c_pins[0], d))))
    pins = {"A": 0j, "D": complex(d)}
    pins |= {f"{letter}{n}": at for letter, all_ in (("B", b_pins), ("C", c_pins)) for n, at in enumerate(all_, 1)}
    return [Linkage(values=values, pins=pins, verdict=verdict, order=(abs(a), found.b, abs(c), 0.0))]


def _pairs(design: FunctionGenerator) -> Pairs:
    """As given; of a function at Chebyshev's points, (1 − cos((2 n − 1) π / 6)) / 2 of the range."""
    if design.pairs is not None:
        return tuple((pair.one, pair.two) for pair in design.pairs)
    return tuple(design.angles_at((1 - cos((2 * n - 1) * pi / 6)) / 2) for n in (1, 2, 3))


def _freudenstein(pairs: Pairs) -> tuple[float, float, float]:
    phi, psi = (np.array(angles) for angles in zip(*pairs, strict=True))
    matrix = np.column_stack([np.cos(psi), np.cos(psi - phi), np.ones(3)])
    try:
        p0, p1, p2 = (float(value) for value in np.linalg.solve(matrix, np.cos(phi)))
    except np.linalg.LinAlgError:
        return 1.0, inf, 1.0  # what is undetermined is refused with the length of CD
    return p0, p1, p2


def _verdict(design: FunctionGenerator, found: _Signed, b: tuple[complex, ...], c: tuple[complex, ...]) -> Verdict:
    if found.b < 1e-9 * found.d:
        return Verdict.NO_LINK
    if (defect := fourbar(0j, complex(found.d), b, c).defect) is not None:
        return Verdict[defect.name]
    turned = () if design.phi is None else extremes(*sorted(end.si for end in design.phi))
    return Verdict.VALID if all(found.reaches(phi) for phi in turned) else Verdict.RANGE


def _side(b: complex, c: complex, d: float) -> int:
    """1 where C lies on the left of BD."""
    return 1 if ((d - b).conjugate() * (c - b)).imag > 0 else -1


def _error(design: FunctionGenerator, found: _Signed, side: int) -> Callable[[Any], Any]:
    """How far the output link is from where the function has it (rad), at a share of the range, or at many."""

    def off(share: Any) -> Any:
        phi, psi = design.angles_at(share)
        return abs(np.angle(np.exp(1j * (found.output(phi, side) - psi))))

    return off
