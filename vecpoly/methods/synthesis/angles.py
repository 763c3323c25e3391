"""Angles marked on the sheet of a synthesis: the arc between two rays, with the symbol and the value beside it."""

from __future__ import annotations

import numpy as np

from ...board.place import Place
from ...board.said.protractor import degrees_told
from ...designs.base import numbered
from ...names import Named
from ...plane import Points, Reals, nominal
from .draft import SHEET, Draft

LEAST, MOST = 8.0, 22.0  # mm: radius of the arc of an angle
ARC, SHARE = 9.0, 0.72  # mm that an arc should be long; of the shorter ray that its radius takes at most
FARTHER = 4.0  # mm by which the arc of each further angle at one place is larger
FLAT = 0.5  # deg: a smaller angle has no arc


def marked(
    draft: Draft,
    at: Points,
    rays: tuple[Points, Points],
    label: str,
    *,
    key: str = "",
    place: Place = SHEET,
    nth: int = 0,
    turn: Reals | None = None,
) -> None:
    """The arc at a point from the ray through the first of two others to that through the second: as the angle turns
    (rad), else on the nearer side.

    nth: of several angles at one point this one has so many before it.
    """
    start, nearer = rays[0] - at, np.angle((rays[1] - at) / (rays[0] - at))
    sweep = nearer if turn is None else turn
    turned, short = abs(float(nominal(sweep))), min(float(nominal(np.abs(ray - at))) for ray in rays)
    if not np.isfinite(short) or np.degrees(turned) < FLAT:
        return
    radius = min(max(LEAST, min(ARC / turned, MOST)) + nth * FARTHER, max(LEAST / 2, SHARE * short))
    draft.board.angle(place, at, start, sweep, radius, label, key=key)


def valued(draft: Draft, symbol: str, value: Reals) -> str:
    """What stands beside an arc: ``θ = 20°``; of an angle off the protractor ``γ = 40.0°``."""
    return f"{symbol} = {degrees_told(draft.board.acts, value)}°"


def found(draft: Draft, named: Named, at: Points, rays: tuple[Points, Points], *, place: Place = SHEET) -> None:
    """An angle of the candidate that is found next, as it was read or given: under its number where it is its own."""
    own = draft.of_this(named)
    key = draft.kept(numbered(named, draft.number).key, named.key)
    if key is not None:
        symbol = named.symbol if key == named.key else own.symbol
        marked(draft, at, rays, valued(draft, symbol, draft.board.found[key]), key=key, place=place)
