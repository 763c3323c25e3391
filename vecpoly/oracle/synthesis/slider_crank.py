"""Every slider-crank with a given K and stroke, from the law of chords and the area of the triangle A C₁ C₂.

(2 a cos(θ/2))² + (2 b sin(θ/2))² = H²; e H = (b² − a²) sin θ.
"""

from __future__ import annotations

from math import asin, cos, degrees, inf, pi, sin, sqrt, tan

from ...designs.ranged.admitted import between
from ...designs.slider_crank import SliderCrank
from ...designs.verdict import Verdict
from ...errors import AssemblyError
from ...foundation.bounds import below
from ...words import Words
from .registry import Linkage, synthesizes

INSIDE = 1e-9  # of an end of a range that is open


@synthesizes(SliderCrank)
def slider_cranks(design: SliderCrank) -> list[Linkage]:
    """The one candidate; its mirror image in the middle of the stroke is the same linkage."""
    h, theta = design.H.si, design.theta
    sine, cosine = sin(theta / 2), cos(theta / 2)  # 1 − cos θ would lose all its digits where K is nearly 1
    if design.e is not None:
        if not below(design.e.si, h / 2 * cosine / sine):
            raise _refused("e", design.e.text, 0.0, h / tan(theta))
        product = design.e.si * h / sin(theta)  # b² − a², and a² = H²/4 − (b² − a²) sin²(θ/2)
        a = sqrt((h / 2) ** 2 - product * sine * sine)
        b = sqrt(a * a + product)
    elif design.AB is not None:
        a = design.AB.si
        if not below(a, h / 2):
            raise _refused("AB", design.AB.text, h / 2 * sine / cosine, h / 2)
        b = sqrt((h / 2) ** 2 - (a * cosine) ** 2) / sine
    else:
        assert design.BC is not None
        b = design.BC.si
        if not (below(h / 2, b) and below(b * sine, h / 2)):
            raise _refused("BC", design.BC.text, h / 2, h / 2 * cosine / sine if sine else inf)
        a = sqrt((h / 2) ** 2 - (b * sine) ** 2) / cosine
    return [_linkage(design, a, b)]


def _linkage(design: SliderCrank, a: float, b: float) -> Linkage:
    """From crank and coupler; A on the left."""
    h, theta = design.H.si, design.theta
    e = (b * b - a * a) * sin(theta) / h
    x = h / 2 - 2 * a * b / h
    sine = (a + e) / b
    alpha = degrees(asin(min(1.0, sine)))
    values = {
        "theta": degrees(theta),
        "AB": 1e3 * a,
        "BC": 1e3 * b,
        "e": 1e3 * e,
        "H": 1e3 * (sqrt((a + b) ** 2 - e * e) - sqrt((b - a) ** 2 - e * e)),
        "alpha_max": alpha,
        "gamma_min": 90.0 - alpha,
        "K": (pi + theta) / (pi - theta),
    }
    verdict = Verdict.VALID if x < 0 else Verdict.ACROSS
    pins = {"A": complex(x, e), "C1": 0j, "C2": complex(h)}
    return Linkage(values=values, pins=pins, verdict=verdict, order=(a, b, e, x))


def _refused(name: str, given: str, low: float, high: float) -> AssemblyError:
    """No meeting; within the range told, its ends left out, the foot of A lies outside C₁C₂, too."""
    inside = low * (1 + INSIDE) or -inf, high * (1 - INSIDE)
    told = between([(1e3 * inside[0], 1e3 * inside[1])], "mm")
    return AssemblyError(
        Words(
            f"{name} = {given}：按此 K 和 H，{name} 可取{told.zh.rstrip()}",
            f"{name} = {given}: with this K and H, {name} may be {told.en}",
        ),
        code="no-solution",
        numbers={"low": low, "high": high},
    )
