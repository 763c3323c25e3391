"""The follower of a plate cam, placed by its law of motion: s(φ), ds/dφ, d²s/dφ², and the profile by formula."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...errors import NoMethodError
from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import Group
from ...mechanism.model import FRAME, CamProfile, Contact, Mechanism, Prismatic, Rack, Revolute, Side
from ...words import Words
from ..run import Run
from ..state import NONE, STILL, Bodies, Body, Points, Reals, cross

if TYPE_CHECKING:
    from ..devices.cams.followed import Followed


def profile_at(mech: Mechanism, letter: str) -> CamProfile | None:
    """The cam with this contact."""
    return next((one for one in mech.cams if one.point == letter), None)


def law_of(profile: CamProfile) -> tuple[int, int]:
    """The sign of the arm's ω on the rise; the sense in which the cam is meant to turn."""
    from ...devices.cams.cam import Cam  # late: pydantic, which checks its data, is slow to load

    assert isinstance(profile.cam, Cam)
    return -profile.cam.side, profile.cam.sense


def followed(profile: CamProfile, bodies: Bodies) -> Followed:
    """The motion of the follower, and the profile, at the angles at which the cam stands."""
    from ...devices.cams.cam import Cam
    from ..devices.cams.followed import follow

    assert isinstance(profile.cam, Cam)
    return follow(profile.cam, np.angle(bodies[profile.link].unit))


def curvature_centre(profile: CamProfile, bodies: Bodies) -> Points:
    """Where the centre of curvature of the profile at the contact is (m)."""
    return _on_cam(profile, bodies, followed(profile, bodies).centre)


def touched(contact: Contact, profile: CamProfile, bodies: Bodies) -> tuple[Points, Points]:
    """The point of contact (m), and the unit normal along which the contact's disc is pressed."""
    found, unit = followed(profile, bodies), bodies[profile.link].unit
    into = unit * found.inward
    return _on_cam(profile, bodies, found.edge), into if contact.disc.link == profile.link else -into


def _on_cam(profile: CamProfile, bodies: Bodies, local: Points) -> Points:
    body = bodies[profile.link]
    return body.at + body.unit * local  # the pivot is the cam's first point


def _upright(size: Reals) -> Points:
    return np.asarray(1j * size, np.complex128)


