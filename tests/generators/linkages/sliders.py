"""Bodies of a sliding pair: blocks, slotted links and rods, with a pin that is there already."""

from __future__ import annotations

import cmath

from .places import further
from .sides import which
from .sketch import Body, Grazing, Sketch, deg, mm, turned


def with_points(sketch: Sketch, body: Body) -> Body:
    """The body, with a further point as often as not."""
    if (body.through or len(body.at) > 1) and sketch.chance(0.5):
        further(sketch, body)
    return body


def slider(sketch: Sketch, name: str, pin: str, at: complex, way: complex) -> tuple[Body, float | None]:
    """A link that slides with this pin along this direction: a block, or a bar; and its turn against the direction."""
    if sketch.chance(0.25):
        second, end = sketch.letter(), at + sketch.some_way() * sketch.between(30, 120)
        body = Body(name, {pin: at, second: end}, [f"{pin}{second}: {mm(abs(end - at))}"], axis=end - at)
        return body, turned(end - at, way)
    turn = sketch.between(-cmath.pi, cmath.pi) if sketch.chance(0.3) else None
    axis = way * cmath.exp(1j * (turn or 0.0))
    return Body(name, {pin: at}, [f"block: {pin}"], way=axis, through=pin, axis=axis), turn


def guide(sketch: Sketch, name: str, q: str, base: complex, p: complex, left: float) -> tuple[Body, str]:
    """A link pinned at Q whose slot, or rod, leaves the place p to its left;
    and how a joint names its line ("": its own)."""
    match sketch.one(["slot", "rod", "beside", "inclined", "bar", "far"]):
        case "far":
            return _far(sketch, name, q, base, p, left)
        case "beside" | "inclined" as form:
            beside = sketch.between(-20, 20)
            way = _towards(base, p, beside + left)
            if form == "inclined":
                return _inclined(sketch, name, q, base, way, beside), ""
            kind, side = (
                sketch.one(["slot", "rod"]),
                f"left: {mm(beside)}" if sketch.chance(0.5) else f"right: {mm(-beside)}",
            )
            return _own(
                Body(name, {q: base}, [f"{kind}: {{through: {q}, {side}}}"]), q, way, base + 1j * way * beside
            ), ""
        case "bar":
            way, second = _towards(base, p, left), sketch.letter()
            body = Body(name, {q: base, second: base + way * sketch.between(40, 150)}, way=way, axis=way)
            body.entries.append(f"{q}{second}: {mm(abs(body.at[second] - base))}")
            return body, f"{q}{second}"
        case kind:
            way = _towards(base, p, left)
            return _own(Body(name, {q: base}, [f"{kind}: {q}"]), q, way, base), ""


def _inclined(sketch: Sketch, name: str, q: str, base: complex, way: complex, beside: float) -> Body:
    """A slot at an angle to a bar."""
    second = sketch.letter()
    end = base + sketch.some_way() * sketch.between(40, 120)
    aside = f", left: {mm(beside)}"
    slot = f"slot: {{through: {q}, angle: {deg(turned(way, end - base))} from {q}{second}{aside}}}"
    body = Body(name, {q: base, second: end}, [f"{q}{second}: {mm(abs(end - base))}", slot], axis=end - base)
    return _own(body, q, way, base + 1j * way * beside)


def _far(sketch: Sketch, name: str, q: str, base: complex, p: complex, left: float) -> tuple[Body, str]:
    """A line set out from the end E of a bar QE, so that the guide could point two ways."""
    second, end = sketch.letter(), sketch.spot(base, p)
    beside = 0.0 if sketch.chance(0.5) else sketch.between(-15, 15)
    way = _towards(end, p, beside + left)
    bar = f"{q}{second}: {mm(abs(end - base))}"
    body = Body(name, {q: base, second: end}, [bar], axis=end - base)
    along = ((p - base) / way).real
    if abs(along) < 0.15 * abs(p - base):
        raise Grazing
    other = (p - base) / complex(-along, ((p - base) / way).imag)
    which(sketch, second, end, base + (end - base) * other / way)
    body.entries.append(
        f"slot: {{through: {second}, angle: {deg(turned(way, base - end))} from {second}{q}, left: {mm(beside)}}}"
    )
    return _own(body, second, way, end + 1j * way * beside), ""


def _own(body: Body, through: str, way: complex, slot: complex) -> Body:
    body.through, body.way, body.slot, body.axis = through, way, slot, body.axis or way
    return body


def _towards(base: complex, p: complex, left: float) -> complex:
    """The direction from base that leaves p so far to its left, ahead."""
    ray = p - base
    if abs(left) > 0.8 * abs(ray):
        raise Grazing
    return ray / abs(ray) * cmath.exp(-1j * cmath.asin(left / abs(ray)))
