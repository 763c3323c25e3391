"""Dead centre and drag link: one linear equation for the pin that is sought, from equal couplers."""

from __future__ import annotations

from cmath import exp, phase
from math import cos, pi, sqrt

from ...designs.ranges import extremes
from ...designs.two_positions import DeadCentre, DragLink
from ...designs.verdict import Verdict
from ...errors import AssemblyError
from ...foundation.bounds import below
from ...words import Words
from .four_bar import least_angle
from .registry import Linkage, synthesizes

NEAR = 1e-9


@synthesizes(DeadCentre)
def dead_centre(design: DeadCentre) -> list[Linkage]:
    """B₂ = t u on AC₂ with |B₂ − C₂| = |B₂ − C₁ e^{iφ₁₂}|."""
    d, turn = complex(design.AD.si), exp(1j * design.phi_12.si)
    c1, c2 = (d + design.CD.si * exp(1j * psi.si) for psi in (design.psi_1, design.psi_2))
    along = c2 / abs(c2)
    b2 = along * _equally_far(0j, along, c2, c1 * turn)
    b1 = b2 / turn
    if min(abs(b2), abs(c2 - b2)) < NEAR * abs(d):
        return [_linkage(design, (b1, b2, c1, c2), Verdict.NO_LINK)]
    if _side(b1, d, c1) * _side(b2, d, c2) <= 0:
        verdict = Verdict.OTHER_SIDE
    else:
        verdict = Verdict.VALID if _goes(design, b1, abs(c2 - b2)) else Verdict.BRANCH
    return [_linkage(design, (b1, b2, c1, c2), verdict)]


def _goes(design: DeadCentre, b1: complex, coupler: float) -> bool:
    """Whether C can follow while AB turns by φ₁₂: |BD|² = a² + d² − 2 a d cos φ between (b − c)² and (b + c)²."""
    a, c, d, start = abs(b1), design.CD.si, design.AD.si, phase(b1)
    _, _, *turning = extremes(*sorted((start, start + design.phi_12.si)))  # at both ends it is assembled
    bases = (sqrt(a * a + d * d - 2 * a * d * cos(phi)) for phi in turning)
    return all(below(abs(coupler - c), base) and below(base, coupler + c) for base in bases)


@synthesizes(DragLink)
def drag_link(design: DragLink) -> list[Linkage]:
    """C₁ = D + t u, t > 0, with |C₁ − B₁| = |C₁ − B₂ turned by −180° about D|; C left of BD twice, or right twice."""
    d = complex(design.AD.si)
    b1 = design.AB.si * exp(1j * design.phi_1.si)
    b2, along = b1 * exp(1j * design.beta), exp(1j * design.psi_1.si)
    ahead = _equally_far(d, along, b1, 2 * d - b2)
    c1 = d + along * ahead
    c2 = 2 * d - c1
    a, b, c = abs(b1), abs(c1 - b1), abs(ahead)
    if not _double_crank(a, b, c, d.real):
        verdict = Verdict.NO_DOUBLE_CRANK
    elif _side(b1, d, c1) * _side(b2, d, c2) <= 0:  # a double crank keeps its C on one side of BD
        verdict = Verdict.OTHER_SIDE
    else:
        verdict = Verdict.VALID if ahead > 0 else Verdict.REVERSED
    return [_linkage(design, (b1, b2, c1, c2), verdict)]


def _double_crank(a: float, b: float, c: float, frame: float) -> bool:
    """Whether the frame is the shortest link of a chain of Grashof's."""
    others = sorted((a, b, c))
    return below(frame, others[0]) and below(frame + others[2], others[0] + others[1])


def _equally_far(start: complex, along: complex, one: complex, other: complex) -> float:
    """t with |start + t along − one| = |start + t along − other|; raises AssemblyError where there is none."""
    lean = 2 * (along.conjugate() * (other - one)).real
    if abs(lean) <= NEAR * abs(other - one):  # the two coincide, too
        raise AssemblyError(
            Words(
                "中垂线与给定的直线平行，没有交点；请改动角度",
                "the bisector is parallel to the given line: no meeting; change an angle",
            ),
            code="no-solution",
        )
    return (abs(other - start) ** 2 - abs(one - start) ** 2) / lean


def _side(b: complex, d: complex, c: complex) -> float:
    """Positive where C lies on the left of BD."""
    return ((d - b).conjugate() * (c - b)).imag


def _linkage(
    design: DeadCentre | DragLink, pins: tuple[complex, complex, complex, complex], verdict: Verdict
) -> Linkage:
    (b1, b2, c1, c2), d = pins, complex(design.AD.si)
    a, b, c = abs(b1), abs(c1 - b1), abs(c1 - d)
    values = {"AB": 1e3 * a, "BC": 1e3 * b, "CD": 1e3 * c, "AD": 1e3 * d.real}
    if isinstance(design, DragLink):
        values |= {"gamma_min": least_angle(a, b, c, d.real) * 180 / pi, "K": design.K.si}
    where = {"A": 0j, "D": d, "B1": b1, "B2": b2, "C1": c1, "C2": c2}
    return Linkage(values=values, pins=where, verdict=verdict, order=(a, b, d.real, 0.0))
