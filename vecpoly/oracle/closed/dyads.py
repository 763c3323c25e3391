"""Dyads in closed form: two loci of an inner hinge (RRR, RRP, PRP, and with gears), and RPR.

Every step places its links (`place`), then gives them rates (`move`), and says by how much it fails to close (`miss`).
Where two assemblies exist, `sign` tells them apart at the problem's own position,
and `changes` where they change sides; `fold` is 0 where they meet.
"""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import Group
from ..assembly.changes import Changes
from ..run import Run
from ..state import Bodies, Body, Points, Reals, cross, dot
from .loci import Arc, Line, Locus, Share
from .telescope import Telescope, moved, placed, radius_of

Size = Reals | np.float64  # at each position, or the same at all
ROUND = 1e-13  # what rounding leaves of a vanishing square


def _root(square: Reals) -> Reals:
    """Square root; NaN where negative beyond rounding."""
    if square.min(initial=0.0) < 0:
        square = np.where(square > -ROUND, np.maximum(square, 0.0), np.nan)
    root: Reals = np.sqrt(square)
    return root


def signs(step: Hinged | Swinging, run: Run) -> Size:
    """The sign of the assembly at every position of the run."""
    return np.float64(step.sign) if step.changes is None else step.sign * step.changes.signs(run.q)


@dataclass(frozen=True, slots=True)
class Hinged:
    """Inner joint R: it lies on the locus of link j and on the locus of link k;
    either may be a driven cylinder's end."""

    group: Group
    j: Locus | Telescope
    k: Locus | Telescope
    joint: str
    sign: float = 1.0
    changes: Changes | None = None

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
        sign = signs(self, run)
        match self.j, self.k:
            case Line() as j, Line() as k:
                return line_line(from_j, j.direction(bodies), from_k, k.direction(bodies))
            case Line() as j, k:
                return _arc_line(from_k, radius_of(k, run), from_j, j.direction(bodies), sign)
            case j, Line() as k:
                return _arc_line(from_j, radius_of(j, run), from_k, k.direction(bodies), sign)
            case j, k:
                return _arc_arc(from_j, radius_of(j, run), from_k, radius_of(k, run), sign)

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """w_j + λ_j d_j = w_k + λ_k d_k, then q_j + μ_j d_j = q_k + μ_k d_k."""
        own_j, own_k = bodies[self.j.link], bodies[self.k.link]
        v_j, v_k, a_j, a_k = shares(bodies, run, self.group.links, (self.j, own_j), (self.k, own_k))
        return {**moved(self.j, bodies, own_j, v_j, a_j), **moved(self.k, bodies, own_k, v_k, a_k)}

    def fold(self, bodies: Bodies) -> Reals:
        """Square of the sine between both arms, or between the arm and the guide's normal;
        1 where a cylinder moves the hinge."""
        match self.j, self.k:
            case Arc() as j, Arc() as k:
                ray = k.base(bodies) - j.base(bodies)
                cosine = (j.size * j.size + k.size * k.size - dot(ray, ray)) / (2 * j.size * k.size)
                return (1 - cosine) * (1 + cosine)
            case (Arc() as arc, Line() as line) | (Line() as line, Arc() as arc):
                sine = cross(line.direction(bodies), arc.base(bodies) - line.base(bodies)) / arc.size
                return (1 - sine) * (1 + sine)
        return np.ones(1)

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


def shares(
    bodies: Bodies,
    run: Run,
    links: tuple[str, ...],
    one: tuple[Locus | Telescope, Body],
    two: tuple[Locus | Telescope, Body],
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
    return (
        Share(w_j, w_j, rate_j, d_j),
        Share(w_k, w_k, rate_k, d_k),
        Share(b_j, q_j, bend_j, d_j),
        Share(b_k, q_k, bend_k, d_k),
    )


def _split(w: Points, d_j: Points, d_k: Points, inverse: Reals) -> tuple[Reals, Reals]:
    """λ_j, λ_k with λ_j d_j - λ_k d_k = w; inverse = 1 / (d_j × d_k)."""
    conj = w.conj()
    return (conj * d_k).imag * inverse, (conj * d_j).imag * inverse


def _arc_arc(centre: Points, radius: Size, other: Points, reach: Size, sign: Size) -> Points:
    """C = O + D (a + ih), a = (r² - R² + D²) / 2D², h = ±√(r²/D² - a²); sign + is left of the ray O -> P."""
    ray = other - centre
    scale = 1 / dot(ray, ray)
    share = 0.5 + (0.5 * (radius * radius - reach * reach)) * scale
    height = _root(radius * radius * scale - share * share)
    return centre + ray * (share + 1j * sign * height)


def _arc_line(centre: Points, radius: Size, base: Points, along: Points, sign: Size) -> Points:
    """C = foot + e t, t = ±√(r² - g²), g the centre's distance from the line; sign + is ahead of the foot."""
    ahead = along.conj() * (centre - base)
    away = ahead.imag
    travel = ahead.real + (sign * radius) * _root(1 - (away / radius) ** 2)
    return base + along * travel


def line_line(base: Points, along: Points, other: Points, across: Points) -> Points:
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
    changes: Changes | None = None
    two: bool = True

    def reach(self, ray: Points) -> Reals:
        """|σ| (m) from K - G."""
        square = dot(ray, ray)
        if self.across:
            square = square * _root(1 - self.across * self.across / square) ** 2
        return np.asarray(np.sqrt(square))

    def fold(self, bodies: Bodies) -> Reals:
        """(σ / size)²: 0 where the block's pin passes the guide's pivot, or the guide stands square to their line."""
        here, there = self.ends(bodies)
        return (dot(there - here, there - here) - self.across * self.across) / self.size**2

    def ends(self, bodies: Bodies) -> tuple[Points, Points]:
        """G and K."""
        return (bodies[self.guide_parent].point(self.guide_at), bodies[self.block_parent].point(self.block_at))

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """u = (K - G) / (σ + ie) = (K - G) (σ - ie) / (K - G)²."""
        here, there = self.ends(bodies)
        ray = there - here
        reach = signs(self, run) * self.reach(ray)
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
        return {self.guide: guide.moving(v_g, omega, a_g, alpha), self.block: block.moving(v_k, omega, a_k, alpha)}

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """How far the block's pin is nearer to the guide's pivot than the guide's offset (m)."""
        here, there = self.ends(bodies)
        return abs(self.across) - np.abs(there - here)
