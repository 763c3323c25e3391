"""Stepped gears: a planet, or a gear on a fixed pivot, that meshes with two others by two pitch circles."""

from __future__ import annotations

import cmath
from math import degrees, pi

import numpy as np

from .family import family
from .gears import Circle, Growing, dyad, gear_on_link, pinned, slider, started


def planet(g: Growing, sun: Circle) -> None:
    """On a known sun with one circle, inside or outside a fixed gear with the other."""
    a, phi, large, small = sun.centre, g.between(-pi, pi), g.between(15, 40), g.between(8, 35)
    b = g.letter()
    g.at[b] = g.at[a] + cmath.rect(sun.radius + large, phi)
    name = pinned(g, b, large)
    inside = g.random.random() < 0.6
    fixed = sun.radius + large + (small if inside else -small)
    g.joints += [
        f"{name} rolls on {sun.link} at {g.letter()}",
        f"{name} of {small!r} mm rolls {'inside' if inside else 'on'} circle about {a} of {fixed!r} mm at {g.letter()}",
    ]
    g.link([g.length(a, b), f"phi: {degrees(phi)!r} deg"], [a, b])
    g.circles.append(Circle(name, b, large))


def layshaft(g: Growing, first: Circle) -> None:
    """A stepped gear on a fixed pivot between two others."""
    mine, second, last = g.between(15, 50), g.between(10, 45), g.between(12, 50)
    d = g.fixed(g.at[first.centre] + cmath.rect(first.radius + mine, g.between(-pi, pi)))
    shaft = pinned(g, d, mine)
    e = g.fixed(g.at[d] + cmath.rect(second + last, g.between(-pi, pi)))
    end = pinned(g, e, last)
    one, two = g.letter(), g.letter()
    back = (
        f"{end} rolls on {shaft} of {second!r} mm at {two}"
        if g.random.random() < 0.5
        else f"{shaft} of {second!r} mm rolls on {end} at {two}"
    )
    g.joints += [f"{shaft} rolls on {first.link} at {one}", back]
    g.circles += [Circle(shaft, d, mine), Circle(end, e, last)]


@family("gears-stepped")
def stepped(random: np.random.Generator) -> str:
    """A stepped planet or layshaft, and what hangs on it."""
    while True:
        g = started(random)
        known = [c for c in g.circles if c.centre in g.frame]
        if known:
            break
    (planet, layshaft)[int(random.integers(2))](g, known[0])
    for grow in [(dyad, slider, gear_on_link)[int(random.integers(3))] for _ in range(int(random.integers(3)))]:
        grow(g)
    return g.text()
