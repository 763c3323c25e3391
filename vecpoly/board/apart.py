"""One name, one scale: of several figures of a sheet those with another value have a symbol of their own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import isclose

from ..foundation.slotted import replace
from .construction import Scale
from .place import Pane, Place, View


def named_apart(scale: Scale, others: Iterable[Scale]) -> Scale:
    """The scale by a symbol that no other value has: μ_W, μ_W′."""
    known = [part for one in others for part in (one, one.right)]
    across = None if scale.across is None else _named(scale.across, known)
    return replace(_named(scale, known), across=across)


def all_apart(scales: Mapping[View, Scale] | Mapping[Place, Scale]) -> dict[Place, Scale]:
    """These scales, those of figures with one of their own named apart, the first by the plain symbol."""
    found: dict[Place, Scale] = dict(scales.items())
    own = [place for place in found if isinstance(place, Pane)]
    for number, place in enumerate(own):
        found[place] = named_apart(found[place], [found[other] for other in own[:number]])
    return found


def _named(scale: Scale, known: list[Scale]) -> Scale:
    symbol = scale.symbol
    while any(one.symbol == symbol and not isclose(one.value, scale.value) for one in known) and symbol:
        symbol += "′"
    return replace(scale, symbol=symbol)
