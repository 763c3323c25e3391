"""Velocities and accelerations by central differences of the oracle's positions: a check that knows no Jacobian.

v = p'(s) ṡ and a = p''(s) ṡ² + p'(s) s̈ with s the drive's position; p' and p'' from five positions, twice, with steps
of which one is half the other, so that the differences tell their own error.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from vecpoly import oracle
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import At, Key, Kind, Rel
from vecpoly.oracle.motion import Motion
from vecpoly.solution import Solution

from .nearby import natural

STEPS = (
    2e-3,
    2e-4,
    2e-5,
)  # of the drive: rad, or metres over the size of the mechanism; the finer ones near the ends of its range
AGREE = 1e-6  # of the largest rate of the kind
ROUNDED = 1e-14  # of a position: fifty times its last digit
_OFFSETS = np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
_FIRST = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12
_SECOND = np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / 12


def against_differences(mech: Mechanism, solution: Solution) -> str:
    """The first velocity, acceleration, ω or α of the answers that the differences contradict at every step;
    "" where none does."""
    wrong = ""
    for step in STEPS:
        wrong = _contradicted(mech, solution, step)
        if not wrong:
            return ""
    return wrong


def _contradicted(mech: Mechanism, solution: Solution, step: float) -> str:
    try:
        coarse, fine = (_positions(mech, one) for one in (step, step / 2))
    except VecpolyError:
        return ""  # too near the end of the range for five positions
    asked = [
        (key, rel)
        for key, one in solution.answers.items()
        if (rel := _absolute(one.rel)) is not None and _stays(mech, rel)
    ]
    found = {key: (_rate(mech, coarse, rel, step), _rate(mech, fine, rel, step / 2)) for key, rel in asked}
    floor = natural(mech)
    size = {
        kind: max((abs(solution.answers[key].exact) for key, rel in asked if rel.kind is kind), default=0.0)
        for kind in Kind
    }
    size[Kind.ALPHA] = max(size[Kind.ALPHA], size[Kind.OMEGA] ** 2)  # where all turns evenly
    for key, rel in asked:
        answer = solution.answers[key]
        exact = answer.exact if answer.exact_vector is None else answer.exact_vector
        rough, good = found[key]
        if not abs(good - exact) <= AGREE * max(size[rel.kind], floor[rel.unit], 1e-9) + 4 * abs(
            good - rough
        ) + _rounding(mech, fine, rel, step / 2):
            return f"{key} exact {exact}, by central differences {good}"
    return ""


def _positions(mech: Mechanism, step: float) -> Motion:
    drive = mech.drive
    unit = mech.scale if drive.slide else 1.0
    return oracle.solve(mech, drive.position + _OFFSETS * step * unit, order=0)


def _absolute(key: Key) -> Rel | None:
    """The key as an absolute rate of a letter or a link, else None."""
    if isinstance(key, Rel) and key.kind in (Kind.V, Kind.A, Kind.OMEGA, Kind.ALPHA) and key.ref is None:
        return key
    return None


def _stays(mech: Mechanism, rel: Rel) -> bool:
    """Whether the quantity is of a link, or of a letter that stays with one: a pitch point wanders over its links."""
    return not rel.to.point or bool(mech.links_at(rel.to.point) or mech.links_at(str(rel.to)))


def _rate(mech: Mechanism, motion: Motion, rel: Rel, step: float) -> complex:
    drive = mech.drive
    step *= mech.scale if drive.slide else 1.0
    path = _path(mech, motion, rel)
    first = complex(path @ _FIRST) / step
    if rel.kind in (Kind.V, Kind.OMEGA):
        return first * drive.rate
    return complex(path @ _SECOND) / step**2 * drive.rate**2 + first * drive.accel


def _rounding(mech: Mechanism, motion: Motion, rel: Rel, step: float) -> float:
    """What the last digits of the five positions make of the differences."""
    order = 1 if rel.kind in (Kind.V, Kind.OMEGA) else 2
    step *= mech.scale if mech.drive.slide else 1.0
    return float(ROUNDED * np.abs(_path(mech, motion, rel)).max() * abs(mech.drive.rate / step) ** order)


def _path(mech: Mechanism, motion: Motion, rel: Rel) -> NDArray[np.complex128]:
    """The five places of a point (of the link on which it is thought), or the five angles of a link."""
    if rel.kind in (Kind.OMEGA, Kind.ALPHA):
        return np.unwrap(motion.angle(rel.to.link)).astype(np.complex128)
    link = _thought_on(mech, rel.to)
    if link is None:
        return np.asarray(motion.position(rel.to))
    now = motion.position(At(rel.to.point))[2]  # the point of this link that lies there now
    at, turn = motion.origin(link), np.exp(1j * motion.angle(link))
    return np.asarray(at + turn * ((now - at[2]) / turn[2]))


def _thought_on(mech: Mechanism, at: At) -> str | None:
    """The link of B3 where link 3 does not carry B itself."""
    carried = any(
        at.point in mech.link(name).points for name in mech.links_at(at.point) if not at.link or name == at.link
    )
    return at.link if at.link and not carried else None
