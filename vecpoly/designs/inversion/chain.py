"""A linkage that was found pin after pin, as a problem of its own: its pins in the first position tell all of it."""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Mapping
from math import degrees, radians, sqrt
from typing import Any

from ...units.reading import Quantity
from .loops import Hinged, Loop
from .plan import FRAME, Assemble, Find, Limits, Plan, Stage

MM = 1e3
PAST = 60.0  # deg: of a crank past a limit position of what it drives
Spots = dict[str, complex]


def chain(plan: Plan, values: Mapping[str, float], omega: Quantity | None) -> dict[str, Any] | None:
    """The linkage with the lengths that were read (mm); None where a guide lies at an angle."""
    if not all(abs(slide.along.real) < 1e-9 or abs(slide.along.imag) < 1e-9 for slide in plan.slides):
        return None
    at = _spots(plan, values)
    turning = _turning(plan)
    links = {str(n): link for n, link in enumerate(_links(plan, at, turning), 1)}
    first = next(iter(turning))
    return {
        "frame": {pin.letter: _place(at[pin.letter]) for pin in plan.pins if pin.on == FRAME},
        "links": links,
        "joints": [f"{n} slides on {_guide(plan, at, link['block'])}" for n, link in links.items() if "block" in link],
        "input": {
            "link": "1",
            "phi": f"{degrees(phase(at[turning[first][0]] - at[first])) + _ahead(plan)!r} deg",
            "omega": "1 rad/s ccw" if omega is None else omega.text,
        },
        "branch": [_branch(loop, at) for loop in plan.loops],
        "find": [f"{kind}_{loop.c}" for kind in "va" for loop in plan.loops],
    }


def _ahead(plan: Plan) -> float:
    """By how much the driver is ahead of the position in which its pins are found: in a limit position all stand
    still, and no velocity could be drawn."""
    return PAST if any(isinstance(stage, Limits) for stage in plan.stages) else 0.0


def _spots(plan: Plan, values: Mapping[str, float]) -> Spots:
    """Every pin in the first position (mm)."""
    at: Spots = {pin.letter: MM * pin.at for pin in plan.pins if pin.on == FRAME}
    at |= {slide.letter: MM * slide.places[0] for slide in plan.slides}
    for pin in plan.pins:
        if pin.on != FRAME:
            position = plan.body(pin.on).positions[0]
            at[pin.letter] = MM * (position.at + pin.at * exp(1j * position.angle))
    for stage in plan.stages:
        at |= _found(stage, plan, at, values)
    return at


def _found(stage: Stage, plan: Plan, at: Spots, values: Mapping[str, float]) -> Spots:
    """What a stage has found."""
    match stage:
        case Find() if not plan.turns(stage.on):
            return {stage.pin: _carried(stage, plan, at[stage.known], values)}
        case Find():
            pivot = stage.on[0]
            limit = next((one for one in plan.stages if isinstance(one, Limits) and one.of == stage.on), None)
            line = plan.body(stage.on).positions[0].angle if limit is None else phase(at[limit.pin] - at[pivot])
            turned = line + radians(values[f"delta_{stage.pin}"])
            return {stage.pin: at[pivot] + _length(values, pivot, stage.pin) * exp(1j * turned)}
        case Limits():
            c, a = MM * stage.first, at[stage.about]
            way = 1 if abs(c - a) > _length(values, stage.crank, stage.pin) else -1
            crank = way * _length(values, stage.about, stage.crank) * (c - a) / abs(c - a)
            return {stage.pin: c, stage.crank: a + crank}
        case Assemble():
            one, span = at[stage.one], at[stage.two] - at[stage.one]
            near, far = MM * stage.to_one, MM * stage.to_two
            along = (abs(span) ** 2 + near**2 - far**2) / (2 * abs(span))
            across = stage.side * sqrt(max(near**2 - along**2, 0.0))
            return {stage.pin: one + span / abs(span) * complex(along, across)}
        case _:
            return {}


