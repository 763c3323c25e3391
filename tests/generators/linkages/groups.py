"""Class II groups in the pose: RRR, RRP, RPR, PRP, RPP, hung on links that are known."""

from __future__ import annotations

from collections.abc import Callable

from .asks import bar_asks, slide_asks
from .places import pin
from .rails import Rail, rail
from .sides import which
from .sketch import Body, Grazing, Sketch, mm, turned
from .sliders import guide, slider, with_points

Group = Callable[[Sketch], None]


def rrr(sketch: Sketch) -> None:
    """Two bars."""
    a, b = sketch.parents()
    p = pin(sketch, a)
    q = pin(sketch, b, sketch.places[p])
    c, (j, k) = sketch.letter(), sketch.numbers()
    at_p, at_q = sketch.places[p], sketch.places[q]
    at = _apex(sketch, at_p, at_q)
    bars = [_bar(sketch, name, end, where, c, at) for name, end, where in ((j, p, at_p), (k, q, at_q))]
    base = at_q - at_p
    mirrored = at_p + base * ((at - at_p) / base).conjugate()
    which(sketch, c, at, mirrored, p, q)
    sketch.add(*bars)
    bar_asks(sketch, j, p, c)
    bar_asks(sketch, k, q, c)
    for body in bars:
        with_points(sketch, body)


def rrp(sketch: Sketch) -> None:
    """A bar and a slider."""
    a, b = sketch.parents()
    p, (j, k) = pin(sketch, a), sketch.numbers()
    c, at_p = sketch.letter(), sketch.places[p]
    at = sketch.spot(at_p)
    led = rail(sketch, b, at)
    steep = ((at - at_p) / led.way).real
    if abs(steep) < 0.15 * abs(at - at_p):
        raise Grazing
    block, turn = slider(sketch, k, c, at, led.way)
    bar = _bar(sketch, j, p, at_p, c, at)
    which(sketch, c, at, at - 2 * steep * led.way, p)
    sketch.add(bar, block)
    _joined(sketch, b, led, k, c, turn)
    bar_asks(sketch, j, p, c)
    slide_asks(sketch, c, k, b.name)
    with_points(sketch, block)
    with_points(sketch, bar)


def rpr(sketch: Sketch) -> None:
    """A guide that swings about Q, and a block on the pin P."""
    a, b = sketch.parents()
    q = pin(sketch, a)
    base, (g, k) = sketch.places[q], sketch.numbers()
    p = pin(sketch, b, base)
    at = sketch.places[p]
    left = 0.0 if sketch.chance(0.5) else sketch.between(-0.4, 0.4) * min(abs(at - base), 60)
    body, line = guide(sketch, g, q, base, at, left)
    sketch.add(body)
    _pair(sketch, Rail(f"on {line} of {g}" if line else f"in {g}", body.way, left), body, k, p, at)
    slide_asks(sketch, p, g, k)
    with_points(sketch, body)


def prp(sketch: Sketch) -> None:
    """Two sliders pinned together."""
    a, b = sketch.parents()
    c, at, (j, k) = sketch.letter(), sketch.spot(), sketch.numbers()
    rails = [rail(sketch, parent, at) for parent in (a, b)]
    if abs((rails[1].way / rails[0].way).imag) < 0.2:
        raise Grazing
    for name, parent, led in ((j, a, rails[0]), (k, b, rails[1])):
        body, turn = slider(sketch, name, c, at, led.way)
        sketch.add(body)
        _joined(sketch, parent, led, name, c, turn)
        slide_asks(sketch, c, name, parent.name)
    for name in (j, k):
        with_points(sketch, sketch.bodies[name])


def rpp(sketch: Sketch) -> None:
    """A link pinned at P, and one that slides on it and on a link that is known."""
    a, b = sketch.parents()
    p, (j, k) = pin(sketch, a), sketch.numbers()
    r, at_p = sketch.letter(), sketch.places[p]
    at = sketch.spot(at_p)
    outer = rail(sketch, b, at)
    if sketch.chance(0.5):
        _slot_on_outer(sketch, (j, k), (p, at_p), (r, at), outer)
    else:
        _slot_on_pinned(sketch, (j, k), (p, at_p), (r, at), outer)
    slide_asks(sketch, r, k, b.name)
    slide_asks(sketch, p, k, j)
    for name in (j, k):
        if name in sketch.bodies:
            with_points(sketch, sketch.bodies[name])


