"""The linkages of the designs that are found by inversion: every candidate with its lengths and its verdict."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from ....designs.inversion.angle_pairs import AnglePairs
from ....designs.inversion.loops import Hinged, Loop, chains
from ....designs.inversion.plan import Find, Plan
from ....designs.inversion.positions import Positions
from ....designs.inversion.stages import Stages
from ....designs.verdict import Verdict
from ..registry import Linkage, synthesizes
from .chained import stopped
from .defects import Defect, fourbar, slider_crank
from .staged import Found, linkages

_NONE = 1e-7  # of the extent of what is given: a link shorter than that has no length
_STRAIGHT = 1e-9  # deg
_HARMLESS = {False: (None,), True: (None, Defect.ORDER)}  # a rocker that drives a loop may turn back meanwhile


@synthesizes(Positions)
def positions(design: Positions) -> Iterator[Linkage]:
    """The four-bars through the positions; either link on the frame may drive."""
    return _linkages(design.plan())


@synthesizes(AnglePairs)
def angle_pairs(design: AnglePairs) -> Iterator[Linkage]:
    """The four-bar or slider-crank that has the pairs."""
    return _linkages(design.plan())


@synthesizes(Stages)
def stages(design: Stages) -> Iterator[Linkage]:
    """Every linkage of the chain of stages."""
    return _linkages(design.plan())


def _linkages(plan: Plan) -> Iterator[Linkage]:
    for found in linkages(plan):
        values = {one + two: 1e3 * found.length(one, two) for one, two in plan.bars()}
        yield Linkage(
            values=values | _ahead(plan, found) | _turned(plan, found),
            pins=_pins(found),
            verdict=_verdict(plan, found),
            order=_order(plan, found),
        )


def _ahead(plan: Plan, found: Found) -> dict[str, float]:
    """The angle by which the pin is ahead of the line of its link, in (−180°, 180°]."""
    kept = (stage for stage in plan.stages if isinstance(stage, Find) and plan.turns(stage.on))
    return {
        f"delta_{stage.pin}": _upwards(degrees(phase(found.bodies[stage.on][0].trace(found.pins[stage.pin][0]))))
        for stage in kept
    }


def _upwards(angle: float) -> float:
    """180° for either sign of it: a pin on its line, beyond the pivot."""
    return 180.0 if abs(abs(angle) - 180.0) < _STRAIGHT else angle


def _turned(plan: Plan, found: Found) -> dict[str, float]:
    """Of a body led through positions the directions of AB, DC and AD in the first (deg)."""
    rays = (("A", "B"), ("D", "C"), ("A", "D")) if plan.either else ()
    pins = found.pins
    return {f"phi_{one}{two}": degrees(phase(pins[two][0] - pins[one][0])) for one, two in rays}


def _pins(found: Found) -> dict[str, complex]:
    """Every pin by its letter and the number of the position; a fixed one by its letter."""
    return {
        (letter if len(set(places)) == 1 else f"{letter}{n}"): at
        for letter, places in found.pins.items()
        for n, at in enumerate(places, 1)
    }


def _verdict(plan: Plan, found: Found) -> Verdict:
    if min(found.length(one, two) for one, two in plan.bars()) < _NONE * plan.extent:
        return Verdict.NO_LINK
    hung = {chain[-1]: chain for chain in chains(plan.loops)}
    defects = [(loop, _defect(loop, found, plan.either)) for loop in plan.loops]
    found_wrong = next((defect for loop, defect in defects if defect not in _HARMLESS[loop in hung]), None)
    if found_wrong is None and any(stopped(chain, found.pins) for chain in hung.values()):
        found_wrong = Defect.BRANCH
    return Verdict.VALID if found_wrong is None else Verdict[found_wrong.name]


def _defect(loop: Loop, found: Found, either: bool) -> Defect | None:
    """What is wrong with a loop: of the first link as the driver, unless the last one drives it well."""
    pins = found.pins
    match loop:
        case Hinged():
            a, b, c, d = (pins[letter] for letter in (loop.a, loop.b, loop.c, loop.d))
            first = fourbar(a[0], d[0], b, c).defect
            return None if either and fourbar(d[0], a[0], c, b).defect is None else first
        case _:
            return slider_crank(pins[loop.a][0], loop.along, pins[loop.b], pins[loop.c]).defect


def _order(plan: Plan, found: Found) -> tuple[float, ...]:
    loop = plan.loops[-1]
    letters = (loop.a, loop.b, loop.c, loop.d) if isinstance(loop, Hinged) else (loop.a, loop.b, loop.c)
    lengths = (found.length(one, two) for one, two in pairwise(letters))
    return (*lengths, found.pins[loop.a][0].real)
