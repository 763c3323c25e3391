"""Pressure angles from constraints: the force that a link of two joints can pass on, and the motion that its follower
can have, each a null space of the equations of the joints.

Nothing here knows of two-force members or of normals: what the joints leave free is the twist t = (v_x, v_y, ω) about
the frame's origin, what the equilibrium of the driving link leaves free is the wrench w = (F_x, F_y, M); α is the angle
of the force to the velocity of the point on which it acts.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..mechanism.asked.pressure import Driven
from ..mechanism.model import Joint, Mechanism, Prismatic, Revolute
from .motion import Motion
from .planning import plan_for

Matrix = NDArray[np.float64]


@dataclass(frozen=True)
class Pressures:
    """Pressure and transmission angles of a mechanism in its own position."""

    mech: Mechanism

    @cached_property
    def motion(self) -> Motion:
        """Where the links are; no rate matters."""
        at = np.array([self.mech.drive.position], dtype=np.float64)
        return Motion(self.mech, plan_for(self.mech, own=True).bodies(at, 0, True), (), 0)

    def alpha(self, driven: Driven) -> float:
        """The acute angle (deg) of the force on a driven link to the velocity of the point on which it acts."""
        turned = self._force(driven).conjugate() * self._velocity(driven)
        return float(np.degrees(np.arctan2(abs(turned.imag), abs(turned.real))))

    def gamma(self, driven: Driven) -> float:
        """90° − α (deg)."""
        return 90.0 - self.alpha(driven)

    def _force(self, driven: Driven) -> complex:
        """The force that holds the driving link in balance, as its last joint passes it on: λ A = 0."""
        outer, inner = (self._rows(joint) for joint in driven.joints)
        balance = _null(np.vstack((outer, inner)).T)
        wrench = balance[len(outer) :] @ inner
        return complex(wrench[0], wrench[1])

    def _velocity(self, driven: Driven) -> complex:
        """The velocity that the driven link's joint with the frame allows its point: A t = 0."""
        twist = _null(self._rows(driven.seat))
        at = complex(self.motion.position(driven.at))
        return complex(twist[0], twist[1]) + 1j * float(twist[2]) * at / self.mech.scale

    def _rows(self, joint: Joint) -> Matrix:
        """The constraints of a joint on the relative twist; lengths over the mechanism's size."""
        if isinstance(joint, Revolute):
            at = complex(self.motion.position(joint.point)) / self.mech.scale
            return np.array([[1.0, 0.0, -at.imag], [0.0, 1.0, at.real]])
        assert isinstance(joint, Prismatic)
        at = complex(self.motion.position(joint.pin)) / self.mech.scale
        along = complex(self.motion.bodies[joint.guide].unit[0]) * np.exp(1j * joint.direction)
        across = 1j * along
        return np.array([[0.0, 0.0, 1.0], [across.real, across.imag, (across.conjugate() * 1j * at).real]])


def _null(rows: Matrix) -> Matrix:
    """The one vector that the rows leave free: a hinge and a slide, two hinges apart leave one, as does one joint."""
    turned: Matrix = np.linalg.svd(rows)[2]
    assert rows.shape[1] - np.linalg.matrix_rank(rows) == 1
    free: Matrix = turned[-1]
    return free
