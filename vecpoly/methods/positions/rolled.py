"""Where gears stand, in other positions of the drive: each rolls on from its last place without slip.

    r_k (Δθ_k − Δλ) = ∓ r_m (Δθ_m − Δλ)      gears outside each other −, inside +
    r_k (Δθ_k − Δθ_m) = ∓ Δx                 on a rack, the gear to the left of its direction −

θ: angles of the two links, λ: of the line of centres, x: the centre's travel along the rack. An angle (or a rack's
travel) that gears leave open is a datum of the own position; elsewhere it is found by trial: the mechanism is drawn
with a guess, the slip is measured, and the guess mended. r in m, angles in rad.

Source: 机械原理, pure rolling: arcs of equal length run off.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from ...errors import AssemblyError
from ...foundation.slotted import dataclass, replace
from ...mechanism.assembly.start import Start
from ...mechanism.gearing import pitch_circles
from ...mechanism.model import Circle, Mechanism, Rack, Rolling, Side
from ...plane import nominal, unit
from ...words import Words
from ..desk import Desk
from ..kinematics.gears.pitch import rolling_in

ROUNDS = 12  # trials at most
CLOSED = 1e-14  # of the mechanism's size: a slip that is none
NEAR = 1e-9  # of the mechanism's size: a slip that rounding leaves
NUDGE = 1e-5  # rad, or of the mechanism's size: how far a guess is moved to see what becomes of the slip
Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Contacts:
    """How everything that rolls stands in one place: what is told of each open link, where it counts from, the
    directions of the links that roll and of the lines of centres, travels along racks (m). change: of every slip with
    every open link, as it was found there; pace: of what is told, over the drive's way."""

    told: tuple[float, ...] = ()
    zeros: tuple[complex, ...] = ()
    axes: Mapping[str, complex] | None = None
    ways: tuple[complex, ...] = ()
    change: Array | None = None
    pace: Array | None = None


def opened(mech: Mechanism) -> Mechanism:
    """The mechanism with a start for each gear that has none since no point of it but its centre is known; and with
    none for what is driven, where it repeats the input's position."""
    driven = {drive.link for drive in mech.drives}
    starts = tuple(start for start in mech.starts if start.link not in driven)
    known = {start.link for start in starts} | driven
    gears = {circle.link for circle in pitch_circles(mech)} - known
    bare = [link.name for link in mech.links if link.name in gears and len(link.points) == 1]
    return replace(mech, starts=(*starts, *(Start(link=name, value=0.0) for name in bare)))


def with_told(mech: Mechanism, told: Iterable[float]) -> Mechanism:
    """The mechanism whose open links stand elsewhere."""
    return replace(mech, starts=tuple(replace(s, value=float(v)) for s, v in zip(mech.starts, told, strict=True)))


def contacts(desk: Desk) -> Contacts:
    """As it is drawn."""
    mech, rolls = desk.mech, rolling_in(desk.mech.joints)
    if not mech.starts:
        return Contacts()
    links = {wheel.link for joint in rolls for wheel in (joint.gear, joint.on)}
    return Contacts(
        told=tuple(start.value for start in mech.starts),
        zeros=tuple(complex(nominal(desk.towards(*s.ray))) if s.ray else 1 + 0j for s in mech.starts),
        axes={link: complex(nominal(desk.axis(link))) for link in links},
        ways=tuple(_way(desk, joint) for joint in rolls),
    )


def rolled_on(draw: Callable[[Array], Desk], before: Contacts, stride: float) -> tuple[Desk, Contacts]:
    """Drawn where nothing has slipped since the last place, a stride of the drive (rad, or m) back.

    Raises AssemblyError where no trial ends there.
    """
    guess = np.array(before.told)
    if not before.told:
        return draw(guess), before
    guess = guess if before.pace is None else guess + before.pace * stride
    desk = draw(guess)
    size, slip = desk.mech.scale, _slip(desk, before)
    change = _change(draw, guess, slip, before, desk) if before.change is None else before.change
    for _ in range(ROUNDS):
        great = np.abs(slip).max()
        if great < CLOSED * size:
            break
        mend = np.linalg.lstsq(change, -slip, rcond=None)[0]
        other = draw(guess + mend)
        left = _slip(other, before)
        if np.abs(left).max() >= great and great < NEAR * size:
            break  # rounding alone is left
        change = change + np.outer(left - slip - change @ mend, mend) / (mend @ mend)
        desk, guess, slip = other, guess + mend, left
    if not np.abs(slip).max() < NEAR * size:
        raise AssemblyError(
            Words(
                "齿轮由上一位置滚到此位置时，试凑不出无滑动的位置",
                "no place is found by trial to which the gears roll from the last one without slip",
            )
        )
    pace = (guess - before.told) / stride if stride else before.pace
    return desk, replace(contacts(desk), change=change, pace=pace)


def _change(draw: Callable[[Array], Desk], guess: Array, slip: Array, before: Contacts, desk: Desk) -> Array:
    """How every slip changes with what is told of every open link: each is moved a little."""
    tries = np.diag([desk.mech.scale * NUDGE if s.slide else NUDGE for s in desk.mech.starts])
    return np.stack([(_slip(draw(guess + one), before) - slip) / one.max() for one in tries], axis=1)


def _way(desk: Desk, joint: Rolling) -> complex:
    """Direction of the line of centres; along a rack the travel of the centre, a real number."""
    centre = desk.at[joint.gear.centre]
    if isinstance(joint.on, Circle):
        return complex(nominal(unit(desk.at[joint.on.centre] - centre)))
    along = desk.axis(joint.on.link) * np.exp(1j * joint.on.direction)
    gone = np.conj(along) * (centre - desk.place(joint.on.link, joint.on.origin))
    return complex(float(nominal(gone.real)) / desk.mm(1.0))


def _slip(desk: Desk, before: Contacts) -> Array:
    """What is run off more on the one side than on the other since the last place (m), of each rolling pair."""
    now = contacts(desk)
    assert now.axes is not None and before.axes is not None
    turns = {link: _turned(axis, before.axes[link]) for link, axis in now.axes.items()}
    for i, start in enumerate(desk.mech.starts):
        if not start.slide:
            turns[start.link] = now.told[i] - before.told[i] + _turned(now.zeros[i], before.zeros[i])
    joints = zip(rolling_in(desk.mech.joints), now.ways, before.ways, strict=True)
    return np.array([_gap(joint, turns, here, last) for joint, here, last in joints])


def _gap(joint: Rolling, turns: Mapping[str, float], here: complex, last: complex) -> float:
    gear, on = turns[joint.gear.link], turns[joint.on.link]
    if isinstance(joint.on, Rack):
        return joint.gear.radius * (gear - on) + (1 if joint.side is Side.LEFT else -1) * (here - last).real
    line = _turned(here, last)
    return joint.gear.radius * (gear - line) + (-1 if joint.internal else 1) * joint.on.radius * (on - line)


def _turned(now: complex, before: complex) -> float:
    return float(np.angle(now / before))
