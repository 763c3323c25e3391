"""Rates of a mechanism that nobody could build: the angles of one, the lengths of another, or with a term left out.

A calculation that keeps one crank length in the routine for the positions and another in that for the rates solves
J x' = -g'(known) and J x'' = -g''(known, x') with angles that do not close its loops. Joints are differentiated as in
`oracle.rows`; here all links are solved at once, at the poses they are given.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...errors import TableError
from ...mechanism.model import FRAME, Mechanism, Rolling
from ...oracle import Motion
from ...oracle.iterated.rows import Guided, Row, row
from ...oracle.state import Body, Points, Reals
from ...words import Words

Bodies = dict[str, Body]


@dataclass(frozen=True, slots=True, eq=False)
class Loops:
    """The rate equations at given poses: J⁻¹, and the velocities that it gives."""

    mech: Mechanism
    shape: tuple[int, ...]
    rows: tuple[Row, ...]
    links: tuple[str, ...]  # those whose rates are unknown
    inverse: Reals
    moved: Bodies  # with velocities, without accelerations

    @classmethod
    def of(cls, mech: Mechanism, poses: Motion) -> Loops:
        """The lengths of this mechanism at the angles of that motion; TableError where links roll on one another, or
        the drive joins two moving ones."""
        if any(isinstance(joint, Rolling) for joint in mech.joints):
            raise TableError(
                Words(
                    "作纯滚动的构件，其速度、加速度不能与位置分开计算",
                    "links that roll have no rates apart from their positions",
                )
            )
        if any(drive.between for drive in mech.drives):
            raise TableError(
                Words(
                    "驱动加在两活动构件之间时，速度方程不以机架上的原动件为已知",
                    "where a drive acts between two moving links, no link on the frame is known to the rate equations",
                )
            )
        driven = {drive.link for drive in mech.drives}
        rows = tuple(
            r for joint in mech.joints for r in [row(mech, joint, False)] if not {r.a, r.b} <= {*driven, FRAME}
        )
        links = tuple(link.name for link in mech.links if link.name not in driven)
        count = max(poses.shape[0] if poses.shape else 1, 1)
        bodies = {name: posed(body, count) for name, body in poses.bodies.items()}
        bodies |= {name: driven_as(bodies[name], poses.bodies[name]) for name in driven}
        matrix = jacobian(rows, links, bodies, count)
        lost: NDArray[np.bool_] = np.asarray(~np.isfinite(matrix).all(axis=(1, 2)))
        matrix = np.where(lost[:, None, None], np.eye(matrix.shape[1]), matrix)
        inverse = _inverse(matrix)
        inverse[lost] = np.nan
        rates = bent(inverse, stacked(rows, [r.rate(bodies[r.a], bodies[r.b]) for r in rows], count))
        return cls(mech, poses.shape, rows, links, inverse, bodies | _with(bodies, links, rates, np.zeros_like(rates)))

    def motion(self, less: tuple[Points, ...] | None = None) -> Motion:
        """The motion; `less` is taken off the acceleration equations, one entry for each joint."""
        gaps = [r.accel(self.moved[r.a], self.moved[r.b]) for r in self.rows]
        if less is not None:
            gaps = [gap - part for gap, part in zip(gaps, less, strict=True)]
        bends = bent(self.inverse, stacked(self.rows, gaps, len(self.inverse)))
        rates = {name: self.moved[name] for name in self.links}
        bodies = self.moved | {
            name: body.moving(body.velocity, body.omega, bends[:, i, 0] + 1j * bends[:, i, 1], bends[:, i, 2])
            for i, (name, body) in enumerate(rates.items())
        }
        return Motion(self.mech, bodies, self.shape, 2)

    def without(self) -> Iterator[tuple[Words, Motion]]:
        """The motion with one term left out of the accelerations, or with the wrong sign:
        ω² of a link, or a Coriolis term."""
        for name in (*self.links, *(drive.link for drive in self.mech.drives)):
            normal = self._normal(name)
            if max(float(np.nanmax(np.abs(part), initial=0.0)) for part in normal) > 1e-12:
                yield (
                    Words(
                        f"漏掉构件 {name} 的法向项 $ω_{{{name}}}^2$",
                        f"the normal terms $ω_{{{name}}}^2$ of link {name} left out",
                    ),
                    self.motion(normal),
                )
                yield (
                    Words(
                        f"构件 {name} 的法向项 $ω_{{{name}}}^2$ 符号错",
                        f"the normal terms $ω_{{{name}}}^2$ of link {name} with the wrong sign",
                    ),
                    self.motion(tuple(part + part for part in normal)),
                )
        for i, r in enumerate(self.rows):
            if isinstance(r, Guided):
                yield from self._coriolis(i, r)

    def _normal(self, name: str) -> tuple[Points, ...]:
        """What ω² of this link adds to each joint's equations, without the Coriolis terms of its guides."""
        body = self.moved[name]
        still = self.moved | {
            name: body.moving(body.velocity, np.zeros_like(body.omega), body.acceleration, body.alpha)
        }
        return tuple(
            np.zeros(len(self.inverse), np.complex128)
            if isinstance(r, Guided) and r.a == name
            else r.accel(self.moved[r.a], self.moved[r.b]) - r.accel(still[r.a], still[r.b])
            for r in self.rows
        )

    def _coriolis(self, i: int, r: Guided) -> Iterator[tuple[Words, Motion]]:
        a, b = self.moved[r.a], self.moved[r.b]
        ray = b.point(r.pin) - a.point(r.origin)
        sliding = b.velocity_of(r.pin) - a.velocity_of(r.origin) - 1j * a.omega * ray
        term = np.asarray(1j * ((a.unit * r.along).conj() * (-2j * a.omega * sliding)).imag, np.complex128)
        if float(np.nanmax(np.abs(term), initial=0.0)) <= 1e-12:
            return
        blank = [np.zeros(len(self.inverse), np.complex128) for _ in self.rows]
        for times, zh, en in ((1, "漏掉", "left out"), (2, "反向", "with the wrong sense")):
            words = Words(
                f"构件 {r.b} 对构件 {r.a} 的哥氏加速度{zh}",
                f"the Coriolis acceleration of link {r.b} on link {r.a} {en}",
            )
            yield words, self.motion((*blank[:i], term if times == 1 else term + term, *blank[i + 1 :]))


