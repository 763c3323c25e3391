"""What a leader costs that runs beside a line which begins where it begins: it is taken for one more line of the
drawing, and its letter for the name of the end of that line."""

from __future__ import annotations

import numpy as np

from .about.bounds import Floats
from .about.obstacles import Obstacles
from .spots import Spots
from .want import Want

ALONG, WITHIN = 18.0, 0.3  # the price of lying on such a line; rad from it beyond which that costs nothing
AT = 0.8  # mm from a point's rim: a line that ends there begins at the point
SHORT = 2.0  # mm: a piece so short tells no direction


def alongside(want: Want, obstacles: Obstacles, spots: Spots) -> Floats:
    """Of each place on a leader, by the nearest of the lines that begin at the point which it names."""
    at = want.feet[0]
    ways = [
        (other - at) / abs(other - at)
        for near, others in ((obstacles.a, obstacles.b), (obstacles.b, obstacles.a))
        for other in others[np.abs(near - at) < want.radius + AT]
        if abs(other - at) > SHORT + want.radius
    ]
    if not ways:
        return np.zeros(len(spots.centre))
    led = spots.centre - at
    off = np.abs(np.angle(led[:, None] / np.array(ways)[None])).min(axis=1)
    result: Floats = ALONG * np.clip(1.0 - off / WITHIN, 0.0, 1.0)
    return result
