"""Instant centres from the velocities:
the point at which two links have one velocity, or the direction in which it lies at infinity."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import NotAskedError, UnknownNameError
from ..foundation.slotted import replace
from ..mechanism.asked.centres import centre, centre_speed, crank_groups, limits, link_pairs, ratio
from ..mechanism.model import FRAME, Mechanism
from ..words import Words
from .motion import Motion
from .planning import plan_for
from .state import Reals, dot

NONE = 1e-9  # of the mechanism's own rates: differences of rates below it are none
ROUNDING = 1e-12  # of the mechanism's size: coordinates below it are zero
ONWARD = 1e-7  # rad/s², and this of the size: rates of difference below it are none
SAMPLES, ZOOMS, FINER = 1440, 12, 16  # positions a turn; how often a bracket is cut, and into how many pieces
LIMIT_KEYS = ("extended", "overlapped")


@dataclass(frozen=True)
class Centres:
    """The instant centres of a mechanism in its own position; rates are those of its drive."""

    mech: Mechanism

    @cached_property
    def motion(self) -> Motion:
        """The motion with a rate of 1 rad/s or 1 m/s: where the centres lie does not depend on it."""
        drives = tuple(replace(drive, rate=1.0, accel=0.0) for drive in self.mech.drives)
        return _at(replace(self.mech, drives=drives))

    def value(self, key: str) -> complex | float:
        """The quantity with this key: a place (m) or velocity as x + iy,
        a direction to infinity (deg, 0 to 180), a ratio, an angle (deg).

        Raises UnknownNameError where there is none, NotAskedError where it has no value.
        """
        for a, b in link_pairs(self.mech):
            if key == centre(self.mech, a, b).key:
                return self.place(a, b)
            if key == centre_speed(self.mech, a, b).key:
                return self.speed(a, b)
            for i, j in ((a, b), (b, a)):
                if FRAME not in (i, j) and key == ratio(self.mech, i, j).key:
                    return self.ratio(i, j)
        for pin, led, rod in crank_groups(self.mech):
            for named, kind in zip(limits(self.mech, led), LIMIT_KEYS, strict=True):
                if key == named.key:
                    return limit(self.mech, pin, led, rod, extended=kind == LIMIT_KEYS[0])
        raise UnknownNameError(Words(f"此处没有瞬心的量 {key}", f"there is no quantity {key} of instant centres here"))

    def place(self, a: str, b: str) -> complex | float:
        """Where v_a(r) = v_b(r): r = i (v_a - v_b) / (ω_a - ω_b), velocities at the origin;
        at infinity the direction ⊥ (v_a - v_b) in deg."""
        slip, turn = self._relative(a, b)
        size = self.mech.scale
        if abs(turn) * size > NONE * max(abs(slip), abs(turn) * size):
            at = 1j * slip / turn
            return complex(*(0.0 if abs(part) < ROUNDING * size else part for part in (at.real, at.imag)))
        angle = float(np.degrees(np.angle(1j * slip)) % 180.0)
        return 0.0 if 180.0 - angle < 1e-7 else angle

    def speed(self, a: str, b: str) -> complex:
        """Velocity of the centre as a point of either link (m/s), with the drive's own rate."""
        at = self.place(a, b)
        if not isinstance(at, complex):
            raise NotAskedError(
                Words(
                    f"构件 {self.mech.number(a)} 与 {self.mech.number(b)} 的瞬心在无穷远处，没有速度",
                    f"the centre of links {self.mech.number(a)} and {self.mech.number(b)} is at infinity: it "
                    "has no velocity",
                )
            )
        return complex(_at(self.mech).moving(a).velocity_at(np.array([at]))[0])

    def ratio(self, a: str, b: str) -> float:
        """ω_a / ω_b."""
        turns = [float(self.motion.moving(name).omega[0]) for name in (a, b)]
        if abs(turns[1]) <= NONE * abs(turns[0]) or turns == [0.0, 0.0]:
            raise NotAskedError(
                Words(
                    f"构件 {b} 此时不转动，ω_{a}/ω_{b} 无值", f"link {b} does not turn here: ω_{a}/ω_{b} has no value"
                )
            )
        return turns[0] / turns[1]

    def _relative(self, a: str, b: str) -> tuple[complex, float]:
        """Velocity of a relative to b at the origin (m/s), and its ω relative to b (rad/s)."""
        here = np.zeros(1, np.complex128)
        first, second = (self.motion.moving(name) for name in (a, b))
        slip = complex((first.velocity_at(here) - second.velocity_at(here))[0])
        turn = float((first.omega - second.omega)[0])
        own = max(abs(float(self.motion.moving(link.name).omega[0])) for link in self.mech.links)
        speed = max(abs(complex(self.motion.moving(link.name).velocity_at(here)[0])) for link in self.mech.links)
        slip = 0j if abs(slip) <= NONE * speed else slip
        turn = 0.0 if abs(turn) <= NONE * own else turn
        return (slip, turn) if slip != 0 or turn != 0 else self._onward(a, b)

    def _onward(self, a: str, b: str) -> tuple[complex, float]:
        """Of links at rest relative to each other the rates of slip and ω:
        the centre is where it comes from and goes to.

        The velocity at the origin changes by a_0 − iα r_0 − iω v_0.
        """
        drives = tuple(replace(drive, rate=1.0, accel=0.0) for drive in self.mech.drives)
        motion = _at(replace(self.mech, drives=drives), order=2)
        bodies = [motion.moving(name, 2) for name in (a, b)]
        first, second = (complex((m.acceleration - 1j * m.alpha * m.at - 1j * m.omega * m.velocity)[0]) for m in bodies)
        slip, turn = first - second, float((bodies[0].alpha - bodies[1].alpha)[0])
        if abs(turn) <= ONWARD and abs(slip) <= ONWARD * self.mech.scale:
            raise NotAskedError(
                Words(
                    f"构件 {self.mech.number(a)} 与 {self.mech.number(b)} 此时无相对运动，瞬心不定；"
                    "请逐一写出要求的其余瞬心，以代替 centres",
                    f"links {self.mech.number(a)} and {self.mech.number(b)} do not move relative to each other "
                    "here: they have no one centre; name the other centres that are asked, one by one, in the "
                    "place of 'centres'",
                )
            )
        return slip, turn


