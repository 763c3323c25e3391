"""Where the links of a mechanism are and how they move, by central differences of the oracle's positions alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from vecpoly import oracle
from vecpoly.mechanism.loads import Loads
from vecpoly.mechanism.model import FRAME, Mechanism

STEP, FINEST = 2e-3, 2e-5  # of the drive (rad, or sizes of the mechanism): finer where places run away within a step
ROUGH = 0.1  # of the inertia forces: differences that are off by more tell nothing
LEAP = 0.4  # of a rate: how far two of its differences may disagree; at the very end of a range they do by 0.37
ROUNDING = 1e-9  # rad, of links that only translate
_OFFSETS = np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
_FIRST, _SECOND = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12, np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / 12


@dataclass(frozen=True, slots=True)
class Moving:
    """Places, velocities and accelerations by central differences of five positions."""

    mech: Mechanism
    motion: Any
    step: float

    @classmethod
    def of(cls, mech: Mechanism, step: float = STEP) -> Moving:
        """Raises a VecpolyError near the ends of the range."""
        step *= mech.scale if mech.drive.slide else 1.0
        return cls(mech, oracle.solve(mech, mech.drive.position + _OFFSETS * step, order=0), step)

    @property
    def leaps(self) -> bool:
        """Whether the five positions belong to two assemblies, as beside a turning point that the drive does not meet:
        then the outer two of them tell other rates than the inner two, and differences tell nothing."""
        angles = np.array([self._angles(link) for link in links_of(self.mech)])
        inner, outer = (angles[:, 3] - angles[:, 1]) / 2, (angles[:, 4] - angles[:, 0]) / 4
        return bool(np.max(abs(outer - inner)) > LEAP * np.max(abs(inner)) + ROUNDING)

    def path(self, link: str, local: complex) -> np.ndarray:
        """The five places of a point of a link."""
        if link == FRAME:
            return np.full(5, local)
        return np.asarray(self.motion.origin(link) + np.exp(1j * self.motion.angle(link)) * local)

    def place(self, link: str, local: complex) -> complex:
        """Now."""
        return complex(self.path(link, local)[2])

    def velocity(self, link: str, local: complex) -> complex:
        """m/s."""
        return self._first(self.path(link, local)) * self.mech.drive.rate

    def acceleration(self, link: str, local: complex) -> complex:
        """m/s²."""
        path, drive = self.path(link, local), self.mech.drive
        return complex(path @ _SECOND) / self.step**2 * drive.rate**2 + self._first(path) * drive.accel

    def omega(self, link: str) -> float:
        """rad/s."""
        return 0.0 if link == FRAME else self._first(self._angles(link)).real * self.mech.drive.rate

    def alpha(self, link: str) -> float:
        """rad/s²."""
        angles, drive = self._angles(link), self.mech.drive
        return (complex(angles @ _SECOND) / self.step**2).real * drive.rate**2 + self._first(angles).real * drive.accel

    def local(self, link: str, place: complex) -> complex:
        """The point of a link that is here now."""
        if link == FRAME:
            return place
        return complex((place - self.motion.origin(link)[2]) * np.exp(-1j * self.motion.angle(link)[2]))

    def _angles(self, link: str) -> np.ndarray:
        return np.unwrap(self.motion.angle(link))

    def _first(self, path: np.ndarray) -> complex:
        return complex(path @ _FIRST) / self.step


def links_of(mech: Mechanism) -> tuple[str, ...]:
    """The links that the problem has: no blocks that are thought about pins in slots."""
    return tuple(name for name in mech.bodies if name[0].isdigit())


def reaction_key(mech: Mechanism, by: str, on: str) -> str:
    """R_12; R_1_11 where a number has two digits."""
    numbers = mech.number(by), mech.number(on)
    return "R_" + ("_" if max(map(len, numbers)) > 1 else "").join(numbers)


def told_by_differences(mech: Mechanism, loads: Loads, step: float = STEP) -> tuple[Moving, Moving]:
    """Five positions, and five twice as far apart; nearer where the accelerations of both are not alike."""
    fine, coarse = Moving.of(mech, step), Moving.of(mech, 2 * step)
    if step <= FINEST or slack_of(fine, coarse, loads) <= ROUGH * inertia_forces(fine, loads):
        return fine, coarse
    return told_by_differences(mech, loads, step / 10)


def inertia_forces(moving: Moving, loads: Loads, less: Moving | None = None) -> float:
    """The sum of their sizes (N), couples over the size of the mechanism; less: of what they differ from these."""
    found = 0.0
    for mass in loads.masses if loads.inertia else ():
        at = moving.mech.link(mass.link).points[mass.centre]
        a, alpha = moving.acceleration(mass.link, at), moving.alpha(mass.link)
        if less is not None:
            a, alpha = a - less.acceleration(mass.link, at), alpha - less.alpha(mass.link)
        found += mass.mass * abs(a) + mass.inertia * abs(alpha) / moving.mech.scale
    return found


def slack_of(fine: Moving, coarse: Moving, loads: Loads) -> float:
    """How far inertia forces (N) may be off, since differences are differences."""
    return 4 * inertia_forces(fine, loads, less=coarse)
