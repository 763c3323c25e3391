"""How hard the joints with friction press, by Newton, with continuation in the friction where it is needed.

Statics is linear in the reactions and in friction's wrenches, so the pressing force of joint k is p_k = p0_k + λ Σ_j
g_kj u_j with u_j = |p_j|: as many equations as joints with friction. λ = 0 is no friction, 1 all of it.
"""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from ..state import Points, Reals
from .elimination import Flags, solved

_Number = TypeVar("_Number", np.complex128, np.float64)
TOLERANCE = 1e-13
CONTINUED = 400  # steps of λ at most
ROUNDING = 1e-12  # a gain that is no larger is none
NEAR = 0.02  # by what a joint's force may miss the one foreseen, of the largest of those with which it takes turns
LOST = 1e-7  # a step of λ this small does not lead on


def sizes(base: Points, gain: Points) -> tuple[Reals, Reals]:
    """u (joints × positions), and the λ reached: 1, or less where the friction cannot be borne (u is NaN there).

    base: joints × positions, gain: joints × joints × positions, complex.
    """
    pressed, reached = np.full(base.shape, np.nan), np.ones(base.shape[1])
    sound = np.isfinite(base.sum(axis=0) + gain.sum(axis=(0, 1)))
    if not base.size or not sound.any():
        return pressed, reached
    if not sound.all():
        pressed[:, sound], reached[sound] = sizes(base[:, sound], gain[:, :, sound])
        return pressed, reached
    gain = _without_idle(base, gain)
    certain = _contracts(np.abs(gain))
    pressed, found = _newton(base, gain, np.ones(1), np.abs(base), 12)
    doubtful = np.flatnonzero(~(found & certain))
    if doubtful.size:
        pressed[:, doubtful], reached[doubtful] = _continued(base[:, doubtful], gain[:, :, doubtful])
    return pressed, reached


def _without_idle(base: Points, gain: Points) -> Points:
    """The gains without those of joints that nothing presses: neither the loads nor the friction of one that is
    pressed. Friction that would have to press itself stays out."""
    acts: Flags = np.abs(gain) > ROUNDING
    idle: Flags = base == 0
    for _ in base:
        idle = idle & ~(acts & ~idle).any(axis=1)
    kept: Points = np.where(idle[:, None] | idle[None], 0.0, gain)
    return kept


def _contracts(weight: Reals) -> Flags:
    """Where u -> |p0 + Σ g u| is a contraction in some weighted norm:
    then its fixed point is the only one, at every λ."""
    scale: Reals = np.ones(weight.shape[1:])
    for _ in range(3):
        scale = 1.0 + _apply(weight, scale)
    inside: Flags = np.all(_apply(weight, scale) < scale, axis=0)
    return inside


def _apply(gain: NDArray[_Number], u: Reals) -> NDArray[_Number]:
    """Σ_j g_kj u_j."""
    applied: NDArray[_Number] = (gain * u).sum(axis=1)
    return applied


def _slope(base: Points, gain: Points, lam: Reals, u: Reals) -> tuple[Reals, Reals]:
    """|p|, and its derivatives with respect to λ u."""
    p = base + lam * _apply(gain, u)
    size = np.abs(p)
    unit = p.conj() / np.where(size > 0, size, 1.0)
    return size, (unit[:, None] * gain).real


def _solved(matrix: Reals, right: Reals) -> Reals:
    """Solution at every position; NaN where there is none."""
    rows = [dict(enumerate(row)) for row in matrix]
    return solved(rows, [{0: side} for side in right], 1, right.shape[1])[:, 0]


def _newton(base: Points, gain: Points, lam: Reals, u: Reals, rounds: int) -> tuple[Reals, Flags]:
    """u = |p(u)| from a first guess, and where it was found."""
    eye = np.eye(len(base))[..., None]
    for _ in range(rounds):
        size, slope = _slope(base, gain, lam, u)
        miss = u - size
        found: Flags = np.abs(miss).max(axis=0) <= TOLERANCE * size.max(axis=0)
        if found.all():
            break
        u = u - _solved(eye - lam * slope, miss)
    return u, found


def _foreseen(u: Reals, rise: Reals) -> Reals:
    """u a step on: as 1/(c - λ), for it runs off, and comes in from afar, like that;
    u²/(u - rise), to first order u + rise."""
    share = rise / np.where(u > 0, u, np.inf)
    return np.where(share < 0.9, u / (1 - np.minimum(share, 0.9)) + np.where(u > 0, 0.0, rise), u + rise)


def _answering(gain: Points) -> Flags:
    """Which joints press on each other in a circle (joints × joints). A leap of such a circle shows in its own forces
    alone: a larger one elsewhere hides it."""
    leads: Flags = np.any(np.abs(gain) > ROUNDING, axis=2)
    for _ in gain:
        leads = leads | (leads @ leads)
    circles: Flags = leads & leads.T | np.eye(len(gain), dtype=np.bool_)
    return circles


def _continued(base: Points, gain: Points) -> tuple[Reals, Reals]:
    """The branch that begins without friction, followed in λ; it ends where its tangent turns back or it runs off."""
    u, lam = np.abs(base), np.zeros(base.shape[1])
    answering = _answering(gain)
    step, smooth, eye = np.full(base.shape[1], 0.25), np.ones(base.shape[1], np.bool_), np.eye(len(base))[..., None]
    for _ in range(CONTINUED):
        going = np.flatnonzero((lam < 1.0) & (step > LOST))
        if not going.size:
            break
        p0, g, u_old, lam_old = base[:, going], gain[:, :, going], u[:, going], lam[going]
        _, slope = _slope(p0, g, lam_old, u_old)
        rate = _solved(eye - lam_old * slope, _apply(slope, u_old))
        new = np.minimum(lam_old + step[going], 1.0)
        guess = _foreseen(u_old, (new - lam_old) * rate)
        u_new, found = _newton(p0, g, new, guess, 8)
        _, slope = _slope(p0, g, new, u_new)
        near = (np.abs(u_new - guess) <= NEAR * (answering[..., None] * u_new).max(axis=1)).all(axis=0)
        good = found & near & (np.linalg.det(np.moveaxis(eye - new * slope, -1, 0)) > 0)
        u[:, going[good]], lam[going[good]] = u_new[:, good], new[good]
        step[going] *= np.where(
            good, np.where(smooth[going], 2.0, 1.0), 0.5
        )  # what failed a moment ago is not tried again at once
        smooth[going] = good
    u[:, lam < 1.0] = np.nan
    return u, lam
