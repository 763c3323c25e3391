"""The equivalent link in other positions of the drive: the same velocity polygon, drawn on scratch paper."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from itertools import pairwise

import numpy as np

from ...board.board import NO_LENGTH
from ...board.construction import View
from ...board.hand import Hand, hand
from ...mechanism.laws.acting import stretch
from ...mechanism.laws.sizes import Table
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import At, omega
from ...plane import Reals
from ..desk import Desk
from ..forces.balance.power_terms import works
from ..forces.laws.found import found_loads
from ..forces.laws.off_paper import OffPaper
from ..forces.masses import weights
from ..forces.state import Statics
from ..kinematics.doors import draw_drives, draw_group
from ..kinematics.image import found_tip
from ..positions.placed import elsewhere, refuse_profiles
from ..registry import Stage

JUMP = 1e-12  # rad: how closely the place is found at which a load begins or ends
MOST = 8  # changes between two places that are looked at
Names = tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Station:
    """One position of the drive: J_e (kg·m²), M_e of the given loads (N·m), by every hand.

    acting: which loads act. stretches: on which straight parts of their tables they are.
    """

    phi: float
    inertia: Reals
    moment: Reals
    acting: Names
    stretches: tuple[Reals, ...] = ()


def station(mech: Mechanism, loads: Loads, phi: float) -> Station:
    """As an exact hand draws it; every position is drawn once."""
    return _drawn_once(mech, loads, phi)


@lru_cache(maxsize=4096)
def _drawn_once(mech: Mechanism, loads: Loads, phi: float) -> Station:
    return drawn(mech, loads, phi, hand("exact"))


def drawn(mech: Mechanism, loads: Loads, phi: float, by: Hand) -> Station:
    """As this hand draws it, with all its readings. Raises AssemblyError, DeadPointError."""
    refuse_profiles(mech)
    desk = _desk(replace(mech, drives=(replace(mech.drive, accel=0.0), *mech.drives[1:])), phi, by)
    rate = mech.drive.rate
    here, pulls = found_loads(desk, replace(loads, inertia=False))
    st = Statics(desk=desk, loads=here, pulls=pulls)
    weights(st)
    power: Reals = sum((work.value for work in works(st)), 0.0)
    energy: Reals = sum((_energy(st, link) for link in range(len(loads.masses))), 0.0)
    acting = tuple(load.name for load in here.all if load.size)
    return Station(phi, energy / rate**2, power / rate, acting, _stretches(desk, loads))


def _stretches(desk: Desk, loads: Loads) -> tuple[Reals, ...]:
    at, tables = OffPaper(desk), [load.law.size for load in loads.all if load.law is not None]
    return tuple(one for table in tables if isinstance(table, Table) for one in stretch(table, at))


def _desk(mech: Mechanism, phi: float, by: Hand) -> Desk:
    """Position and velocity polygon on paper that is thrown away."""
    there = elsewhere(mech, phi)
    desk = there.desk(by)
    desk.told = mech
    draw_drives(desk, Stage.VELOCITY)
    for group in there.groups:
        draw_group(desk, Stage.VELOCITY, group)
    return desk


def _energy(st: Statics, number: int) -> Reals:
    """m v_S² + J ω², both measured."""
    mass, board = st.loads.masses[number], st.board
    tip = found_tip(st.desk, View.VELOCITY, At(mass.centre, mass.link))
    speed = board.mu(View.VELOCITY) * board.measure(0j, tip, f"p {mass.centre}")
    turn = st.desk.turns[omega(mass.link)]
    moving = np.where(np.abs(tip) < NO_LENGTH, 0.0, speed.value)
    found: Reals = mass.mass * moving**2 + mass.inertia * np.asarray(turn.value) ** 2
    return found


def jumps(mech: Mechanism, loads: Loads, places: Sequence[float]) -> tuple[float, ...]:
    """Where a load begins or ends to act between these places: tried on scratch paper, each trial halving the way."""
    return _changes(partial(station, mech, loads), lambda one: one.acting, places)


def bends(mech: Mechanism, loads: Loads, places: Sequence[float]) -> tuple[float, ...]:
    """Where the table of a load over a travel turns a corner, likewise."""
    return _changes(partial(station, mech, loads), lambda one: one.stretches, places)


def _changes(
    drawn_at: Callable[[float], Station], what: Callable[[Station], object], places: Sequence[float]
) -> tuple[float, ...]:
    """Where something changes between the first and the last of these places."""
    found = []
    for low, high in pairwise(places):
        here, end = drawn_at(low), drawn_at(high)
        for _ in range(MOST):  # of several changes one at a time
            if what(here) == what(end):
                break
            here = _halved(drawn_at, what, here, end)
            found.append(here.phi)
    return tuple(one for one in found if places[0] < one < places[-1])


def _halved(drawn_at: Callable[[float], Station], what: Callable[[Station], object], a: Station, b: Station) -> Station:
    """The first station behind a change."""
    while b.phi - a.phi > JUMP:
        middle = drawn_at((a.phi + b.phi) / 2)
        a, b = (middle, b) if what(middle) == what(a) else (a, middle)
    return b
