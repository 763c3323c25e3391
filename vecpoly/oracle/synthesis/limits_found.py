"""Limit positions of a crank-rocker, a slider-crank and a guide bar with given lengths, in closed form."""

from __future__ import annotations

from cmath import exp
from math import acos, asin, degrees, pi, sqrt

from ...designs.limits_found import CrankRockerLimits, GuideBarLimits, SliderCrankLimits
from ...designs.verdict import Verdict
from ...errors import AssemblyError
from ...foundation.bounds import below
from ...words import Words
from .four_bar import found
from .registry import Linkage, synthesizes


@synthesizes(CrankRockerLimits)
def crank_rocker(design: CrankRockerLimits) -> list[Linkage]:
    """C₁, C₂ at the distances BC ∓ AB from A, above AD."""
    a, b, c, d = (one.si for one in (design.AB, design.BC, design.CD, design.AD))
    longest = max(b, c, d)
    if not below(min(b, c, d), a) and _equal(a + longest, b + c + d - longest):
        raise _change_point(
            f"AB + l_max = {1e3 * (a + longest):.7g} mm", Words("其余两杆之和", "the sum of the others")
        )
    if below(min(b, c, d), a) or not below(a + longest, b + c + d - longest):
        raise _no_crank(
            f"AB + l_max = {1e3 * (a + longest):.7g} mm",
            f"{1e3 * (b + c + d - longest):.7g} mm",
            Words(
                "AB 须最短，且 AB + l_max 小于其余两杆之和",
                "AB must be the shortest, and AB + l_max below the sum of the others",
            ),
        )
    c1, c2 = (r * exp(1j * acos((r * r + d * d - c * c) / (2 * r * d))) for r in (b - a, b + a))
    return [found(0j, complex(d), c1, c2)]


@synthesizes(SliderCrankLimits)
def slider_crank(design: SliderCrankLimits) -> list[Linkage]:
    """C₁, C₂ on the guide at the distances BC ∓ AB from A: θ = acos(e/(b + a)) − acos(e/(b − a))."""
    a, b, e = design.AB.si, design.BC.si, design.offset
    if _equal(a + e, b):
        raise _change_point(f"AB + e = {1e3 * (a + e):.7g} mm", Words("BC", "BC"))
    if not below(a + e, b):
        raise _no_crank(
            f"AB + e = {1e3 * (a + e):.7g} mm",
            f"BC = {1e3 * b:.7g} mm",
            Words("须 AB + e < BC", "AB + e must be below BC"),
        )
    theta = acos(e / (b + a)) - acos(e / (b - a))
    alpha = degrees(asin((a + e) / b))
    near, far = (sqrt(r * r - e * e) for r in (b - a, b + a))
    values = {
        "theta": degrees(theta),
        "K": (pi + theta) / (pi - theta),
        "H": 1e3 * (far - near),
        "alpha_max": alpha,
        "gamma_min": 90 - alpha,
        "AB": 1e3 * a,
        "BC": 1e3 * b,
        "e": 1e3 * e,
    }
    pins = {"A": 0j, "C1": complex(near, -e), "C2": complex(far, -e)}
    return [Linkage(values=values, pins=pins, verdict=Verdict.VALID, order=(a, b, e, 0.0))]


@synthesizes(GuideBarLimits)
def guide_bar(design: GuideBarLimits) -> list[Linkage]:
    """The bar's line touches the circle of B on either side: ψ = asin((a + e)/d) + asin((a − e)/d) = θ."""
    a, d, e = design.AB.si, design.AC.si, design.offset
    if not below(a + e, d):
        raise _no_crank(
            f"AB + e = {1e3 * (a + e):.7g} mm",
            f"AC = {1e3 * d:.7g} mm",
            Words(
                "摆动导杆须 AB + e < AC（AB ≥ AC + e 时为转动导杆，用 synthesis: whitworth）",
                "for a bar that swings AB + e must be below AC (with AB ≥ AC + e it turns right round: "
                "synthesis: whitworth)",
            ),
        )
    leaning = asin((a + e) / d), asin((e - a) / d)  # of the bar from CA, ccw
    theta, alpha = leaning[0] - leaning[1], degrees(asin(e / (d - a)))
    values = {
        "theta": degrees(theta),
        "K": (pi + theta) / (pi - theta),
        "psi": degrees(theta),
        "alpha_max": alpha,
        "gamma_min": 90 - alpha,
        "AB": 1e3 * a,
        "AC": 1e3 * d,
        "e": 1e3 * e,
    }
    ends = [complex(0, d) + side * a * exp(1j * lean) for side, lean in zip((-1, 1), leaning, strict=True)]
    pins = {"A": complex(0, d), "C": 0j, "B1": ends[0], "B2": ends[1]}
    return [Linkage(values=values, pins=pins, verdict=Verdict.VALID, order=(a, e, d, 0.0))]


def _equal(one: float, other: float) -> bool:
    return not below(one, other) and not below(other, one)


def _change_point(one: str, other: Words) -> AssemblyError:
    """AB turns right round, but where all links lie in one line the others may go on in either sense."""
    return AssemblyError(
        Words(
            f"{one} 等于{other.zh}：AB 能整周回转，但要经过各杆共线的变点，该处 γ_min = 0，"
            "从动件运动不确定；请改变一个长度",
            f"{one} equals {other.en}: AB can turn right round, but through a change point in which all links lie in "
            "one line, γ_min = 0 and what follows may go on in either sense; change a length",
        ),
        code="change-point",
    )


def _no_crank(one: str, other: str, condition: Words) -> AssemblyError:
    return AssemblyError(
        Words(f"AB 不是曲柄：{one}，{other}；", f"AB is no crank: {one}, {other}; ") + condition, code="no-solution"
    )
