"""The mechanism in other positions of its drive as it comes there from its own: place by place, never taken apart.

A branch statement is read at the given position only. Elsewhere a dyad of three hinges keeps its side of the line of
its outer hinges; of any other group the meeting point is taken that lies nearest to where the last places lead.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from ...errors import NoMethodError
from ...mechanism.assembly.branch import margin
from ...mechanism.assembly.four_bar import folded_corner, fourth_corner
from ...mechanism.groups.assur import Group, decompose
from ...mechanism.model import Mechanism, Revolute, Shaped, Side, SideOf, Statement
from ...plane import nominal
from ...words import Words
from ..desk import Desk
from ..kinematics.diagram.cam import letter_contacts
from ..kinematics.doors import draw_drives, draw_group
from ..placed import refuse_told
from ..registry import Stage
from .scratch import position_desk

STEP = np.radians(2.4743)  # no place falls on a change point by its round number
LEAD = ((1.0,), (2.0, -1.0), (3.0, -3.0, 1.0))  # where one, two, three last places lead, the nearest first
Places = dict[str, complex]


@dataclass(slots=True)
class Follower:
    """The places of all letters (m), step by step from the mechanism's own position; kept: what keeps its side."""

    mech: Mechanism
    groups: tuple[Group, ...]
    kept: tuple[Statement, ...] = ()
    places: dict[int, Places] = field(default_factory=dict)

    def at(self, position: float) -> Mechanism:
        """The mechanism there, with statements and rough places that lead to its own assembly.

        Raises AssemblyError, DeadPointError.
        """
        way = position - self.mech.drive.position
        number, sense = round(way / STEP), 1 if way >= 0 else -1
        for k in range(sense, number + sense, sense):
            if k not in self.places:
                self.places[k] = _letters(self.there(k * STEP, self._led(k, sense)), self.groups)
        return self.there(way, self.places[number]) if way else self.mech

    def there(self, way: float, guesses: Places) -> Mechanism:
        """A position so far from the own one, near these places."""
        drive = replace(self.mech.drive, position=self.mech.drive.position + way)
        drives, rough = (drive, *self.mech.drives[1:]), {**self.mech.guesses, **guesses}
        return replace(self.mech, drives=drives, branches=self.kept, guesses=rough)

    def _led(self, number: int, sense: int) -> Places:
        """Where the places behind this one lead."""
        behind = [self.places[number - sense * n] for n in (1, 2, 3) if number - sense * n in self.places]
        shares = LEAD[len(behind) - 1]
        return {p: sum(share * one[p] for share, one in zip(shares, behind, strict=True)) for p in behind[0]}


@lru_cache(maxsize=16)
def follower(mech: Mechanism) -> Follower:
    """Of a mechanism in its own position. Raises NoMethodError where gears or cams leave its places open elsewhere."""
    refuse_told(mech)
    if mech.cams:
        raise _is_cam()
    groups = decompose(mech)
    own = _letters(mech, groups)
    return Follower(mech=mech, groups=groups, kept=tuple(_kept(mech, groups, own)), places={0: own})


def _letters(mech: Mechanism, groups: tuple[Group, ...]) -> Places:
    """All letters in this position, as an exact hand draws them."""
    desk = position_desk(mech)
    draw_drives(desk, Stage.POSITION)
    for group in groups:
        draw_group(desk, Stage.POSITION, group)
        letter_contacts(desk, group.links)
    return _metres(desk)


def _metres(desk: Desk) -> Places:
    return {letter: complex(nominal(at)) / desk.mm(1.0) for letter, at in desk.at.items()}


def _kept(mech: Mechanism, groups: tuple[Group, ...], own: Places) -> list[Statement]:
    """For every dyad of three hinges the side of its middle one; parallelograms as they are told."""
    found: list[Statement] = [one for one in mech.branches if isinstance(one, Shaped)]
    for group in groups:
        dyad = group.dyad
        if dyad is None or fourth_corner(mech, dyad) is not None or folded_corner(mech, dyad) is not None:
            continue
        hinges = (dyad.outer_j, dyad.inner, dyad.outer_k)
        if all(isinstance(joint, Revolute) for joint in hinges):
            b, c, d = (joint.point for joint in hinges if isinstance(joint, Revolute))
            left = SideOf(point=c, side=Side.LEFT, ref=(b, d))
            found.append(left if margin(left, own) > 0 else replace(left, side=Side.RIGHT))
    return found


def _is_cam() -> NoMethodError:
    return NoMethodError(
        Words(
            "凸轮廓线在各位置要另作替代机构，一个周期内的线图没有图解法；请用 vecpoly exact",
            "a cam's profile is replaced anew in every position, and no graphical method on file draws the diagrams "
            "of a period there; use 'vecpoly exact'",
        ),
        code="no-method",
    )
