"""One run over an array of drive positions: which of them fail, and how angles are followed without jumps."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import DeadPointError
from ..foundation.slotted import dataclass, replace
from ..words import Words
from .state import Bodies, Body, Points, Reals

STEP = 1 / 128  # of a turn, or of the scale for a sliding drive: the stride of a followed path
DEAD = 1e-6  # sine between two links below which rates have no reliable value


def wrapped(angle: Reals) -> Reals:
    """The angle reduced to -π..π."""
    return np.asarray((angle + np.pi) % (2 * np.pi) - np.pi)


@dataclass(frozen=True, slots=True)
class Track:
    """A path of small strides from the problem's own position, put before the positions that are asked for.

    The first `size` elements of every array are the path; `own` is the index of the own position in it; `near`
    is, for every position asked for, the index of the path position just before it.
    """

    size: int
    own: int
    near: NDArray[np.intp]

    def follow(self, angle: Reals) -> Reals:
        """The angle (rad, known up to whole turns) without jumps, starting from its value at the own position; one
        value for all where nothing moves."""
        angle = np.broadcast_to(angle, (self.size + len(self.near),))
        ahead = np.unwrap(angle[self.own : self.size])
        behind = np.unwrap(angle[self.own :: -1])[:0:-1]
        path = np.concatenate([behind, ahead])
        asked = path[self.near] + wrapped(angle[self.size :] - path[self.near])
        return np.concatenate([path, asked])


def track(own: float, stride: float, asked: Reals) -> tuple[Track, Reals]:
    """The path that ends with or beyond all positions asked for, and path and asked positions in one array."""
    count = (asked - own) / stride
    first, last = min(int(np.floor(count.min())), 0), max(int(np.ceil(count.max())), 0)
    path = own + stride * np.arange(first, last + 1)
    return Track(len(path), -first, np.trunc(count).astype(np.intp) - first), np.concatenate([path, asked])


@dataclass(frozen=True, slots=True)
class Run:
    """The drive's positions q (rad or m), whether a failing one raises, and the path where angles are followed."""

    q: Reals
    strict: bool
    unit: str  # how q reads in messages: "deg" or "mm"
    track: Track | None = None
    zero: float = 0.0  # the position of which 0 is told (rad)

    @property
    def asked(self) -> int:
        """Index of the first position that was asked for."""
        return self.track.size if self.track else 0

    def arrived(self, bodies: Bodies) -> tuple[Run, dict[str, Body]]:
        """Without the path, which serves places alone: the positions asked for, and the bodies there."""
        if self.track is None:
            return self, {**bodies}
        asked = slice(self.track.size, None)
        return replace(self, q=self.q[asked], track=None), {name: body.take(asked) for name, body in bodies.items()}

    def first(self, bad: NDArray[np.bool_]) -> int:
        """Index of the first failing position: among those asked for, else on the path to them."""
        mask = np.broadcast_to(bad, self.q.shape)
        late = np.flatnonzero(mask[self.asked :])
        return int(late[0]) + self.asked if len(late) else int(np.flatnonzero(mask)[0])

    def text(self, q: float) -> str:
        """The drive's position as printed: 30°, 12 mm."""
        return f"{np.degrees(q - self.zero):.6g}°" if self.unit == "deg" else f"{1e3 * q:.6g} {self.unit}"

    def alive(self, det: Reals, size: Points | Reals | float, links: tuple[str, ...]) -> Reals:
        """The determinant of the rate equations; DeadPointError (or NaN) where it vanishes against its size."""
        low = np.abs(det) < DEAD * np.abs(size)
        if not low.any():
            return det
        if self.strict and low.ravel()[self.asked if low.size > 1 else 0 :].any():
            where = self.text(float(self.q[self.first(low)]))
            raise DeadPointError(
                Words(
                    f"原动件位于 {where} 时构件 {'、'.join(links)} 处于死点位置，速度没有唯一解；请另取位置",
                    f"links {' and '.join(links)} are at a dead point where the drive stands at {where}: their "
                    "velocities have no single value here; choose another position",
                )
            )
        return np.where(low, np.nan, det)
