"""Guides on links that are known, in every form of the manual, for a pin that is there already."""

from __future__ import annotations

import cmath
from dataclasses import dataclass

from .places import further
from .sketch import FRAME, NEAR, Body, Sketch, deg, mm, turned


@dataclass(frozen=True, slots=True)
class Rail:
    """A guide as a joint names it, its direction, and how far to its left the pin lies."""

    phrase: str
    way: complex
    left: float = 0.0

    def sentence(self, slider: str, pin: str, turn: float | None = None, of: bool = False) -> str:
        """4 slides in 5 with B 20 mm left turned 30 deg."""
        aside = "" if self.left == 0.0 else f" with {pin} {mm(abs(self.left))} {'left' if self.left > 0 else 'right'}"
        front = f"{pin} of " if of and self.left == 0.0 else ""
        return f"{front}{slider} slides {self.phrase}{aside}" + ("" if turn is None else f" turned {deg(turn)}")


def rail(sketch: Sketch, body: Body, at: complex, straight: bool = False) -> Rail:
    """A guide of the body for a pin at this place; straight: the pin lies on its line."""
    left = 0.0 if straight else sketch.offset()
    if body.name == FRAME:
        return _fixed(sketch, body, at, left)
    if body.slot is not None:
        aside = ((at - body.slot) / body.way).imag
        if not straight or abs(aside) < 1e-6:
            return Rail(
                f"{sketch.one(['in', 'on', 'along'])} {body.name}", body.way, aside if abs(aside) > 1e-6 else 0.0
            )
    elif not body.through and len(body.at) > 1 and sketch.chance(0.6):
        return _slotted(sketch, body, at, left)
    return _on_points(sketch, body, at, straight)


def _fixed(sketch: Sketch, frame: Body, at: complex, left: float) -> Rail:
    """y = 30 mm, x = 0 mm, a line through K, the line KL."""
    match sketch.one(["x", "y", "through", "points"]):
        case "x":
            return Rail(f"on x = {mm(at.real + left)}", 1j, left)
        case "y":
            return Rail(f"on y = {mm(at.imag - left)}", 1 + 0j, left)
        case "through":
            way = sketch.some_way()
            k = _placed(sketch, frame, at - way * complex(sketch.between(-90, 90), left))
            return Rail(f"on line through {k} at {deg(turned(way))}", way, left)
    way = sketch.some_way()
    k = _placed(sketch, frame, at - way * complex(sketch.between(-90, 90), left))
    second = _placed(sketch, frame, frame.at[k] + way * sketch.between(20, 120))
    return Rail(f"along {k}{second}", way, left)


def _placed(sketch: Sketch, frame: Body, at: complex) -> str:
    letter = sketch.letter()
    frame.at[letter] = at
    return letter


def _slotted(sketch: Sketch, body: Body, at: complex, left: float) -> Rail:
    """An inclined slot on a bar, through one of its points or beside it."""
    letters = [p for p, place in body.at.items() if abs(place - at) > 60]
    if not letters:
        return _on_points(sketch, body, at, False)
    x, beside = sketch.one(letters), sketch.offset() if left == 0.0 else 0.0
    y = sketch.one([p for p in body.at if p != x])
    base, ray = body.at[x], at - body.at[x]
    way = ray / abs(ray) * cmath.exp(-1j * cmath.asin((left + beside) / abs(ray)))
    aside = "" if beside == 0.0 else f", left: {mm(beside)}"
    body.entries.append(f"slot: {{through: {x}, angle: {deg(turned(way, body.at[y] - base))} from {x}{y}{aside}}}")
    body.way, body.slot, body.through = way, base + 1j * way * beside, x
    return Rail(f"in {body.name}", way, left)


def _on_points(sketch: Sketch, body: Body, at: complex, straight: bool) -> Rail:
    """Along the line of two of its points."""
    while len(body.at) < 2:
        further(sketch, body)
    pairs = [(x, y) for x in body.at for y in body.at if abs(body.at[x] - body.at[y]) > NEAR]
    x, y = pairs[int(sketch.rng.integers(len(pairs)))]
    way = (body.at[y] - body.at[x]) / abs(body.at[y] - body.at[x])
    aside = ((at - body.at[x]) / way).imag
    return Rail(f"on {x}{y} of {body.name}", way, aside if abs(aside) > 1e-6 else 0.0)
