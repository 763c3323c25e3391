"""The answer: places, angles, velocities and accelerations of every link and letter, exactly, over all positions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import NotAskedError, UnknownNameError
from ..mechanism.model import CamProfile, Contact, Mechanism, Rolling
from ..names import At, Rel
from ..words import Words
from .closed.cammed import curvature_centre
from .closed.contact import touching
from .closed.pitch import pitch_point
from .state import Body, Points, Reals
from .symbols import value


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """A solved mechanism. Every answer has the shape of the positions asked for (a number for one position).

    Points and their rates are complex x + iy in m, m/s, m/s²; angles in rad, omega in rad/s, alpha in rad/s².
    """

    mech: Mechanism
    bodies: Mapping[str, Body]
    shape: tuple[int, ...]
    order: int

    def origin(self, link: str) -> Points:
        """Place of the link's own origin (m)."""
        return self._points(self.body(link).point(0j))

    def angle(self, link: str) -> Reals:
        """φ of the link's x axis (rad); within -π..π, but followed without jumps where gears roll."""
        body = self.body(link)
        return self._reals(np.angle(body.unit) if body.turn is None else body.turn)

    def omega(self, link: str) -> Reals:
        """ω of the link (rad/s)."""
        return self._reals(self.moving(link).omega)

    def alpha(self, link: str) -> Reals:
        """α of the link (rad/s²)."""
        return self._reals(self.moving(link, 2).alpha)

    def position(self, point: str | At) -> Points:
        """Place of a letter, such as C, or C2 where it is thought on a link (m)."""
        return self._points(self.place(point))

    def velocity(self, point: str | At) -> Points:
        """Velocity of a point of a link; without a link, of the first that carries the letter (m/s)."""
        link, local = self.locate(point)
        body = self.moving(link)
        speed = body.velocity_at(self.place(point)) if local is None else body.velocity_of(local)
        return self._points(speed)

    def acceleration(self, point: str | At) -> Points:
        """Acceleration of a point of a link (m/s²)."""
        link, local = self.locate(point)
        body = self.moving(link, 2)
        pull = body.acceleration_at(self.place(point)) if local is None else body.acceleration_of(local)
        return self._points(pull)

    def value(self, rel: Rel) -> Points | Reals:
        """The quantity with this key: complex for a vector, real for ω and α.

        Raises UnknownNameError where a letter or link does not exist.
        """
        return value(self, rel)

    def point_with(self, link: str, *, velocity: complex | None = None, acceleration: complex | None = None) -> Points:
        """Place of the link's point that has this velocity, or this acceleration (m).

        r = r_0 + (v - v_0) / iω, or r = r_0 + (a - a_0) / (iα - ω²). NotAskedError where no such point exists.
        """
        if velocity is not None and acceleration is None:
            body = self.moving(link)
            gap, turn, what = velocity - body.velocity, 1j * body.omega, Words("速度", "velocity")
        elif acceleration is not None and velocity is None:
            body = self.moving(link, 2)
            gap, turn = acceleration - body.acceleration, 1j * body.alpha - body.omega**2
            what = Words("加速度", "acceleration")
        else:
            raise NotAskedError(
                Words(
                    "求点时请只给速度或只给加速度",
                    "ask for the point with a velocity, or for the point with an acceleration",
                )
            )
        if (turn == 0).any():
            raise NotAskedError(
                Words(
                    f"构件 {link} 此时不转动，各点{what.zh}相同",
                    f"link {link} does not turn here: all its points have the same {what.en}",
                )
            )
        return self._points(body.at + gap / turn)

    def velocity_pole(self, link: str) -> Points:
        """The link's instant centre: its point with no velocity (m)."""
        return self.point_with(link, velocity=0j)

    def acceleration_pole(self, link: str) -> Points:
        """The link's point with no acceleration (m)."""
        return self.point_with(link, acceleration=0j)

    def body(self, link: str) -> Body:
        """The link's motion; UnknownNameError where there is no such link."""
        if link not in self.bodies:
            names = ", ".join(self.bodies)
            raise UnknownNameError(Words(f"没有构件 {link}；已有：{names}", f"there is no link {link}; known: {names}"))
        return self.bodies[link]

    def moving(self, link: str, order: int = 1) -> Body:
        """The link's motion with rates up to this order; NotAskedError where it was solved without."""
        if self.order < order:
            raise NotAskedError(
                Words(
                    f"求解时取 order={self.order}；求这些量须取 order={order}",
                    f"solved with order={self.order}; solve with order={order} for these rates",
                )
            )
        return self.body(link)

    def locate(self, point: str | At) -> tuple[str, complex | None]:
        """The link on which the point is thought, and its place there (None: where the letter is now)."""
        at = self.at(point)
        if at.link:
            self.body(at.link)
        if (carried := self._wandering(at)) is not None:
            return at.link or carried.link, None
        if at.link:
            return at.link, self.mech.link(at.link).points.get(at.point)
        carriers = self.mech.links_at(at.point)
        if carriers:
            return carriers[0], self.mech.link(carriers[0]).points[at.point]
        touch = self._contact(at.point)
        return (touch.disc.link if touch else self._pitch(at.point).gear.link), None

    def at(self, point: str | At) -> At:
        """The letter and its link: B3 is B of link 3 unless B3 is itself a letter."""
        at = point if isinstance(point, At) else At(point)
        if at.link and self._is_letter(at.point + at.link):
            return At(at.point + at.link)
        if self._is_letter(at.point):
            return at
        letter = at.point.rstrip("0123456789")
        if not at.link and letter != at.point and self._is_letter(letter):
            return At(letter, at.point[len(letter) :])
        raise UnknownNameError(
            Words(
                f"没有点 {at}；已有：{', '.join(sorted(self._letters()))}",
                f"there is no point {at}; known: {', '.join(sorted(self._letters()))}",
            )
        )

    def place(self, point: str | At) -> Points:
        """Where the letter is now, of whatever link (unshaped)."""
        at = self.at(point)
        if (carried := self._wandering(at)) is not None:
            return curvature_centre(carried, self.bodies)
        carriers = self.mech.links_at(at.point)
        if not carriers:
            touch = self._contact(at.point)
            return (
                touching(self.mech, self.bodies, touch)[0]
                if touch
                else pitch_point(self._pitch(at.point), self.mech, self.bodies)
            )
        link = at.link if at.link in carriers else carriers[0]
        return self.bodies[link].point(self.mech.link(link).points[at.point])

    def _wandering(self, at: At) -> CamProfile | None:
        """The cam of which this is the centre of curvature."""
        return next((cam for cam in self.mech.cams if cam.centre == at.point), None)

    def _letters(self) -> set[str]:
        pitch = {joint.point for joint in self.mech.joints if isinstance(joint, Rolling)}
        pitch.update(contact.point for contact in self.mech.contacts)
        return pitch.union(self.mech.frame, *(link.points for link in self.mech.links))

    def _is_letter(self, name: str) -> bool:
        return name in self._letters()

    def _contact(self, letter: str) -> Contact | None:
        return next((contact for contact in self.mech.contacts if contact.point == letter), None)

    def _pitch(self, letter: str) -> Rolling:
        return next(j for j in self.mech.joints if isinstance(j, Rolling) and j.point == letter)

    def _points(self, values: Points) -> Points:
        shaped: Points = np.broadcast_to(values, self.shape or (1,)) if values.shape != self.shape else values
        return shaped if self.shape else shaped[0]

    def _reals(self, values: Reals) -> Reals:
        shaped: Reals = np.broadcast_to(values, self.shape or (1,)) if values.shape != self.shape else values
        return shaped if self.shape else shaped[0]
