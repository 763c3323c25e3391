"""Higher pairs in the pose: a disc of a link that is known moves a lever or a slider with a round tip or a flat face,
or a face moves one with a disc."""

from __future__ import annotations

import cmath

from .places import further, pin
from .rails import rail
from .sides import which
from .sketch import FRAME, Body, Grazing, Sketch, deg, mm, turned
from .sliders import with_points


def cam(sketch: Sketch) -> None:
    """A disc or a face on a moving link, and its follower."""
    driver = _driver(sketch)
    if sketch.chance(0.25) and not _has(driver, "face"):
        _face_drives(sketch, driver)
        return
    o, radius = _disc(sketch, driver)
    form = sketch.one(["round lever", "round slider", "flat lever", "flat slider"])
    other = sketch.one([name for name in sketch.bodies if name != driver.name])
    follow = {
        "round lever": _round_lever,
        "round slider": _round_slider,
        "flat lever": _flat_lever,
        "flat slider": _flat_slider,
    }[form]
    body = follow(sketch, sketch.bodies[other], driver.name, o, radius)
    with_points(sketch, body)


def _driver(sketch: Sketch) -> Body:
    moving = [body for name, body in sketch.bodies.items() if name != FRAME and not _has(body, "disc")]
    if not moving:
        raise Grazing
    return moving[int(sketch.rng.integers(len(moving)))]


def _has(body: Body, word: str) -> bool:
    return any(entry.startswith(f"{word}:") for entry in body.entries)


def _disc(sketch: Sketch, body: Body) -> tuple[str, float]:
    """A disc about a point of the body, an eccentric or a round tip."""
    pins = [p for p in body.at if p not in sketch.bodies[FRAME].at]
    o = sketch.one(pins) if pins and sketch.chance(0.6) else further(sketch, body)
    radius = sketch.between(8, 60)
    body.entries += [f"disc: {o}", f"radius: {mm(radius)}"]
    return o, radius


def _touching(sketch: Sketch, driver: str, o: str, radius: float) -> tuple[complex, float, str]:
    """Centre and radius of a round tip on this disc, and how it touches."""
    tip = 0.0 if sketch.chance(0.15) else sketch.between(4, 25)
    inside = sketch.chance(0.25) and abs(radius - tip) > 6 and tip > 0
    return (
        sketch.places[o] + sketch.some_way() * (abs(radius - tip) if inside else radius + tip),
        tip,
        " inside" if inside else "",
    )


def _contact(sketch: Sketch, one: str, two: str, how: str) -> None:
    k = sketch.letter()
    a, b = (one, two) if sketch.chance(0.5) else (two, one)
    inside, face = (how, "") if how in ("", " inside") else ("", f" {how} of the face")
    sketch.joints.append(f"{a} touches {b}{inside} at {k}{face}")
    sketch.finds += [f"p_{k}", f"v_{k}{two}{k}{one}"]


def _round_lever(sketch: Sketch, parent: Body, driver: str, o: str, radius: float) -> Body:
    at, tip, how = _touching(sketch, driver, o, radius)
    c, name, e = pin(sketch, parent, at, sketch.places[o]), str(len(sketch.bodies)), sketch.letter()
    base = sketch.places[c]
    if abs(((at - base) / (at - sketch.places[o])).imag) < 0.2 * abs((at - base) / (at - sketch.places[o])):
        raise Grazing
    ray = sketch.places[o] - base
    which(sketch, e, at, base + ray * ((at - base) / ray).conjugate(), o, c)
    body = Body(
        name, {c: base, e: at}, [f"{c}{e}: {mm(abs(at - base))}", f"disc: {e}", f"radius: {mm(tip)}"], axis=at - base
    )
    sketch.add(body)
    _contact(sketch, driver, name, how)
    return body


def _round_slider(sketch: Sketch, parent: Body, driver: str, o: str, radius: float) -> Body:
    at, tip, how = _touching(sketch, driver, o, radius)
    led, name, e = rail(sketch, parent, at), str(len(sketch.bodies)), sketch.letter()
    steep = ((at - sketch.places[o]) / led.way).real
    if abs(steep) < 0.2 * abs(at - sketch.places[o]):
        raise Grazing
    which(sketch, e, at, at - 2 * steep * led.way, o)
    body = Body(name, {e: at}, [f"block: {e}", f"disc: {e}", f"radius: {mm(tip)}"], led.way, e, axis=led.way)
    sketch.add(body)
    sketch.joints.append(led.sentence(name, e))
    _contact(sketch, driver, name, how)
    return body


