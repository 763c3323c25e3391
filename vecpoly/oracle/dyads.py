"""Dyads in closed form: two loci of an inner hinge (RRR, RRP, PRP, and with gears), RPR, and RPP.

Every step places its links (`place`), then gives them rates (`move`), and says by how much it fails to close
(`miss`). Where two assemblies exist, `sign` tells them apart over the whole motion.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..mechanism.assur import Group
from .loci import Line, Locus, Share
from .run import Run
from .state import Bodies, Body, Points, Reals, cross, dot
from .telescope import Telescope, moved, placed, radius_of

ROUND = 1e-13  # what rounding leaves of a vanishing square


def _root(square: Reals) -> Reals:
    """Square root; NaN where negative beyond rounding."""
    if square.min() < 0:
        square = np.where(square > -ROUND, np.maximum(square, 0.0), np.nan)
    root: Reals = np.sqrt(square)
    return root


@dataclass(frozen=True, slots=True)
class Hinged:
    """Inner joint R: it lies on the locus of link j and on the locus of link k; either may be a driven cylinder's end."""

    group: Group
    j: Locus | Telescope
    k: Locus | Telescope
    joint: str
    sign: float = 1.0

    @property
    def two(self) -> bool:
        """Whether two assemblies exist."""
        return not (isinstance(self.j, Line) and isinstance(self.k, Line))

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """The inner hinge where both loci meet, and both links there."""
        from_j, from_k = self.j.base(bodies), self.k.base(bodies)
        at = self._meet(bodies, run, from_j, from_k)
        return {**placed(self.j, at, from_j, bodies, run), **placed(self.k, at, from_k, bodies, run)}

    def _meet(self, bodies: Bodies, run: Run, from_j: Points, from_k: Points) -> Points:
        match self.j, self.k:
            case Line() as j, Line() as k:
                return _line_line(from_j, j.direction(bodies), from_k, k.direction(bodies))
            case Line() as j, k:
                return _arc_line(from_k, radius_of(k, run), from_j, j.direction(bodies), self.sign)
            case j, Line() as k:
                return _arc_line(from_j, radius_of(j, run), from_k, k.direction(bodies), self.sign)
            case j, k:
                return _arc_arc(from_j, radius_of(j, run), from_k, radius_of(k, run), self.sign)

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """w_j + λ_j d_j = w_k + λ_k d_k, then q_j + μ_j d_j = q_k + μ_k d_k."""
        own_j, own_k = bodies[self.j.link], bodies[self.k.link]
        v_j, v_k, a_j, a_k = _shares(bodies, run, self.group.links, (self.j, own_j), (self.k, own_k))
        return {**moved(self.j, bodies, own_j, v_j, a_j), **moved(self.k, bodies, own_k, v_k, a_k)}

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """Gap at the inner hinge (m)."""
        match self.j, self.k:
            case Line(), Line():
                return np.full(1, np.inf)
            case (Line() as line, arc) | (arc, Line() as line):
                away = cross(line.direction(bodies), arc.base(bodies) - line.base(bodies))
                return np.asarray(np.abs(away) - radius_of(arc, run))
            case j, k:
                apart, one, two = np.abs(k.base(bodies) - j.base(bodies)), radius_of(j, run), radius_of(k, run)
                return np.asarray(np.maximum(apart - (one + two), np.abs(one - two) - apart))


def _shares(
    bodies: Bodies, run: Run, links: tuple[str, ...], one: tuple[Locus | Telescope, Body], two: tuple[Locus | Telescope, Body]
) -> tuple[Share, Share, Share, Share]:
    """Velocity and acceleration of the common point by either locus: v_j, v_k, a_j, a_k."""
    (j, own_j), (k, own_k) = one, two
    w_j, d_j = j.velocity(bodies, own_j)
    w_k, d_k = k.velocity(bodies, own_k)
    inverse = 1 / run.alive(cross(d_j, d_k), radius_of(j, run) * radius_of(k, run), links)
    rate_j, rate_k = _split(w_k - w_j, d_j, d_k, inverse)
    b_j, q_j = j.acceleration(bodies, own_j, d_j, rate_j)
    b_k, q_k = k.acceleration(bodies, own_k, d_k, rate_k)
    bend_j, bend_k = _split(q_k - q_j, d_j, d_k, inverse)
    return (Share(w_j, w_j, rate_j, d_j), Share(w_k, w_k, rate_k, d_k),
            Share(b_j, q_j, bend_j, d_j), Share(b_k, q_k, bend_k, d_k))


def _split(w: Points, d_j: Points, d_k: Points, inverse: Reals) -> tuple[Reals, Reals]:
    """λ_j, λ_k with λ_j d_j - λ_k d_k = w; inverse = 1 / (d_j × d_k)."""
    conj = w.conj()
    return (conj * d_k).imag * inverse, (conj * d_j).imag * inverse


def _arc_arc(centre: Points, radius: Reals, other: Points, reach: Reals, sign: float) -> Points:
    """C = O + D (a + ih), a = (r² - R² + D²) / 2D², h = ±√(r²/D² - a²); sign + is left of the ray O -> P."""
    ray = other - centre
    scale = 1 / dot(ray, ray)
    share = 0.5 + (0.5 * (radius * radius - reach * reach)) * scale
    height = _root(radius * radius * scale - share * share)
    return centre + ray * (share + 1j * sign * height)


