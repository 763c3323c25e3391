"""The shaper and Whitworth's quick return in closed form."""

from __future__ import annotations

from math import asin, cos, degrees, pi, sin

from ...designs.quick_return import Shaper, Whitworth
from ...designs.verdict import Verdict
from ...errors import AssemblyError
from ...foundation.bounds import below
from ...words import Words
from .registry import Linkage, synthesizes


@synthesizes(Shaper)
def shapers(design: Shaper) -> list[Linkage]:
    """The swing of the lever is θ: AB = AC sin(θ/2), CD = H / (2 sin(θ/2)), h = CD (1 + cos(θ/2)) / 2."""
    half = design.theta / 2
    ac = design.AC.si if design.AC is not None else _si(design) / sin(half)
    cd = design.H.si / (2 * sin(half))
    ab, height = ac * sin(half), cd * (1 + cos(half)) / 2
    values = {"AB": 1e3 * ab, "AC": 1e3 * ac, "CD": 1e3 * cd, "h": 1e3 * height}
    if design.DE is not None:
        if not below(least := design.least_rod(cd), design.DE.si):
            raise _short_rod(design.DE.text, least)
        values["alpha_max"] = degrees(asin((cd - height) / design.DE.si))
    pins = {"A": complex(0, ac), "C": 0j}
    return [_only(values, design.theta, pins, (ab, cd, ac, 0.0))]


@synthesizes(Whitworth)
def whitworths(design: Whitworth) -> list[Linkage]:
    """The quick stroke takes the angle β = 360°/(K + 1) of the crank: AC = AB cos(β/2), CD = H/2."""
    half = pi / (design.K.si + 1)
    ab = design.AB.si if design.AB is not None else _si(design) / cos(half)
    ac, cd = ab * cos(half), design.H.si / 2
    values = {"AB": 1e3 * ab, "AC": 1e3 * ac, "CD": 1e3 * cd}
    if design.DE is not None and not below(least := design.least_rod(cd), design.DE.si):
        raise _no_reach(design.DE.text, least)
    return [_only(values, design.theta, {"A": complex(0, ac), "C": 0j}, (ab, cd, ac, 0.0))]


def _si(design: Shaper | Whitworth) -> float:
    """The one length that is given: AB, else AC."""
    length = design.AB if design.AB is not None else design.AC
    assert length is not None
    return length.si


def _only(values: dict[str, float], theta: float, pins: dict[str, complex], order: tuple[float, ...]) -> Linkage:
    told = {"theta": degrees(theta), "K": (pi + theta) / (pi - theta)}
    return Linkage(values=values | told, pins=pins, verdict=Verdict.VALID, order=order)


def _short_rod(given: str, least: float) -> AssemblyError:
    return AssemblyError(
        Words(
            f"DE = {given}：须大于 MN/(2 cos(θ/2)) = {1e3 * least:.4g} mm，否则导杆未到极限位置时连杆已与它共线，"
            "滑枕提前折返",
            f"DE = {given} must exceed MN/(2 cos(θ/2)) = {1e3 * least:.4g} mm: a shorter rod comes in line with the "
            "lever before this reaches its limit position, and the ram turns back there",
        ),
        code="no-solution",
        numbers={"least": least},
    )


def _no_reach(given: str, arm: float) -> AssemblyError:
    return AssemblyError(
        Words(
            f"DE = {given}：须大于 CD = H/2 = {1e3 * arm:.4g} mm，D 离导路最远时连杆 DE 才能够到导路，导杆才能整周转动",
            f"DE = {given} must exceed CD = H/2 = {1e3 * arm:.4g} mm: the rod must reach the line of the slider where "
            "D is farthest from it, for the bar to turn right round",
        ),
        code="no-solution",
        numbers={"arm": arm},
    )
