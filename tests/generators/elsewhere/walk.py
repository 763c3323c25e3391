"""A third party for other positions of the drive: the mechanism walked there in small strides, by its joints alone.

Unknown are the places and angles of all links at once. Every stride goes on in the direction in which they move, and
Newton's method closes the joints from there: no group, no side and no statement is known to it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vecpoly import oracle
from vecpoly.mechanism.model import FRAME, Mechanism, Prismatic, Revolute

STRIDE = np.radians(1.0)
FINEST = 2.0**-12  # of a stride: shorter ones are not tried
CLOSED = 1e-12  # of the mechanism's size: what is left of a gap
SINGULAR = 1e6
TINY = 1e-20
NEAR = 0.05  # of the mechanism's size, or rad: farther from where the last strides lead lies another assembly
Reals = NDArray[np.float64]


@dataclass(slots=True)
class Walk:
    """Places (over the mechanism's size) and angles of the links, x, y, φ of each, at every stride from the own
    position on."""

    mech: Mechanism
    sense: int
    ways: list[float]  # of the drive, from its own position
    states: list[Reals]

    @classmethod
    def whole(cls, mech: Mechanism, sense: int, most: float = 2 * np.pi) -> Walk:
        """As far as the mechanism goes in this sense, at most so far (rad, or m over the mechanism's size)."""
        motion = oracle.solve(mech, order=0)
        names = [link.name for link in mech.links]
        own = [_flat(complex(motion.origin(one)) / mech.scale, float(motion.angle(one))) for one in names]
        walk = cls(mech, sense, [0.0], [np.concatenate(own)])
        while walk.ways[-1] < most - 1e-12 and walk.strides(min(walk.ways[-1] + STRIDE, most)):
            pass
        return walk

    def strides(self, way: float) -> bool:
        """Go on so far, in shorter strides where it is not clear how; whether it succeeded."""
        shorter = way - self.ways[-1]
        while self.ways[-1] < way:
            shorter = min(shorter, way - self.ways[-1])
            found = self.closed(self.ways[-1] + shorter)
            if found is not None:
                self.ways.append(self.ways[-1] + shorter)
                self.states.append(found)
            elif (shorter := shorter / 2) < FINEST * STRIDE:
                return False
        return True

    def closed(self, way: float) -> Reals | None:
        """The links so far on, from where the last two strides lead; None where it is not clear."""
        guess = state = self.led(way)
        for _ in range(8):
            gap, slope = _gaps(self.mech, state, self.sense * way)
            if not np.isfinite(gap).all() or np.abs(gap).max() < CLOSED:
                break
            state = np.asarray(state + np.linalg.lstsq(slope, -gap, rcond=None)[0], np.float64)
        else:
            return None
        moved = np.abs(state - self.states[-1]).max()
        return state if np.abs(state - guess).max() < 0.25 * moved + 1e-9 and moved < NEAR else None

    def led(self, way: float) -> Reals:
        """Where the joints lead; at a change point, where they leave it open, where the last two states do."""
        _, slope = _gaps(self.mech, self.states[-1], self.sense * self.ways[-1])
        if len(self.ways) < 2 or np.linalg.cond(slope) < SINGULAR:
            pace = np.linalg.lstsq(slope, np.eye(len(slope))[-1] * self.sense, rcond=None)[0]
        else:
            pace = (self.states[-1] - self.states[-2]) / (self.ways[-1] - self.ways[-2])
        return np.asarray(self.states[-1] + (way - self.ways[-1]) * pace, np.float64)

    def place(self, state: Reals, link: str, local: complex) -> complex:
        """Of a point of a link (m)."""
        number = [one.name for one in self.mech.links].index(link)
        x, y, turn = state[3 * number : 3 * number + 3]
        return complex(self.mech.scale * complex(x, y) + np.exp(1j * turn) * local)

    def path(self, letter: str) -> NDArray[np.complex128]:
        """Of a lettered point (m)."""
        link = self.mech.links_at(letter)[0]
        local = self.mech.link(link).points[letter]
        return np.array([self.place(state, link, local) for state in self.states])


def both_ways(mech: Mechanism, most: float = 2 * np.pi) -> tuple[Walk, Walk]:
    """Backward, and forward."""
    return Walk.whole(mech, -1, most), Walk.whole(mech, 1, most)


def _flat(at: complex, turn: float) -> Reals:
    return np.array([np.real(at), np.imag(at), turn], np.float64)


def _gaps(mech: Mechanism, state: Reals, way: float) -> tuple[Reals, Reals]:
    """By how much the joints fail to close, and how that changes with the state: exactly, by tiny imaginary parts."""
    rows = _rows(mech, state[:, None] + 1j * TINY * np.eye(len(state)), way)
    return np.asarray(rows[:, 0].real, np.float64), np.asarray(rows.imag / TINY, np.float64)


def _rows(mech: Mechanism, state: NDArray[Any], way: float) -> NDArray[Any]:
    """x and y apart, so that both may be complex: hinges and slides two rows each, the drive one."""
    rows: list[Any] = []
    for joint in mech.joints:
        match joint:
            case Revolute(point=p, a=a, b=b):
                (x, y), (u, v) = (_at(mech, state, link, mech.link(link).points[p]) for link in (a, b))
                rows += [x - u, y - v]
            case Prismatic():
                rows += _slide(mech, state, joint)
            case _:
                raise NotImplementedError
    return np.array([*rows, _driven(mech, state) - mech.drive.position / _unit(mech) - way])


def _body(mech: Mechanism, state: NDArray[Any], link: str) -> tuple[Any, Any, Any]:
    if link == FRAME:
        return 0.0, 0.0, 0.0
    n = 3 * [one.name for one in mech.links].index(link)
    return state[n], state[n + 1], state[n + 2]


def _at(mech: Mechanism, state: NDArray[Any], link: str, local: complex) -> tuple[Any, Any]:
    x, y, turn = _body(mech, state, link)
    u, v, c, s = local.real / mech.scale, local.imag / mech.scale, np.cos(turn), np.sin(turn)
    return x + u * c - v * s, y + u * s + v * c


def _slide(mech: Mechanism, state: NDArray[Any], joint: Prismatic) -> list[Any]:
    """The pin stays so far beside the line, the block leans as it does."""
    turn = _body(mech, state, joint.guide)[2] + joint.direction
    x, y = _at(mech, state, joint.guide, joint.origin)
    u, v = _at(mech, state, joint.block, mech.link(joint.block).points[joint.pin])
    aside = (v - y) * np.cos(turn) - (u - x) * np.sin(turn) - joint.offset / mech.scale
    return [aside, np.sin(_body(mech, state, joint.block)[2] - turn - joint.turn)]


def _unit(mech: Mechanism) -> float:
    return mech.scale if mech.drive.slide else 1.0


def _driven(mech: Mechanism, state: NDArray[Any]) -> Any:
    """The drive's coordinate: its angle, or its travel over the mechanism's size."""
    drive = mech.drive
    if not drive.slide:
        return _body(mech, state, drive.link)[2]
    guides = (joint for joint in mech.joints if isinstance(joint, Prismatic))
    joint = next(one for one in guides if {one.block, one.guide} == {FRAME, drive.link})
    u, v = _at(mech, state, joint.block, mech.link(joint.block).points[joint.pin])
    ahead, origin = np.exp(1j * joint.direction), joint.origin / mech.scale
    return (u - origin.real) * ahead.real + (v - origin.imag) * ahead.imag