def _arc_line(centre: Points, radius: Reals, base: Points, along: Points, sign: float) -> Points:
    """C = foot + e t, t = ±√(r² - g²), g the centre's distance from the line; sign + is ahead of the foot."""
    ahead = along.conj() * (centre - base)
    away = ahead.imag
    travel = ahead.real + (sign * radius) * _root(1 - (away / radius) ** 2)
    return base + along * travel


def _line_line(base: Points, along: Points, other: Points, across: Points) -> Points:
    """Intersection; NaN where the lines are parallel."""
    det = cross(along, across)
    travel = cross(other - base, across) / np.where(np.abs(det) < ROUND, np.nan, det)
    return base + along * travel


@dataclass(frozen=True, slots=True)
class Swinging:
    """RPR: guide pinned at G, block pinned at K: K - G = u (σ + ie), u the guide line's direction, e constant.

    The block's travel from the guide's letter is s = σ + shift. size: the mechanism's scale (m).
    """

    group: Group
    guide: str
    block: str
    guide_parent: str
    block_parent: str
    guide_at: complex  # G on its parent
    block_at: complex
    guide_pin: complex  # G on the guide
    block_pin: complex
    guide_unit: complex  # link's direction against the line's
    block_unit: complex
    across: float
    shift: float
    size: float
    joint: str
    sign: float = 1.0
    two: bool = True

    def reach(self, ray: Points) -> Reals:
        """σ (m) from K - G."""
        square = dot(ray, ray)
        if self.across:
            square = square * _root(1 - self.across * self.across / square) ** 2
        return self.sign * np.sqrt(square)

    def ends(self, bodies: Bodies) -> tuple[Points, Points]:
        """G and K."""
        return (bodies[self.guide_parent].point(self.guide_at),
                bodies[self.block_parent].point(self.block_at))

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """u = (K - G) / (σ + ie) = (K - G) (σ - ie) / (K - G)²."""
        here, there = self.ends(bodies)
        ray = there - here
        reach = self.reach(ray)
        unit = ray * (1 / (reach + 1j * self.across if self.across else np.where(reach, reach, np.nan)))
        return {
            self.guide: Body(self.guide_pin, here, unit * self.guide_unit),
            self.block: Body(self.block_pin, there, unit * self.block_unit),
        }

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """ω = Im(w ū)/σ, σ' = Re(w ū) + ωe; α = (Im(q ū) + ω²e - 2ωσ')/σ with w, q relative to G."""
        guide, block = bodies[self.guide], bodies[self.block]
        here, there = bodies[self.guide_parent], bodies[self.block_parent]
        back = guide.unit.conj() * self.guide_unit
        v_g, v_k = here.velocity_of(self.guide_at), there.velocity_of(self.block_at)
        a_g, a_k = here.acceleration_of(self.guide_at), there.acceleration_of(self.block_at)
        inverse = 1 / run.alive((back * (block.at - guide.at)).real, self.size, self.group.links)
        slip, pull = back * (v_k - v_g), back * (a_k - a_g)
        omega = slip.imag * inverse
        speed = slip.real + omega * self.across if self.across else slip.real
        alpha = (pull.imag + omega * (omega * self.across - 2 * speed)) * inverse
        return {
            self.guide: guide.moving(v_g, omega, a_g, alpha),
            self.block: block.moving(v_k, omega, a_k, alpha),
        }

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """How far the block's pin is nearer to the guide's pivot than the guide's offset (m)."""
        here, there = self.ends(bodies)
        return abs(self.across) - np.abs(there - here)


@dataclass(frozen=True, slots=True)
class Crossed:
    """RPP: link j keeps the angle of k's parent; k slides along j and along its own parent: two lines meet.

    pivot: j's outer hinge on its parent, pin: on j; turn: unit of j's direction against k's. outer: the line of
    a point of k on its parent; inner: the line of the same point on j.
    """

    group: Group
    parent: str
    pivot: complex
    pin: complex
    turn: complex
    outer: Line
    inner: Line
    joint: str
    sign: float = 1.0
    two: bool = False

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """j about its pivot, k where the lines meet."""
        unit = bodies[self.outer.parent].unit * self.outer.turn * self.turn
        j = Body(self.pin, bodies[self.parent].point(self.pivot), unit)
        both = {**bodies, self.inner.parent: j}
        base = self.outer.base(both)
        at = _line_line(base, self.outer.direction(both), self.inner.base(both), self.inner.direction(both))
        return {self.inner.parent: j, self.outer.link: self.outer.body(at, base, both, run)}

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """One ω for all; two sliding speeds from w_o + λ_o d_o = w_i + λ_i d_i."""
        turning, parent = bodies[self.outer.parent], bodies[self.parent]
        j = bodies[self.inner.parent].moving(
            parent.velocity_of(self.pivot), turning.omega, parent.acceleration_of(self.pivot), turning.alpha)
        both, own = {**bodies, self.inner.parent: j}, bodies[self.outer.link]
        v, _, a, _ = _shares(both, run, self.group.links, (self.outer, own), (self.inner, own))
        return {self.inner.parent: j, self.outer.link: self.outer.moving(both, own, v, a)}

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """Parallel guides never meet."""
        return np.full(1, np.inf)