def slowest(mech: Mechanism, link: str, p: str, q: str) -> complex:
    """The point (m) of a link on its line PQ that moves slowest:
    the foot of the perpendicular from the link's absolute centre."""
    here = Centres(mech)
    pole = here.place(link, FRAME)
    if not isinstance(pole, complex):
        raise NotAskedError(
            Words(
                f"构件 {link} 此时作平动，{p}{q} 上各点速度相等",
                f"link {link} only translates here: all points of {p}{q} are equally fast",
            )
        )
    a, b = (complex(here.motion.place(letter)[0]) for letter in (p, q))
    along = (b - a) / abs(b - a)
    return a + along * (along.conjugate() * (pole - a)).real


def limit(mech: Mechanism, pin: str, led: str, rod: str, *, extended: bool) -> float:
    """Crank angle (deg, 0 to 360, from where the problem counts it) at which the led point stands still,
    crank and rod being extended or overlapped.

    The zeros of v_led over a whole turn, refined to rounding. Raises NotAskedError where there is none.
    """
    turn = replace(mech, drives=(replace(mech.drive, rate=1.0, accel=0.0),))
    start = mech.drive.position
    q = start + np.linspace(0.0, 2 * np.pi, SAMPLES + 1)
    sway = _sway(turn, q, pin, led, rod)
    with np.errstate(invalid="ignore"):
        changes = np.flatnonzero(sway[1:] * sway[:-1] <= 0)
    for k in changes:
        middle = np.array([_zero(turn, (q[k], q[k + 1]), pin, led, rod)])
        here = _at(turn, middle)
        a, b, c = (here.place(letter) for letter in (_pivot(mech), pin, led))
        if (float(dot(b - a, c - b)[0]) > 0) is extended and abs(
            float(_sway(turn, middle, pin, led, rod)[0])
        ) < 1e-6 * np.nanmax(np.abs(sway)):
            return float(np.degrees(np.angle((b - a)[0]) - mech.drive.zero) % 360.0)
    raise NotAskedError(
        Words(
            f"曲柄与连杆没有{'拉直' if extended else '重叠'}共线的位置，{led} 不在该处停歇",
            f"crank and rod are never {'extended' if extended else 'overlapped'}: {led} does not come to rest so",
        )
    )


def _zero(turn: Mechanism, between: tuple[float, float], pin: str, led: str, rod: str) -> float:
    """Where the sway changes its sign, refined to rounding, or as far as it does."""
    low, high = between
    for _ in range(ZOOMS):
        inner = np.linspace(low, high, FINER + 1)
        f = _sway(turn, inner, pin, led, rod)
        changed = np.flatnonzero(f[1:] * f[:-1] <= 0)
        if not changed.size:
            break
        low, high = inner[changed[0]], inner[changed[0] + 1]
    return float(low + high) / 2


def _sway(mech: Mechanism, q: Reals, pin: str, led: str, rod: str) -> Reals:
    """v of the led point across the line from it to the pin, over ω of the crank,
    with the sign of its sense: zero where it stands still."""
    motion = _at(mech, q)
    carrier = next(name for name in mech.links_at(led) if name != rod)
    turning = np.broadcast_to(motion.moving(carrier).omega, q.shape)
    if np.any(turning[np.isfinite(turning)] != 0):
        return np.asarray(turning)
    v = np.broadcast_to(motion.moving(carrier).velocity, q.shape)
    way = v[np.nanargmax(np.abs(v))]
    return np.asarray((v * np.conj(way / abs(way))).real)


def _pivot(mech: Mechanism) -> str:
    return next(p for p in mech.link(mech.drive.link).points if p in mech.frame)


def _at(mech: Mechanism, q: Reals | None = None, order: int = 1) -> Motion:
    asked = np.array([mech.drive.position]) if q is None else q
    return Motion(mech, plan_for(mech).bodies(asked, order, q is None), asked.shape, order)
