"""Moment, work and inertia of the equivalent link over a period, as polynomials between the places where loads jump."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial import legendre

from ...errors import EquilibriumError
from ...foundation.slotted import replace
from ...mechanism.laws.rated import refuse_rated
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...words import Words
from ..forces.laws.corners import corners
from ..forces.laws.drives import drive_range
from ..forces.laws.returning import turns_of
from ..pieces import followed
from ..state import Reals
from .reduced import reduce

PIECE = np.radians(10.0)  # no piece of the period is longer
SAME = 1e-11  # rad: cuts nearer than this are one
LITTLE = 1e-9  # of the work done and taken over a period: what is left of it is rounding


@dataclass(frozen=True, eq=False, kw_only=True)
class Course:
    """One period of a machine whose loads do not know its speed; ψ is the drive's way in the sense of its motion (rad).

    cuts: where pieces begin and end. moments, inertias: Legendre's coefficients of M (N·m, positive where it drives)
    and J_e (kg·m²), a row a piece. works: those of ∫ M dψ from the beginning of the period (J). constant: the moment
    that is the same all through and is part of M. sense: +1 where φ = ψ, −1 where φ = −ψ.
    """

    cuts: Reals
    moments: Reals
    inertias: Reals
    works: Reals
    constant: float
    sense: float

    @property
    def period(self) -> float:
        """2π, or 4π (rad)."""
        return float(self.cuts[-1] - self.cuts[0])

    def degrees(self, psi: float) -> float:
        """The drive's angle φ there, from 0° on through the period."""
        return float(np.degrees((self.sense * psi) % self.period) % np.degrees(self.period))

    def sampled(self, points: int) -> tuple[Reals, Reals]:
        """Places in every piece, its ends included (a row a piece), and where they lie between −1 and 1."""
        at = np.linspace(-1.0, 1.0, points)
        left, half = self.cuts[:-1, None], np.diff(self.cuts)[:, None] / 2
        return left + half * (1 + at), at

    def places(self, piece: int, x: float) -> float:
        """ψ of a place of a piece between −1 and 1."""
        return float(self.cuts[piece] + (self.cuts[piece + 1] - self.cuts[piece]) / 2 * (1 + x))

    def of_pieces(self, rows: Reals, at: Reals) -> Reals:
        """Values at the same places of every piece, a row a piece."""
        return np.asarray(legendre.legval(at, rows.T), np.float64)

    def at(self, rows: Reals, psi: Reals) -> Reals:
        """Values anywhere in the period."""
        piece = np.clip(np.searchsorted(self.cuts, psi, "right") - 1, 0, len(self.cuts) - 2)
        x = 2 * (psi - self.cuts[piece]) / (self.cuts[piece + 1] - self.cuts[piece]) - 1
        powers = legendre.legvander(x, rows.shape[1] - 1)
        return np.asarray((powers * rows[piece]).sum(axis=1), np.float64)

    @property
    def slopes(self) -> Reals:
        """Coefficients of dJ_e/dψ."""
        half = np.diff(self.cuts)[:, None] / 2
        return np.asarray(legendre.legder(self.inertias, axis=1) / half, np.float64)


@lru_cache(maxsize=32)
def course(mech: Mechanism, loads: Loads) -> Course:
    """The course of a period, the constant moment found where there is one.

    Raises EquilibriumError where the drive does not turn right round, where a load depends on the speed, or where the
    work over a period is not nothing.
    """
    sense = float(np.sign(mech.drive.rate)) or 1.0
    unit = replace(mech, drives=(replace(mech.drive, rate=sense, accel=0.0), *mech.drives[1:]))

    def curves(psi: Reals) -> tuple[Reals, Reals]:
        found = reduce(unit, loads, sense * psi)
        return sense * found.power, found.energy

    cuts, (moments, inertias) = followed(curves, _cuts(mech, loads, sense))
    half = np.diff(cuts)[:, None] / 2
    done = 2 * (half[:, 0] * moments[:, 0])
    constant = -float(done.sum() / (cuts[-1] - cuts[0])) if loads.constant is not None else 0.0
    _refuse_change(float(done.sum()), float(np.abs(done).sum()), has_constant=loads.constant is not None)
    moments[:, 0] += constant
    works = legendre.legint(moments, axis=1, lbnd=-1) * half
    works[1:, 0] += np.cumsum(2 * half[:-1, 0] * moments[:-1, 0])
    return Course(cuts=cuts, moments=moments, inertias=inertias, works=works, constant=constant, sense=sense)


def _cuts(mech: Mechanism, loads: Loads, sense: float) -> Reals:
    """Ends of the pieces: every ten degrees, and wherever a load jumps or bends."""
    low, high, whole = drive_range(mech)
    if mech.drive.slide or not whole:
        raise EquilibriumError(_rocks(mech, low, high), code="no-period", numbers={"low": low, "high": high})
    refuse_rated(loads)
    high = low + 2 * np.pi * turns_of(mech, loads, low)
    even = np.linspace(low, high, round((high - low) / PIECE) + 1)
    cuts = np.unique(np.concatenate([even, corners(mech, loads)]))
    cuts = cuts[np.append(True, np.diff(cuts) > SAME)]
    return np.asarray(cuts if sense > 0 else -cuts[::-1], np.float64)


def _rocks(mech: Mechanism, low: float, high: float) -> Words:
    slides = mech.drive.slide
    a, b = (f"{1e3 * x:.5g} mm" if slides else f"{np.degrees(mech.drive.told(x)):.5g}°" for x in (low, high))
    return Words(
        f"原动件 {mech.drive.link} 不作整周转动（只能在 {a} 与 {b} 之间运动），没有稳定运转的周期；"
        "仍可求某一位置的 J_e、M_e，或由 start 求运动",
        f"the drive {mech.drive.link} makes no whole turns (it moves between {a} and {b} only), and there is no period "
        "of steady motion; J_e and M_e at a position can be asked, or the motion from a start",
    )


def _refuse_change(left: float, moved: float, *, has_constant: bool) -> None:
    if not has_constant and abs(left) > LITTLE * moved:
        raise EquilibriumError(
            Words(
                f"一个周期内各力（矩）所作的功之和为 {left:.6g} J，不为零，机器不能稳定运转（每周期动能变化 "
                f"{left:.6g} J）；请改正载荷，或写一个 size: constant 的力矩",
                f"the loads do {left:.6g} J of work over a period, not 0: the machine cannot run uniformly, its energy "
                f"changes by {left:.6g} J in every period; correct the loads, or write a moment of size: constant",
            ),
            code="work-left",
            numbers={"work": left},
        )
