"""Two or three planets on arms of their own that mesh with one gear: every reaction, balanced on any link."""

from __future__ import annotations

import numpy as np

from .family import family
from .gears import Growing, dyad, gear_on_pivot, started, train
from .gears_stepped import planet
from .toothed import balanced, rubbing, teeth_press


def grown(rng: np.random.Generator) -> str:
    """Trains with one planet each, plain or stepped, on one gear; perhaps what hangs on them."""
    while True:
        g: Growing = started(rng)
        known = [c for c in g.circles if c.centre in g.frame]
        if known:
            break
    sun = known[0]
    for _ in range(int(rng.integers(2, 4))):
        if rng.random() < 0.3:
            planet(g, sun)
        else:
            g.circles, others = [sun], g.circles
            train(g, more=0.0)
            g.circles = others
    for grow in [(dyad, gear_on_pivot)[int(rng.integers(2))] for _ in range(int(rng.integers(2)))]:
        grow(g)
    return g.text()


@family("forces-two-trains", also=teeth_press, often=1)
def two_trains(rng: np.random.Generator) -> str:
    """Loads anywhere, the balancing one on any link."""
    return balanced(rng, grown(rng))


@family("forces-two-trains-friction", also=teeth_press, often=1, first=7)
def with_friction(rng: np.random.Generator) -> str:
    """The same with friction in the bearings."""
    bare = grown(rng)
    return balanced(rng, bare) + rubbing(rng, bare)
