"""The equivalent link in other positions of the drive: the same velocity polygon, drawn on scratch paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np

from ...board.board import NO_LENGTH, Board, Scratch
from ...board.construction import Scale, View
from ...board.hand import Hand, hand
from ...board.place import views
from ...mechanism.groups.assur import decompose
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import At, omega
from ...plane import Reals
from ..coincident import coincident_letters
from ..desk import Desk
from ..forces.balance.power_terms import works
from ..forces.laws.found import found_loads
from ..forces.state import Statics
from ..kinematics.diagram.cam import letter_contacts
from ..kinematics.doors import draw_drive, draw_group
from ..kinematics.image import found_tip
from ..registry import Stage

SIZE = 100.0  # mm: how large mechanism and first vector are drawn on scratch paper
JUMP = 1e-10  # rad: how closely the place is found at which a load begins or ends
Names = tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Station:
    """One position of the drive: J_e (kg·m²), M_e of the given loads (N·m), by every hand; which loads act."""

    phi: float
    inertia: Reals
    moment: Reals
    acting: Names


def station(mech: Mechanism, loads: Loads, phi: float) -> Station:
    """As an exact hand draws it; every position is drawn once."""
    return _drawn_once(mech, loads, phi)


@lru_cache(maxsize=4096)
def _drawn_once(mech: Mechanism, loads: Loads, phi: float) -> Station:
    return drawn(mech, loads, phi, hand("exact"))


def drawn(mech: Mechanism, loads: Loads, phi: float, by: Hand) -> Station:
    """As this hand draws it, with all its readings. Raises AssemblyError, DeadPointError."""
    desk = _desk(replace(mech, drives=(replace(mech.drive, position=phi, accel=0.0), *mech.drives[1:])), by)
    rate = mech.drive.rate
    here, pulls = found_loads(desk, replace(loads, inertia=False))
    st = Statics(desk=desk, loads=here, pulls=pulls)
    power: Reals = sum((work.value for work in works(st)), 0.0)
    energy: Reals = sum((_energy(st, link) for link in range(len(loads.masses))), 0.0)
    acting = tuple(load.name for load in here.all if load.size)
    return Station(phi, energy / rate**2, power / rate, acting)


def _desk(mech: Mechanism, by: Hand) -> Desk:
    """Position and velocity polygon on paper that is thrown away."""
    groups = decompose(mech)
    rate = abs(mech.drive.rate) * (1.0 if mech.drive.slide else mech.scale)
    sizes = dict.fromkeys(views(), 1.0) | {View.MECHANISM: mech.scale / SIZE, View.VELOCITY: rate / SIZE}
    board: Board = Scratch(by, {view: Scale.of(view, size) for view, size in sizes.items()})
    desk = Desk(board=board, mech=mech, coincident=coincident_letters(mech, groups))
    for name, at in mech.frame.items():
        desk.letter(name, at * desk.mm(1.0))
    for stage in (Stage.POSITION, Stage.VELOCITY):
        for drive in mech.drives:
            draw_drive(desk, stage, drive)
        for group in groups:
            draw_group(desk, stage, group)
            if stage is Stage.POSITION:
                letter_contacts(desk, group.links)
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


def jumps(mech: Mechanism, loads: Loads, first: float, last: float, places: Sequence[float]) -> tuple[float, ...]:
    """Where a load begins or ends to act between these places: tried on scratch paper, each trial halving the way."""
    found = []
    for low, high in pairwise(places):
        a, b = station(mech, loads, low), station(mech, loads, high)
        if a.acting != b.acting:
            found.append(_halved(mech, loads, a, b))
    return tuple(one for one in found if first < one < last)


def _halved(mech: Mechanism, loads: Loads, a: Station, b: Station) -> float:
    while b.phi - a.phi > JUMP:
        middle = station(mech, loads, (a.phi + b.phi) / 2)
        a, b = (middle, b) if middle.acting == a.acting else (a, middle)
    return b.phi
