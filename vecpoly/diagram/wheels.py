"""Symbols of an epicyclic train: central gears, a planet on its carrier, the ring. Radii in mm; O is the origin."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from ..board.paper.marks import Arc, Dot, GearMark, Mark, Point, Role
from ..board.paper.symbols import Symbol
from .gears import hatched_arc
from .owners import FIXED, joint, link
from .single import number, pivot, rod

OUTSIDE, FREE = 5.0, 2.0  # mm: rim of a ring; from a planet's larger step to its body
HELD = pi / 9  # rad: of a hatched arc to either side of where a wheel is held


def epicyclic_train(sun: float, arm: float, planets: tuple[float, ...], ring: float) -> Iterator[Symbol]:
    """Sun, planets on the arm (straight up), and the ring; 0 where there is none."""
    centre = 1j * arm
    yield Symbol.of(link("1"), (GearMark(centre=0j, radius=sun),))
    yield Symbol.of(link("2"), (GearMark(centre=centre, radius=radius) for radius in dict.fromkeys(planets)))
    if ring:
        yield Symbol.of(link("3"), _rims(ring, body_of_ring(ring, arm + max(planets))))
    yield rod(link("H"), 0j, centre)
    yield pivot(0j, "O")
    yield Symbol.of(joint("O2"), (Point(at=centre, label="O_2", dot=Dot.JOINT),))
    yield number("1", -0.6 * sun + 0j)
    yield number("2", centre + 0.6 * planets[0])
    yield number("H", 0.45 * centre, 0.55 * centre)


def second_sun(radius: float) -> Iterator[Symbol]:
    """Another central gear with teeth outside."""
    yield Symbol.of(link("3"), (GearMark(centre=0j, radius=radius),))
    yield number("3", -0.8j * radius)


def body_of_ring(ring: float, reach: float) -> float:
    """The radius of a ring's body, which lies free of the planets: they reach so far from O."""
    return max(ring + OUTSIDE, reach + FREE)


def number_of_ring(body: float) -> Symbol:
    """The number of the ring, on its rim."""
    return number("3", -1j * body)


def held(rim: float, *middles: float, inner: bool = False) -> Symbol:
    """The hatching of a fixed wheel about some directions (rad): outside a ring's body, inside another's rim."""
    return Symbol.of(FIXED, (mark for middle in middles for mark in hatched_arc(0j, rim, middle, HELD, inner=inner)))


def _rims(ring: float, body: float) -> Iterator[Mark]:
    for radius, role in ((ring, Role.CENTRE), (body, Role.LINK)):
        yield Arc(centre=0j, radius=radius, start=0.0, sweep=2 * pi, role=role)