def mixed(mech: Mechanism, poses: Motion) -> Motion:
    """Rates with the lengths of this mechanism at the angles of that motion."""
    return Loops.of(mech, poses).motion()


def posed(body: Body, count: int) -> Body:
    """The same pose, told by the link's own origin, with no rates yet."""
    at, unit = np.broadcast_to(body.point(0j), (count,)), np.broadcast_to(body.unit, (count,))
    still, none = np.zeros(count, np.complex128), np.zeros(count)
    return Body(0j, np.asarray(at), np.asarray(unit), None, still, none, still, none)


def driven_as(body: Body, given: Body) -> Body:
    """The driving link with the rates that are given."""
    return body.moving(
        body.velocity + given.velocity_of(0j),
        body.omega + given.omega,
        body.acceleration + given.acceleration_of(0j),
        body.alpha + given.alpha,
    )


def jacobian(rows: tuple[Row, ...], links: tuple[str, ...], bodies: Bodies, count: int) -> Reals:
    matrix = np.zeros((count, 2 * len(rows), 3 * len(links)))
    for i, r in enumerate(rows):
        for name, block in zip((r.a, r.b), r.jac(bodies[r.a], bodies[r.b]), strict=True):
            if name in links:
                at = slice(3 * links.index(name), 3 * links.index(name) + 3)
                matrix[:, 2 * i, at], matrix[:, 2 * i + 1, at] = block.real, block.imag
    return matrix


def _inverse(matrix: Reals) -> Reals:
    """J⁻¹; at a dead point the nearest thing to it."""
    try:
        return np.asarray(np.linalg.inv(matrix), np.float64)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.pinv(matrix), np.float64)


def stacked(rows: tuple[Row, ...], gaps: list[Points], count: int) -> Reals:
    full = [np.broadcast_to(gap, (count,)) for gap in gaps]
    return np.stack([part for gap in full for part in (gap.real, gap.imag)], axis=1)


def bent(inverse: Reals, gaps: Reals) -> Reals:
    """-J⁻¹ g as positions × links × 3."""
    return (inverse @ -gaps[..., None]).reshape(len(gaps), -1, 3)


def _with(bodies: Bodies, links: tuple[str, ...], rates: Reals, bends: Reals) -> Bodies:
    return {
        name: bodies[name].moving(
            rates[:, i, 0] + 1j * rates[:, i, 1], rates[:, i, 2], bends[:, i, 0] + 1j * bends[:, i, 1], bends[:, i, 2]
        )
        for i, name in enumerate(links)
    }
