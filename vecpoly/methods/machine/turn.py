"""The equivalent link in other positions of the drive: the same velocity polygon, drawn on scratch paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...board.board import NO_LENGTH
from ...board.construction import View
from ...board.hand import Hand, hand
from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import At, omega
from ...plane import Reals
from ..desk import Desk
from ..forces.balance.power_terms import works
from ..forces.laws.found import found_loads
from ..forces.masses import weights
from ..forces.state import Statics
from ..kinematics.doors import draw_drives, draw_group
from ..kinematics.image import found_tip
from ..positions.placed import elsewhere, further
from ..registry import Stage

SAME = 1e-6  # mm: two drawings of one place
ALIKE = 1e-10  # of the greatest of M or J: what two drawings of one place come to


@dataclass(frozen=True, slots=True, eq=False)
class Station:
    """One position of the drive: J_e (kg·m²), M_e of the given loads (N·m), by every hand."""

    phi: float
    inertia: Reals
    moment: Reals


def station(mech: Mechanism, loads: Loads, phi: float) -> Station:
    """As an exact hand draws it; every position is drawn once."""
    return _drawn_once(mech, loads, phi)


@lru_cache(maxsize=4096)
def _drawn_once(mech: Mechanism, loads: Loads, phi: float) -> Station:
    return drawn(mech, loads, phi, hand("exact"))


def drawn(mech: Mechanism, loads: Loads, phi: float, by: Hand) -> Station:
    """As this hand draws it, with all its readings. Raises AssemblyError, DeadPointError."""
    return Station(phi, *_reduced(desk_at(mech, phi, by), loads))


def stations(mech: Mechanism, loads: Loads, places: Sequence[float]) -> list[Station]:
    """In places between which nothing begins or ends to act: all at once where that comes, in the last of them, to what
    is drawn there alone; no force then turns with the drive, and none changes its sense. Raises likewise."""
    desk = at_once(mech, places)
    if desk is not None:
        inertias, moments = (np.broadcast_to(one, len(places)) for one in _reduced(desk, loads))
        last = station(mech, loads, places[-1])
        if _same(inertias, last.inertia) and _same(moments, last.moment):
            return [Station(phi, j, m) for phi, j, m in zip(places, inertias, moments, strict=True)]
    return [station(mech, loads, phi) for phi in places]


def _same(values: NDArray[np.float64], last: Reals) -> bool:
    return bool(abs(values[-1] - last) <= ALIKE * np.abs(values).max())


def at_once(mech: Mechanism, places: Sequence[float]) -> Desk | None:
    """Position and velocity polygon in all of these places, as if each were another hand's, on the sides of the first.

    None where other meetings are chosen on the way, as the last place shows, and where a cam has another disc in each.
    """
    if mech.cams:
        return None
    try:
        desk = desk_at(mech, places[0], hand("exact"), further(mech, places))
        last = elsewhere(mech, places[-1]).desk(hand("exact"))
    except VecpolyError:
        return None
    off = [np.ravel(at)[-1] - last.at[letter] for letter, at in desk.at.items() if letter in last.at]
    return desk if np.abs(off).max(initial=0.0) < SAME else None


def desk_at(mech: Mechanism, phi: float, by: Hand, ahead: Mapping[str, Reals] | None = None) -> Desk:
    """Position and velocity polygon on paper that is thrown away."""
    there = elsewhere(replace(mech, drives=(replace(mech.drive, accel=0.0), *mech.drives[1:])), phi)
    desk = there.desk(by, ahead)
    desk.told = mech
    draw_drives(desk, Stage.VELOCITY)
    for group in there.groups:
        draw_group(desk, Stage.VELOCITY, group)
    return desk


def _reduced(desk: Desk, loads: Loads) -> tuple[Reals, Reals]:
    """J_e; M_e of the loads that are given."""
    rate = desk.mech.drive.rate
    here, pulls = found_loads(desk, replace(loads, inertia=False))
    st = Statics(desk=desk, loads=here, pulls=pulls)
    weights(st)
    power: Reals = sum((work.value for work in works(st)), 0.0)
    energy: Reals = sum((_energy(st, link) for link in range(len(loads.masses))), 0.0)
    return energy / rate**2, power / rate


def _energy(st: Statics, number: int) -> Reals:
    """m v_S² + J ω², both measured."""
    mass, board = st.loads.masses[number], st.board
    tip = found_tip(st.desk, View.VELOCITY, At(mass.centre, mass.link))
    speed = board.mu(View.VELOCITY) * board.measure(0j, tip, f"p {mass.centre}")
    turn = st.desk.turns[omega(mass.link)]
    moving = np.where(np.abs(tip) < NO_LENGTH, 0.0, speed.value)
    found: Reals = mass.mass * moving**2 + mass.inertia * np.asarray(turn.value) ** 2
    return found