def _flat_lever(sketch: Sketch, parent: Body, driver: str, o: str, radius: float) -> Body:
    """A face beside its pin, perhaps on a bar; the disc to its left or right."""
    at, side = sketch.places[o], sketch.one(["left", "right"])
    c, name = pin(sketch, parent, at), str(len(sketch.bodies))
    base, beside = sketch.places[c], 0.0 if sketch.chance(0.4) else sketch.between(-20, 20)
    aside = beside + (radius if side == "left" else -radius)
    if abs(aside) > 0.8 * abs(at - base):
        raise Grazing
    way = (at - base) / abs(at - base) * cmath.exp(-1j * cmath.asin(aside / abs(at - base)))
    left = "" if beside == 0.0 else f", left: {mm(beside)}"
    if sketch.chance(0.4):
        d, end = sketch.letter(), base + sketch.some_way() * sketch.between(40, 120)
        entries = [
            f"{c}{d}: {mm(abs(end - base))}",
            f"face: {{through: {c}, angle: {deg(turned(way, end - base))} from {c}{d}{left}}}",
        ]
        body = Body(name, {c: base, d: end}, entries, axis=end - base)
    else:
        body = Body(name, {c: base}, [f"face: {{through: {c}{left}}}" if left else f"face: {c}"], way, c, axis=way)
    sketch.add(body)
    _contact(sketch, driver, name, side)
    return body


def _flat_slider(sketch: Sketch, parent: Body, driver: str, o: str, radius: float) -> Body:
    """A flat-faced slider, its face at an angle to its guide."""
    at, side = sketch.places[o], sketch.one(["left", "right"])
    way = sketch.some_way()
    foot = at + (-1j if side == "left" else 1j) * way * radius
    beside = 0.0 if sketch.chance(0.5) else sketch.between(-20, 20)
    place = foot + way * sketch.between(-40, 40) - 1j * way * beside
    led, name, f = rail(sketch, parent, place), str(len(sketch.bodies)), sketch.letter()
    if abs((way / led.way).imag) < 0.2:
        raise Grazing
    left = "" if beside == 0.0 else f", left: {mm(beside)}"
    body = Body(
        name,
        {f: place},
        [f"block: {f}", f"face: {{through: {f}, angle: {deg(turned(way, led.way))} from line{left}}}"],
        led.way,
        f,
        axis=led.way,
    )
    sketch.add(body)
    sketch.joints.append(led.sentence(name, f))
    _contact(sketch, driver, name, side)
    return body


def _face_drives(sketch: Sketch, driver: Body) -> None:
    """A straight flank on a link that is known moves a lever or a slider with a round tip."""
    c = sketch.one(list(driver.at))
    others = [p for p in driver.at if p != c]
    if not others:
        raise Grazing
    d, tip, side = sketch.one(others), sketch.between(4, 25), sketch.one(["left", "right"])
    base, angle = driver.at[c], sketch.between(-cmath.pi, cmath.pi)
    ray = (driver.at[d] - base) / abs(driver.at[d] - base)
    way = ray * cmath.exp(1j * angle)
    driver.entries.append(f"face: {{through: {c}, angle: {deg(angle)} from {c}{d}}}")
    at = base + way * complex(sketch.between(-60, 100), tip if side == "left" else -tip)
    name, e = str(len(sketch.bodies)), sketch.letter()
    parent = sketch.bodies[sketch.one([other for other in sketch.bodies if other != driver.name])]
    if sketch.chance(0.5):
        hinge = pin(sketch, parent, at)
        along = ((at - sketch.places[hinge]) / way).real
        if abs(along) < 0.2 * abs(at - sketch.places[hinge]):
            raise Grazing
        which(sketch, e, at, at - 2 * along * way, hinge)
        start = sketch.places[hinge]
        body = Body(
            name,
            {hinge: start, e: at},
            [f"{hinge}{e}: {mm(abs(at - start))}", f"disc: {e}", f"radius: {mm(tip)}"],
            axis=at - start,
        )
        sketch.add(body)
    else:
        led = rail(sketch, parent, at)
        if abs((way / led.way).imag) < 0.2:
            raise Grazing
        body = Body(name, {e: at}, [f"block: {e}", f"disc: {e}", f"radius: {mm(tip)}"], led.way, e, axis=led.way)
        sketch.add(body)
        sketch.joints.append(led.sentence(name, e))
    _contact(sketch, driver.name, name, side)
