"""Random mechanisms of one to four class II groups, of every joint form of the manual that is no gear or cylinder."""

from __future__ import annotations

import cmath
from copy import deepcopy

import numpy as np

from ..family import family
from . import changing as changing
from .asks import motion_asks
from .cams import cam
from .groups import Group, prp, rpp, rpr, rrp, rrr
from .rails import rail
from .sketch import FRAME, Body, Grazing, Sketch, deg, mm, turned
from .sliders import with_points

GROUPS: tuple[Group, ...] = (rrr, rrp, rpr, prp, rpp)


def _made(rng: np.random.Generator, first: Group, more: int, slides: bool = False) -> str:
    """A driver, the group of the family, and up to so many others."""
    sketch = Sketch(rng)
    (slide if slides else crank)(sketch)
    for i in range(1 + int(rng.integers(more + 1))):
        sketch = grown(sketch, first if i == 0 else GROUPS[int(rng.integers(len(GROUPS)))])
    motion_asks(sketch)
    return sketch.yaml()


def grown(sketch: Sketch, group: Group) -> Sketch:
    """The sketch with a group more, in a pose that is no dead point."""
    while True:
        trial = deepcopy(sketch)
        trial.rng = sketch.rng
        try:
            group(trial)
        except Grazing:
            continue
        return trial


def crank(sketch: Sketch, name: str = "1") -> None:
    """A crank: a bar, a slotted link, a rod."""
    frame, at, way = sketch.bodies[FRAME], sketch.spot(), sketch.some_way()
    a = sketch.letter()
    frame.at[a] = at
    match sketch.one(["bar", "bar", "slot", "rod", "beside"]):
        case "bar":
            end, b = at + way * sketch.between(30, 90), sketch.letter()
            body = Body(name, {a: at, b: end}, [f"{a}{b}: {mm(abs(end - at))}"], axis=way)
        case "beside":
            beside = sketch.between(-30, 30)
            body = Body(
                name, {a: at}, [f"slot: {{through: {a}, left: {mm(beside)}}}"], way, a, at + 1j * way * beside, way
            )
        case kind:
            body = Body(name, {a: at}, [f"{kind}: {a}"], way, a, at, way)
    rate, accel = sketch.one(["10 rad/s ccw", "40 r/min cw", "3 rad/s", "-8 rad/s"]), sketch.one(["0", "5", "-20"])
    sketch.input = f"{{link: {name}, phi: {deg(turned(way))}, omega: {rate}, alpha: {accel} rad/s^2}}"
    sketch.add(body)
    with_points(sketch, body)


def slide(sketch: Sketch, name: str = "1") -> None:
    """A driving slider on a fixed guide."""
    frame, at, b = sketch.bodies[FRAME], sketch.spot(), sketch.letter()
    body = Body(name, {b: at}, [f"block: {b}"], through=b)
    sketch.add(body)
    led = rail(sketch, frame, at)
    turn = sketch.between(-cmath.pi, cmath.pi) if sketch.chance(0.3) else None
    body.way = body.axis = led.way * cmath.exp(1j * (turn or 0.0))
    sketch.joints.append(led.sentence(name, b, turn))
    words = led.phrase.split()
    origin = 0j if "=" in words else frame.at[words[3] if "through" in words else words[1][0]]
    travel = ((at - origin) / led.way).real
    rate, accel = sketch.one(["0.5", "-0.2"]), sketch.one(["0", "3", "-2"])
    sketch.input = f"{{link: {name}, s: {mm(travel)}, v: {rate} m/s, a: {accel} m/s^2}}"
    with_points(sketch, body)


@family("linkage-rrr")
def linkage_rrr(rng: np.random.Generator) -> str:
    """Two bars first."""
    return _made(rng, rrr, 3)


@family("linkage-rrp")
def linkage_rrp(rng: np.random.Generator) -> str:
    """A bar and a slider first."""
    return _made(rng, rrp, 3)


@family("linkage-rpr")
def linkage_rpr(rng: np.random.Generator) -> str:
    """A swinging guide first."""
    return _made(rng, rpr, 3)


@family("linkage-prp")
def linkage_prp(rng: np.random.Generator) -> str:
    """Two sliders on one pin first."""
    return _made(rng, prp, 3)


@family("linkage-rpp")
def linkage_rpp(rng: np.random.Generator) -> str:
    """A pinned slider on a slider first."""
    return _made(rng, rpp, 3)


@family("linkage-slide")
def linkage_slide(rng: np.random.Generator) -> str:
    """A driving slider, and any group first."""
    return _made(rng, GROUPS[int(rng.integers(len(GROUPS)))], 2, slides=True)


@family("linkage-cam")
def linkage_cam(rng: np.random.Generator) -> str:
    """A cam or an eccentric with any follower first."""
    return _made(rng, cam, 2)