def _carried(stage: Find, plan: Plan, pivot: complex, values: Mapping[str, float]) -> complex:
    """In the first position the pin of a coupler that hangs on a slider, on the link about this pivot: of the two
    places at its distances from both the one that has them in the other positions too."""
    first, *others = plan.body(stage.on).positions
    span, far = MM * first.at - pivot, _length(values, stage.on[0], stage.pin)
    near = _length(values, stage.known, stage.pin)
    along = (abs(span) ** 2 + near**2 - far**2) / (2 * abs(span))
    across = sqrt(max(near**2 - along**2, 0.0))
    places = [pivot + span / abs(span) * complex(along, side * across) for side in (1, -1)]

    def off(place: complex) -> float:
        arm = (place - MM * first.at) * exp(-1j * first.angle)
        return sum(abs(abs(MM * at.at + arm * exp(1j * at.angle) - pivot) - near) for at in others)

    return min(places, key=off)


def _length(values: Mapping[str, float], one: str, two: str) -> float:
    return values[one + two] if one + two in values else values[two + one]


def _turning(plan: Plan) -> dict[str, list[str]]:
    """The pins of every link that turns about a pivot, the driver's first."""
    pins: dict[str, list[str]] = {}
    for loop in plan.loops:
        ends = [(loop.a, loop.b), (loop.d, loop.c)] if isinstance(loop, Hinged) else [(loop.a, loop.b)]
        for pivot, pin in ends:
            known = pins.setdefault(pivot, [])
            known += [] if pin in known else [pin]
    driver = next((body.pivot for body in plan.bodies if body.pivot), next(iter(pins)))
    driver = next((stage.about for stage in plan.stages if isinstance(stage, Limits)), driver)
    return {driver: pins[driver]} | pins


def _links(plan: Plan, at: Spots, turning: Mapping[str, list[str]]) -> list[dict[str, Any]]:
    """The links about pivots, the couplers, the blocks."""
    links: list[dict[str, Any]] = [_about(pivot, pins, at) for pivot, pins in turning.items()]
    for one, two in plan.bars():
        if not any({one, two} <= {pivot, *pins} for pivot, pins in turning.items()) and not {one, two} <= set(turning):
            links.append({one + two: f"{abs(at[two] - at[one])!r} mm"})
    return links + [{"block": slide.letter} for slide in plan.slides]


def _about(pivot: str, pins: list[str], at: Spots) -> dict[str, Any]:
    """A link from its pivot to its first pin, and its further pins by offsets along that ray."""
    first, *others = pins
    ray = at[first] - at[pivot]
    link: dict[str, Any] = {pivot + first: f"{abs(ray)!r} mm"}
    for other in others:
        off = (at[other] - at[pivot]) / (ray / abs(ray))
        link[other] = {"along": pivot + first, "at": f"{off.real!r} mm", "left": f"{off.imag!r} mm"}
    return link


def _place(at: complex) -> list[str]:
    return [f"{at.real!r} mm", f"{at.imag!r} mm"]


def _guide(plan: Plan, at: Spots, letter: str) -> str:
    slide = next(slide for slide in plan.slides if slide.letter == letter)
    return f"x = {at[letter].real!r} mm" if abs(slide.along.real) < 1e-9 else f"y = {at[letter].imag!r} mm"


def _branch(loop: Loop, at: Spots) -> str:
    """On which side the loop is closed in the first position."""
    b, c = at[loop.b], at[loop.c]
    if isinstance(loop, Hinged):
        left = ((at[loop.d] - b).conjugate() * (c - b)).imag >= 0
        return f"{loop.c} {'left' if left else 'right'} of {loop.b}{loop.d}"
    if abs(loop.along.real) < 1e-9:
        return f"{loop.c} {'above' if (c - b).imag >= 0 else 'below'} {loop.b}"
    return f"{loop.c} {'right' if (c - b).real >= 0 else 'left'} of {loop.b}"
