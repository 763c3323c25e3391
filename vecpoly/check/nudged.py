"""Data that no one can tell from the given ones: moved by a few units in the last place."""

from __future__ import annotations

import numpy as np

from ..designs.base import Design
from ..designs.numbers import with_numbers
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism

TRIALS = 4  # sets of data that are looked at
LAST_PLACES = 1e-15  # relative: a few units in the last place of a double


def nudged(mech: Mechanism, rng: np.random.Generator) -> Mechanism:
    """The mechanism with lengths, fixed points and input moved by a few units in the last place."""

    links = tuple(
        replace(link, points={letter: at * _near_one(rng) for letter, at in link.points.items()}) for link in mech.links
    )
    drives = tuple(replace(drive, position=drive.position * _near_one(rng)) for drive in mech.drives)
    starts = tuple(replace(start, value=start.value * _near_one(rng)) for start in mech.starts)
    return replace(
        mech,
        links=links,
        drives=drives,
        starts=starts,
        frame={letter: _moved(at, rng) for letter, at in mech.frame.items()},
    )


def nudged_data(design: Design, rng: np.random.Generator) -> Design:
    """The data of a design with every number that is no count moved by a few units in the last place."""
    return with_numbers(design, lambda number: number * _near_one(rng))


def _moved(number: complex, rng: np.random.Generator) -> complex:
    return complex(number.real * _near_one(rng), number.imag * _near_one(rng))


def _near_one(rng: np.random.Generator) -> float:
    return 1.0 + LAST_PLACES * rng.uniform(-1.0, 1.0)
