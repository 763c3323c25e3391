"""What a mistake makes of a known vector, and of a size."""

from __future__ import annotations

from collections.abc import Container, Mapping
from math import pi
from typing import assert_never

from ...plane import Points
from ..place import Place, View, view_of, views
from .slip import Mistake

FACTOR: Mapping[Mistake, float] = {  # what is computed wrongly
    Mistake.HALVED: 0.5,
    Mistake.DOUBLED: 2.0,
    Mistake.DEGREES: 180 / pi,
    Mistake.PER_MINUTE: 30 / pi,
}


def as_taken(mistake: Mistake, vector: Points, scale: float) -> Points:
    """The vector as somebody draws it; scale: of this figure over that of the figure before."""
    match mistake:
        case Mistake.REVERSED:
            return -vector
        case Mistake.TURNED:
            return 1j * vector
        case Mistake.DROPPED:
            return 0.0 * vector
        case Mistake.HALVED | Mistake.DOUBLED | Mistake.DEGREES | Mistake.PER_MINUTE:
            return vector * FACTOR[mistake]
        case Mistake.SCALED:
            return vector * scale
        case Mistake.COINCIDENT | Mistake.OTHER_MEETING | Mistake.OTHER_CENTRE | Mistake.OTHER_TANGENT:
            return vector
        case Mistake.TURNED_OVER:
            return vector
        case Mistake.COMPLEMENT | Mistake.OTHER_SIDE | Mistake.FORWARDS | Mistake.COUNTED | Mistake.SWAPPED:
            return vector
        case Mistake.WITH_FRAME | Mistake.AS_ONE:
            return vector
        case Mistake.OMITTED | Mistake.SIGN | Mistake.INVERTED | Mistake.UNSQUARED | Mistake.COFUNCTION:
            return vector
        case _:
            assert_never(mistake)


def before(place: Place, known: Container[Place]) -> View:
    """The kind of figure whose scale is taken for this one's: of those with a scale here, the one before it."""
    order = [view for view in views() if view in known or view is view_of(place)]
    return order[max(order.index(view_of(place)) - 1, 0)]
