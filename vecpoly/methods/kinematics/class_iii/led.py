"""The assembly to which a class III group was led from a near place: found from there, without a look at all others."""

from __future__ import annotations

from itertools import product

import numpy as np

from ...desk import Desk
from .assemblies import OPEN, SAME, Assembly, bare, missed, settled, told, trial
from .star import Axial, Star

NEAR = 0.05  # of Assembly.sharp: so near (rad, and of the mechanism's size) no other assembly can be meant

Way = tuple[tuple[Axial, ...], bool]


def led(desk: Desk, star: Star) -> Assembly | None:
    """The assembly at the places to which all letters of the group were led, drawn in the way that draws it best.

    None where nothing leads there, where statements are to be obeyed, or where another may be as near: all are to be
    looked at then.
    """
    links = (star.plate, *(leg.link for leg in star.legs))
    new = {name for link in links for name in desk.mech.link(link).points} - set(desk.at)
    if star.parallel or not new <= set(desk.mech.guesses) or any(new & set(s.letters) for s in desk.mech.branches):
        return None
    where = _guessed(desk, star)
    return None if where is None else _near(bare(desk), star, *where)


def _guessed(desk: Desk, star: Star) -> tuple[float, complex] | None:
    """Orientation (rad) and origin (mm) of the central link by the places of two of its points."""
    body = desk.mech.link(star.plate).points
    known = {name: at for name, at in desk.mech.guesses.items() if name in body}
    a, b = min(known), max(known, key=lambda name: abs(body[name] - body[min(known)]))
    if body[a] == body[b] or known[a] == known[b]:
        return None
    theta = float(np.angle((known[b] - known[a]) / (body[b] - body[a])))
    return theta, desk.mm(1.0) * (known[a] - np.exp(1j * theta) * body[a])


def _near(plain: Desk, star: Star, theta: float, at: complex) -> Assembly | None:
    size = plain.mm(plain.mech.scale)
    ways = _ways(plain, star, theta, at, NEAR * size)
    if not ways:
        return None
    legs, first = min(ways, key=lambda way: abs(float(missed(plain, star, way[0], way[1], theta))))
    turned = float(settled(plain, star, Assembly(theta, at, legs, first, 0.0)))
    there = complex(trial(plain, star, legs, first, turned))
    found = [told(plain, star, *way, turned) for way in _ways(plain, star, turned, there, SAME * size)]
    best = max(found, key=lambda one: one.quality, default=None)
    if best is None or abs(float(missed(plain, star, best.legs, best.first, turned))) > OPEN * size:
        return None
    return best if max(abs(turned - theta), abs(best.at - at) / size) <= NEAR * best.sharp else None


def _ways(desk: Desk, star: Star, theta: float, at: complex, within: float) -> list[Way]:
    """The legs that place the central link, and on which side, so that its origin is here in this orientation."""
    a, b, c = star.axial
    ways: product[Way] = product(((a, b, c), (b, c, a), (c, a, b)), (True, False))
    return [way for way in ways if abs(complex(trial(desk, star, *way, theta)) - at) <= within]
