"""Symbols of an epicyclic train: central gears, a planet on its carrier, the ring."""

from __future__ import annotations

from math import pi

from ..board.board import Board
from ..board.construction import Place
from ..board.paper.marks import Arc, Dot, GearMark, Ground, LinkNumber, Mark, Point, Role, Segment

OUTSIDE = 5.0  # mm: rim of a ring


def draw_train(board: Board, place: Place, sun: float, arm: float, planets: tuple[float, ...], ring: float) -> None:
    """Radii in mm: sun, planets on the arm (straight up), and the ring; 0 where there is none."""
    centre = 1j * arm
    marks: list[Mark] = [GearMark(centre=0j, radius=sun)]
    marks += [GearMark(centre=centre, radius=radius) for radius in dict.fromkeys(planets)]
    if ring:
        for radius, role in ((ring, Role.CENTRE), (ring + OUTSIDE, Role.LINK)):
            marks.append(Arc(centre=0j, radius=radius, start=0.0, sweep=2 * pi, role=role))
    marks += [
        Segment(a=0j, b=centre, role=Role.LINK),
        Ground(at=0j, down=-1j),
        Point(at=0j, label="O", dot=Dot.JOINT),
        Point(at=centre, label="O_2", dot=Dot.JOINT),
        LinkNumber(a=-0.6 * sun + 0j, b=-0.6 * sun + 0j, number="1"),
        LinkNumber(a=centre + 0.6 * planets[0], b=centre + 0.6 * planets[0], number="2"),
        LinkNumber(a=0.45 * centre, b=0.55 * centre, number="H"),
    ]
    board.mark(place, *marks)


def draw_second_sun(board: Board, place: Place, radius: float) -> None:
    """Another central gear with teeth outside."""
    spot = -0.8j * radius
    board.mark(place, GearMark(centre=0j, radius=radius), LinkNumber(a=spot, b=spot, number="3"))


def number_of_ring(board: Board, place: Place, radius: float) -> None:
    """The number of the ring, on its rim."""
    spot = -1j * (radius + OUTSIDE)
    board.mark(place, LinkNumber(a=spot, b=spot, number="3"))
