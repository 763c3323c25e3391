"""Trials of an exchange: groups drawn on scratch paper with another link as the driver, and the input they show."""

from __future__ import annotations

from functools import lru_cache
from math import pi, remainder

import numpy as np

from ...board.board import Scratch
from ...board.construction import Scale, View
from ...board.hand import hand
from ...board.place import views
from ...errors import AssemblyError
from ...foundation.slotted import dataclass, replace
from ...mechanism.groups.assur import Group, decompose
from ...mechanism.model import Drive, Mechanism, Prismatic
from ...mechanism.rams import driven_joint
from ...names import At, alpha, omega
from ...plane import nominal
from ..coincident import coincident_letters
from ..desk import Desk
from ..kinematics.doors import draw_drives, draw_group
from ..kinematics.image import found_tip
from ..registry import Stage


def driven_by(mech: Mechanism, drive: Drive, other: Drive) -> Mechanism:
    """The mechanism with the other link as the driver."""
    return replace(mech, drives=tuple(other if one == drive else one for one in mech.drives))


@lru_cache(maxsize=4)
def _structure(mech: Mechanism) -> tuple[tuple[Group, ...], dict[float, float]]:
    """The groups of a mechanism driven by the other link, and what trials have shown of it so far:
    neither knows the input's position."""
    return decompose(mech), {}


def trial_of(mech: Mechanism, drive: Drive, other: Drive) -> Trial:
    """The trials of this exchange, with what earlier ones have shown."""
    return Trial(mech, drive, other, *_structure(driven_by(mech, drive, other)))


@dataclass(frozen=True, slots=True)
class Trial:
    """Trials of one exchange: the mechanism, its own drive,
    the link that is thought to drive, the groups then, and the input at each trial."""

    mech: Mechanism
    drive: Drive
    other: Drive
    groups: tuple[Group, ...]
    seen: dict[float, float]

    def desk(self, other: Drive, *stages: Stage) -> Desk:
        """Scratch paper on which these stages are drawn."""
        mech = driven_by(self.mech, self.drive, other)
        sizes = {view: mech.scale / 100 if view is View.MECHANISM else 0.01 for view in views()}
        unit = {view: Scale(symbol="μ", value=size, unit="") for view, size in sizes.items()}
        desk = Desk(board=Scratch(hand("exact"), unit), mech=mech, coincident=coincident_letters(mech, self.groups))
        desk.at = {name: at * desk.mm(1.0) for name, at in mech.frame.items()}
        for stage in stages:
            draw_drives(desk, stage)
            for group in self.groups:
                draw_group(desk, stage, group)
        return desk

    def gap(self, position: float) -> float:
        """By how much the input misses its given position (m, or rad); NaN where the links cannot be joined."""
        if position not in self.seen:  # the next position of the same input asks for most of these trials again
            self.seen[position] = self._drawn(position)
        miss = self.seen[position] - self.drive.position
        return miss if self.drive.slide else remainder(miss, 2 * pi)

    def _drawn(self, position: float) -> float:
        """The input that this trial shows."""
        try:
            return self.shown(self.desk(replace(self.other, position=position), Stage.POSITION))
        except AssemblyError:
            return np.nan

    def shown(self, desk: Desk) -> float:
        """The input's position as drawn: travel (m), or angle (rad)."""
        if not self.drive.slide:
            return float(np.angle(nominal(desk.axis(self.drive.link)) * np.conj(nominal(desk.axis(self.drive.on)))))
        line = desk.guide_line(self.pair)
        return float(
            (np.conj(nominal(line.along)) * (nominal(desk.at[self.pair.pin]) - nominal(line.at))).real
        ) / desk.mm(1.0)

    @property
    def pair(self) -> Prismatic:
        """The driven slide."""
        joint = driven_joint(self.mech, self.drive)
        assert isinstance(joint, Prismatic)
        return joint

    def rate(self, desk: Desk, view: View) -> float:
        """The input's velocity, or acceleration, as drawn."""
        if not self.drive.slide:
            kind = omega if view is View.VELOCITY else alpha
            return float(
                nominal(desk.turns[kind(self.drive.link)].value) - nominal(desk.turns[kind(self.drive.on)].value)
            )
        pin, along = self.pair.pin, nominal(desk.guide_line(self.pair).along)
        tips = [nominal(found_tip(desk, view, At(pin, link))) for link in (self.pair.guide, self.pair.block)]
        return float((np.conj(along) * (tips[1] - tips[0])).real) * desk.board.scales[view].value
