"""Loads that are accepted and never act: what they wait for does not come in the whole range of the drive."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import copysign, degrees

import numpy as np

from .. import oracle
from ..errors import VecpolyError
from ..mechanism.laws.windows import During, Moving, Turning
from ..mechanism.loads import Load, Loads
from ..mechanism.model import Mechanism
from ..oracle.forces.laws.drives import drive_range, unit_drive
from ..oracle.forces.laws.returning import over_a_period
from ..oracle.motion import Motion
from ..oracle.state import Reals
from ..words import Words

PLACES = 180  # of the drive in its range
STILL = 1e-9  # of the mechanism's size, or of the drive's turning, per unit of the drive: no motion
Waiting = tuple[Load, Moving | Turning]


def never_acting(mech: Mechanism, loads: Loads) -> Iterator[Words]:
    """A remark on each load that waits for a motion that never comes; none where the motion has no period.

    Most come within one turn of the drive, and no more than that is looked through then.
    """
    waiting = list(_waiting(loads))
    if not waiting:
        return
    try:
        low, high, _ = drive_range(mech)
        waiting = _still_waiting(mech, waiting, lambda: np.linspace(low, high, PLACES + 1))
        own = [one for one in waiting if isinstance(one[1], Turning) and one[1].link == mech.drive.link]
        others = [one for one in waiting if one not in own]
        never = [*own, *_still_waiting(mech, others, lambda: over_a_period(mech, PLACES))]
    except VecpolyError:
        return
    yield from (_said(mech, *one) for one in never)


def _still_waiting(mech: Mechanism, waiting: list[Waiting], places: Callable[[], Reals]) -> list[Waiting]:
    """Those whose motion does not come at any of these places of the drive."""
    if not waiting:
        return []
    motion = oracle.solve(unit_drive(mech), places(), order=1, strict=False)
    return [(load, window) for load, window in waiting if not _comes(mech, motion, window)]


def _comes(mech: Mechanism, motion: Motion, window: Moving | Turning) -> bool:
    still = STILL * (1.0 if isinstance(window, Turning) else mech.scale)
    way = copysign(1.0, mech.drive.rate)
    return bool(np.nanmax(way * _rate(mech, motion, window), initial=0.0) > still)


def _waiting(loads: Loads) -> Iterator[Waiting]:
    for load in loads.all:
        for window in () if load.law is None else load.law.windows:
            if not isinstance(window, During):
                yield load, window


def _rate(mech: Mechanism, motion: Motion, window: Moving | Turning) -> Reals:
    """How fast that moves which is waited for, per unit of the drive."""
    body = motion.body(window.link)
    if isinstance(window, Turning):
        return body.omega * window.sense
    velocity = body.velocity_of(mech.link(window.link).points[window.point])
    return np.real(velocity * np.exp(-1j * window.direction))


def _said(mech: Mechanism, load: Load, window: Moving | Turning) -> Words:
    if isinstance(window, Turning):
        link, ccw = mech.number(window.link), window.sense > 0
        why = Words(
            f"构件 {link} 从不{'逆' if ccw else '顺'}时针转动",
            f"link {link} never turns {'counter-' if ccw else ''}clockwise",
        )
    else:
        towards = f"{degrees(window.direction):.4g}"
        why = Words(f"{window.point} 点从不向 {towards}° 方向运动", f"{window.point} never moves towards {towards} deg")
    return Words(
        f"loads.{load.name}：{why.zh}，这个载荷从不起作用；请检查 while",
        f"loads.{load.name}: {why.en}, so this load never acts; check 'while'",
    )