@dataclass(frozen=True, slots=True)
class Cammed:
    """A follower and the link that stands for its contact: the first by the law, the second between the centres."""

    group: Group
    profile: CamProfile
    contact: Contact
    mech: Mechanism
    joint: str
    sign: float = 1.0
    two: bool = False

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """The follower where the law has it."""
        name, found = self.profile.follower, followed(self.profile, bodies)
        body = self._turned(found) if self._pin() else self._slid(found)
        return {name: body, self.contact.substitute: self._between({**bodies, name: body}, found)}

    def _turned(self, found: Followed) -> Body:
        """An arm towards its tip, or with its face at right angles to the normal."""
        pin, link = self._pin(), self.mech.link(self.profile.follower)
        at, local = self.mech.frame[pin], link.points[pin]
        if isinstance(self.contact.on, Rack):
            unit = -1j * found.tip / np.abs(found.tip) * complex(np.exp(-1j * self.contact.on.direction)) * self._way()
        else:
            arm = link.points[self.profile.end] - local
            unit = (self.mech.frame[self.profile.pivot] + found.tip - at) / arm
        return Body(local, np.full(1, at, np.complex128), np.asarray(unit / np.abs(unit), np.complex128))

    def _way(self) -> int:
        """+1 where the cam lies to the right of the face's direction, −1 to its left."""
        return 1 if self.contact.side is Side.RIGHT else -1

    def _slid(self, found: Followed) -> Body:
        """The tip where the law has it; of a face the foot of the axis, while the pin keeps to its guide."""
        link, guide, at = self.mech.link(self.profile.follower), self._guide(), found.tip
        at = self.mech.frame[self.profile.pivot] + at
        unit = complex(np.exp(1j * (guide.direction + guide.turn)))
        if not isinstance(self.contact.on, Rack):
            return Body(link.points[self.profile.end], at, np.full(1, unit, np.complex128))
        pin = link.points[guide.pin]
        across = guide.origin + 1j * guide.offset * complex(np.exp(1j * guide.direction))
        down = (unit * (self.contact.on.origin - pin)).imag
        return Body(pin, across.real + _upright(at.imag - down), np.full(1, unit, np.complex128))

    def _pin(self) -> str:
        """The letter of the hinge on the frame; "" where the follower slides."""
        pins = (j for j in self.mech.joints if isinstance(j, Revolute))
        return next((j.point for j in pins if self._fixed(j.a, j.b)), "")

    def _fixed(self, a: str, b: str) -> bool:
        return {a, b} == {self.profile.follower, FRAME}

    def _guide(self) -> Prismatic:
        return next(j for j in self.mech.joints if isinstance(j, Prismatic) and self._fixed(j.guide, j.block))

    def _between(self, bodies: Bodies, found: Followed) -> Body:
        """The bar from the first letter of the substitute to its second, or the block along the face.

        A bar is carried by the follower's tip, on which other groups may hang: its length changes as the profile bends.
        """
        centre = _on_cam(self.profile, bodies, found.centre)
        link, follower = self.mech.link(self.contact.substitute), bodies[self.profile.follower]
        if isinstance(self.contact.on, Rack):
            return Body(0j, centre, follower.unit * complex(np.exp(1j * self.contact.on.direction)))
        end = follower.point(self.mech.link(self.profile.follower).points[self.profile.end])
        ray = end - centre if next(iter(link.points)) == self.profile.centre else centre - end
        return Body(link.points[self.profile.end], end, ray / np.abs(ray))

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """ds/dt = s′ ω, d²s/dt² = s″ ω² + s′ α, ω and α those of the cam in its sense."""
        cam, found, name = bodies[self.profile.link], followed(self.profile, bodies), self.profile.follower
        way, sense = law_of(self.profile)
        speed = found.slope * sense * cam.omega
        gain = found.bend * cam.omega**2 + found.slope * sense * cam.alpha
        body = bodies[name]
        turning = body.moving(STILL, way * speed, STILL, way * gain)
        moving = turning if self._pin() else body.moving(_upright(speed), NONE, _upright(gain), NONE)
        return {name: moving, self.contact.substitute: self._moving({**bodies, name: moving}, found)}

    def _moving(self, bodies: Bodies, found: Followed) -> Body:
        """The bar's ω and α from the motion of both ends; the block turns with the face."""
        bar, cam, follower = bodies[self.contact.substitute], bodies[self.profile.link], bodies[self.profile.follower]
        centre = _on_cam(self.profile, bodies, found.centre)
        v, a = cam.velocity_at(centre), cam.acceleration_at(centre)
        if isinstance(self.contact.on, Rack):
            return bar.moving(v, follower.omega, a, follower.alpha)
        end = self.mech.link(self.profile.follower).points[self.profile.end]
        ray = follower.point(end) - centre
        relative = follower.velocity_of(end) - v, follower.acceleration_of(end) - a
        omega, alpha = (cross(ray, part) / np.abs(ray) ** 2 for part in relative)
        return bar.moving(follower.velocity_of(end), omega, follower.acceleration_of(end), alpha)

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """The law places the follower at every angle."""
        return np.zeros(1)


def cammed(mech: Mechanism, group: Group) -> Cammed | None:
    """The step of a follower and its substitute; raises NoMethodError where the profile cannot be made."""
    for profile in mech.cams:
        contact = next(one for one in mech.contacts if one.point == profile.point)
        if set(group.links) == {profile.follower, contact.substitute}:
            _refuse_spoilt(profile)
            return Cammed(group, profile, contact, mech, profile.end)
    return None


def _refuse_spoilt(profile: CamProfile) -> None:
    from ...devices.cams.cam import Cam
    from ..devices.cams.followed import spoilt

    assert isinstance(profile.cam, Cam)
    if spoilt(profile.cam):
        raise NoMethodError(
            Words(
                f"构件 {profile.link} 的凸轮廓线失真，从动件不能按运动规律运动；",
                f"the profile of cam {profile.link} is undercut, so that the follower cannot keep to its law; ",
            )
            + profile.cam.follower.remedy,
            code="undercut",
        )
