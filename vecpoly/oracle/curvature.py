"""Curvatures of a link's motion from its rates: the pole, the inflection pole, the curvature of a path, centrodes.

Nothing here knows of collineations or similar triangles: κ = v × a / |v|³ of each path, W = P + a_P / ω².
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import NotAskedError, UnknownNameError
from ..foundation.slotted import replace
from ..mechanism.asked.centres import centre, pair_of
from ..mechanism.asked.curvature import (
    Centrodes,
    ball_point,
    centrode_lengths,
    collineation,
    cusp,
    diameter,
    inflected,
    inflection_pole,
    no_ball,
    path_centre,
    radius,
    return_pole,
)
from ..mechanism.model import FRAME, Mechanism
from ..words import Words
from .motion import Motion
from .planning import plan_for
from .state import Body, Points, cross

NONE = 1e-9  # of the mechanism's own rates and size: less is zero
PARALLEL = 1e-7  # sine of two directions that are told apart
STEPS = 5e-3 / 2.0 ** np.arange(6)  # rad, or of the size where the drive slides: between positions of a difference
CENTRAL = np.array([3, -32, 168, -672, 0, 672, -168, 32, -3]) / 840  # of the eighth order
STRAIGHT = 1e-9  # curvature times the mechanism's size: a path that bends less is straight here


@dataclass(frozen=True)
class Curvatures:
    """The kinematic geometry of one link in the mechanism's own position, which no rate changes."""

    mech: Mechanism
    link: str

    @cached_property
    def motion(self) -> Motion:
        """The motion at a rate of 1 rad/s or 1 m/s, without acceleration."""
        return _moved(self.mech, None)

    @cached_property
    def body(self) -> Body:
        """The link's motion; NotAskedError where it does not turn."""
        body = self.motion.moving(self.link, 2)
        turning = abs(float(body.omega[0])) * self.mech.scale
        speed = abs(complex(body.velocity[0])) + turning
        if turning <= NONE * speed or not speed:
            raise _no_pole(self.mech, self.link)
        return body

    @property
    def pole(self) -> complex:
        """P = r + i v/ω (m)."""
        return complex(_poles(self.body)[0])

    @property
    def inflection_pole(self) -> complex:
        """W = P + a_P/ω² (m): a_P is normal to both centrodes."""
        pull = self.body.acceleration_at(np.array([self.pole]))
        return self.pole + complex((pull / self.body.omega**2)[0])

    @property
    def pole_velocity(self) -> complex:
        """u = i a_P / ω, how fast the pole changes its place, over the ω of the link (m)."""
        return 1j * (self.inflection_pole - self.pole)

    def value(self, key: str) -> complex | float:
        """The quantity with this key (m; angles in deg). UnknownNameError where there is none, NotAskedError where it
        has no value."""
        mech, link = self.mech, self.link
        if key == centre(mech, *pair_of(mech, link, FRAME)).key:
            return self.pole
        if key == inflection_pole(mech, link).key:
            return self.inflection_pole
        if key == return_pole(mech, link).key:
            return 2 * self.pole - self.inflection_pole
        if key == ball_point(mech, link).key:
            return self.ball_point()
        if key == diameter(mech, link).key:
            return abs(self.inflection_pole - self.pole)
        if key == collineation(mech, link).key:
            return self.collineation()
        for point in mech.link(link).points:
            if key == path_centre(point).key:
                return self.path(point)[0]
            if key == radius(point).key:
                return self.path(point)[1]
        raise UnknownNameError(Words(f"构件 {link} 没有 {key}", f"link {link} has no {key}"))

    def path(self, point: str) -> tuple[complex, float]:
        """Centre r + i v |v|² / (v × a) and radius |v|³ / |v × a| of the curvature of a point's path (m)."""
        local = np.array([self.mech.link(self.link).points[point]])
        at, v, a = (f(complex(local[0])) for f in (self.body.point, self.body.velocity_of, self.body.acceleration_of))
        speed, bend = float(np.abs(v)[0]), float(cross(v, a)[0])
        if speed <= NONE * abs(float(self.body.omega[0])) * self.mech.scale:
            raise cusp(point)
        if abs(bend) * self.mech.scale <= STRAIGHT * speed**3:
            raise inflected(point)
        return complex((at + 1j * v * speed**2 / bend)[0]), speed**3 / abs(bend)

    def ball_point(self) -> complex:
        """U = P + s (m): there v, a and the third rate j are parallel, so κ and dκ/ds vanish.

        v × a = 0 and v × j = 0 are circles through P; with q = s/|s|² they are the lines q·a_P = ω² and q·j_P = 3ωα.
        Raises NotAskedError where they are one line, or meet at infinity.
        """
        body, pull, jerk = self.body, *self._rates()
        omega, alpha = float(body.omega[0]), float(body.alpha[0])
        rows, sides = (
            np.array([[pull.real, pull.imag], [jerk.real, jerk.imag]]),
            np.array([omega**2, 3 * omega * alpha]),
        )
        size = np.linalg.norm(rows, axis=1)
        least = NONE * self.mech.scale * np.array([omega**2, abs(omega) ** 3])  # Cardan's circles: j_P is rounding
        if (size <= least).any() or abs(np.linalg.det(rows / size[:, None])) < PARALLEL:
            raise no_ball(self.mech, self.link)
        q = complex(*np.linalg.solve(rows / size[:, None], sides / size))
        if abs(q) * self.mech.scale < NONE:
            raise no_ball(self.mech, self.link)
        return self.pole + q / abs(q) ** 2

    def _rates(self) -> tuple[complex, complex]:
        """a and j of the link's point that is the pole, j by the rates of a and α."""
        rate, turned = self._third_rates()
        body, omega, alpha = self.body, float(self.body.omega[0]), float(self.body.alpha[0])
        arm = self.pole - complex(body.at[0])
        spin = complex(-3 * omega * alpha, turned - omega**3)
        return complex(body.acceleration_at(np.array([self.pole]))[0]), rate + spin * arm

    def _third_rates(self) -> tuple[complex, float]:
        """The rates of a and of α through nine positions, at the step that agrees best with its half.

        The nearer a dead point, the shorter the step must be (the error falls by 2⁸ with each half of it); where the
        mechanism moves evenly, a longer one rounds less.
        """
        steps = STEPS * (self.mech.scale if self.mech.drive.slide else 1.0)
        near = self.mech.drive.position + np.multiply.outer(steps, np.arange(-4, 5))
        moved = _moved(self.mech, tuple(near.ravel().tolist())).moving(self.link, 2)
        pulls, turns = (
            np.broadcast_to(one, near.size).reshape(near.shape) @ CENTRAL / steps
            for one in (moved.acceleration, moved.alpha)
        )
        apart = np.abs(np.diff(pulls)) + self.mech.scale * np.abs(np.diff(turns))
        best = int(np.argmin(apart)) + 1
        return complex(pulls[best]), float(turns[best])

    def collineation(self) -> float:
        """The angle (deg, to 90) of the line PQ to the line of the pins:
        Q is the centre of the two links that carry this one."""
        first, second = self._carriers()
        a, b = (self.motion.moving(name) for name in (first, second))
        turn = float((a.omega - b.omega)[0])
        here = np.zeros(1, np.complex128)
        slip = complex((a.velocity_at(here) - b.velocity_at(here))[0])
        rates = abs(float(a.omega[0])) + abs(float(b.omega[0]))
        far = abs(turn) <= NONE * max(rates, abs(slip) / self.mech.scale)
        axis = 1j * slip if far else 1j * slip / turn - self.pole
        p, q = (complex(self.motion.place(letter)[0]) for letter in self._pins())
        turned = axis.conjugate() * (q - p)
        return float(np.degrees(np.arctan2(abs(turned.imag), abs(turned.real))))

    def _pins(self) -> tuple[str, str]:
        """The two pins of the link at which others carry it."""
        found = [p for p in self.mech.link(self.link).points if len(self.mech.links_at(p)) > 1]
        if len(found) != 2:
            raise NotAskedError(
                Words(
                    f"构件 {self.link} 不是只有两个铰链的连杆，λ 无从定义",
                    f"link {self.link} is no coupler with just two pins: λ is not defined",
                )
            )
        return found[0], found[1]

    def _carriers(self) -> tuple[str, str]:
        first, second = (next(name for name in self.mech.links_at(pin) if name != self.link) for pin in self._pins())
        return first, second

    def centrodes(self, asked: Centrodes) -> dict[str, float]:
        """Both centrodes in chords between their poles (m): of the frame, and of the link."""
        body = _moved(self.mech, asked.drive).moving(self.link, 1)
        with np.errstate(divide="ignore", invalid="ignore"):
            poles = _poles(body)
            carried = (poles - body.at) * np.conj(body.unit)
        if not np.isfinite(poles).all():
            raise _no_pole(self.mech, self.link)
        names = centrode_lengths(self.mech, self.link)
        return {n.key: float(np.abs(np.diff(p)).sum()) for n, p in zip(names, (poles, carried), strict=True)}


def _poles(body: Body) -> Points:
    """P = r + i v/ω, in every position."""
    found: Points = body.at + 1j * body.velocity / body.omega
    return found


def _moved(mech: Mechanism, position: tuple[float, ...] | None) -> Motion:
    drives = tuple(replace(drive, rate=1.0, accel=0.0) for drive in mech.drives)
    unit, asked = replace(mech, drives=drives), np.array(position or [mech.drive.position])
    return Motion(unit, plan_for(unit).bodies(asked, 2, True), asked.shape, 2)


def _no_pole(mech: Mechanism, link: str) -> NotAskedError:
    number = mech.number(link)
    return NotAskedError(
        Words(
            f"构件 {number} 此时不转动，绝对瞬心在无穷远处，没有拐点圆；请另取原动件位置",
            f"link {number} does not turn here: its pole is at infinity and there is no inflection circle; choose "
            "another input position",
        ),
        code="pole-at-infinity",
    )
