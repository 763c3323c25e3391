"""The polygon of centres (瞬心多边形): links are the vertices on a circle,
centres the lines between them; the sought ones are dashed."""

from __future__ import annotations

from math import pi

import numpy as np

from ....board.construction import Pane, Scale, View
from ....board.paper.marks import Role
from ....mechanism.asked.centres import Pair, real_links
from ....words import Words
from ...desk import Desk

NAME = "centre polygon"
TITLE = Words("瞬心多边形", "Circle diagram")
NO_SCALE = Scale(symbol="", value=0.0, unit="")
SIZES = {3: 16.0, 4: 18.0, 5: 22.0}  # mm, radius of the circle by the number of links
LARGE = 26.0


def open_polygon(desk: Desk) -> Pane:
    """The circle with the links' numbers."""
    pane = desk.board.open_pane(View.MECHANISM, NAME, TITLE, NO_SCALE, aside=True)
    radius = _radius(desk)
    desk.board.circle(pane, 0j, radius, Role.CONSTRUCTION)
    for link in real_links(desk.mech):
        desk.board.plot(pane, vertex(desk, link), desk.mech.number(link))
    return pane


def vertex(desk: Desk, link: str) -> complex:
    """Where a link stands on the circle: clockwise from the top left."""
    links = real_links(desk.mech)
    n = len(links)
    start = pi / 2 + (pi / n if n % 2 == 0 else 0.0)
    return complex(_radius(desk) * np.exp(1j * (start - 2 * pi * links.index(link) / n)))


def join(desk: Desk, pane: Pane, pair: Pair, *, sought: bool) -> None:
    """The line of a centre: full where it is known at sight, dashed where it was sought."""
    a, b = (vertex(desk, link) for link in pair)
    desk.board.join(pane, a, b, Role.HIDDEN if sought else Role.GIVEN)


def _radius(desk: Desk) -> float:
    return SIZES.get(len(real_links(desk.mech)), LARGE)