def _slot_on_outer(
    sketch: Sketch, names: tuple[str, str], p: tuple[str, complex], r: tuple[str, complex], outer: Rail
) -> None:
    """Link k carries a slot that passes the pin P, where block j sits, or P itself runs."""
    j, k = names
    left = 0.0 if sketch.chance(0.5) else sketch.between(-20, 20)
    body, line = guide(sketch, k, r[0], r[1], p[1], left)
    if abs((body.way / outer.way).imag) < 0.2:
        raise Grazing
    sketch.add(body)
    sketch.joints.append(outer.sentence(k, r[0], turned(body.axis, outer.way), of=sketch.chance(0.3)))
    _pair(sketch, Rail(f"on {line} of {k}" if line else f"in {k}", body.way, left), body, j, p[0], p[1])


def _slot_on_pinned(
    sketch: Sketch, names: tuple[str, str], p: tuple[str, complex], r: tuple[str, complex], outer: Rail
) -> None:
    """Link j, pinned at P, carries the slot in which link k slides."""
    j, k = names
    left = 0.0 if sketch.chance(0.5) else sketch.between(-20, 20)
    body, line = guide(sketch, j, p[0], p[1], r[1], left)
    if abs((body.way / outer.way).imag) < 0.2:
        raise Grazing
    block, turn = slider(sketch, k, r[0], r[1], outer.way)
    sketch.add(body, block)
    sketch.joints.append(outer.sentence(k, r[0], turn))
    sketch.joints.append(
        Rail(f"on {line} of {j}" if line else f"in {j}", body.way, left).sentence(k, r[0], turned(block.axis, body.way))
    )


def _apex(sketch: Sketch, p: complex, q: complex) -> complex:
    """A place from which P and Q are seen under a fair angle."""
    while True:
        at = sketch.spot(p, q)
        if abs(((at - p) / (at - q)).imag) > 0.2 * abs((at - p) / (at - q)):
            return at


def _bar(sketch: Sketch, name: str, p: str, at_p: complex, c: str, at: complex) -> Body:
    first, second = (p, c) if sketch.chance(0.6) else (c, p)
    return Body(
        name,
        {first: at_p if first == p else at, second: at if first == p else at_p},
        [f"{first}{second}: {mm(abs(at - at_p))}"],
        axis=(at - at_p) if first == p else (at_p - at),
    )


def _joined(sketch: Sketch, parent: Body, led: Rail, block: str, c: str, turn: float | None) -> None:
    sketch.joints.append(led.sentence(block, c, turn, of=sketch.chance(0.3)))


def _pair(sketch: Sketch, led: Rail, body: Body, block: str, p: str, at: complex) -> None:
    """Block, rod or pin on the line of a link that swings."""
    if led.left == 0.0 and sketch.chance(0.25):
        sketch.joints.append(f"{p} runs in {led.phrase.split(' ', 1)[1]}")
        _renumber(sketch, block, body)
        return
    other, turn = slider(sketch, block, p, at, led.way)
    sketch.add(other)
    if turn is None and led.phrase.startswith("in ") and sketch.chance(0.5):
        aside = "" if led.left == 0.0 else f" with {p} {mm(abs(led.left))} {'left' if led.left > 0 else 'right'}"
        sketch.joints.append(f"{body.name} passes through {block}{aside}")
    else:
        _joined(sketch, body, led, block, p, turn)
    with_points(sketch, other)


def _renumber(sketch: Sketch, unused: str, body: Body) -> None:
    """No block: its number goes to the other link where it is the lower one."""
    if int(unused) < int(body.name):
        old = body.name
        del sketch.bodies[old]
        body.name = unused
        sketch.add(body)
        sketch.joints[:] = [_swapped(text, old, unused) for text in sketch.joints]


def _swapped(text: str, old: str, new: str) -> str:
    return " ".join(new if word == old else word for word in text.split())
