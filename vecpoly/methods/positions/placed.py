"""The mechanism in other positions of its drive, drawn on scratch paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...board.hand import Hand
from ...errors import NoMethodError
from ...foundation.slotted import dataclass, replace
from ...mechanism.groups.assur import Group, decompose
from ...mechanism.model import Mechanism
from ...plane import Reals
from ...words import Words
from ..desk import Desk
from .following import draw_positions, follower, moved
from .rolled import with_told
from .scratch import position_desk
from .sides import Sides


@dataclass(frozen=True, slots=True, kw_only=True)
class There:
    """The mechanism with its drive in a position, and the sides that its groups take there."""

    mech: Mechanism
    groups: tuple[Group, ...]
    sides: Sides

    def desk(self, by: Hand, ahead: Mapping[str, Reals] | None = None) -> Desk:
        """Its position diagram on paper that is thrown away, by this hand; ahead: in places farther on (`further`), on
        the same sides."""
        desk = position_desk(self.mech, self.groups, by, self.sides, ahead)
        draw_positions(desk, self.groups)
        return desk


def further(mech: Mechanism, places: Sequence[float]) -> Mapping[str, Reals]:
    """How far the drive, and what gears leave open, are on in each of these places from the first (rad, or m)."""
    ahead: dict[str, Reals] = {mech.drive.key: np.subtract(places, places[0])}
    if mech.starts:
        one = follower(mech)
        told = np.array([one.at(place).rolled.told for place in places]).T
        ahead |= {start.key: values - values[0] for start, values in zip(one.mech.starts, told, strict=True)}
    return ahead


def elsewhere(mech: Mechanism, position: float) -> There:
    """Followed to this position (rad, or m) from its own, where its statements are read.

    Gears roll on; a profile is replaced by a disc that touches there, which is good for positions and velocities.
    Raises AssemblyError where the way there ends, DeadPointError likewise.
    """
    if position == mech.drive.position:
        return _as_told(mech, position)
    one = follower(mech)
    stand = one.at(position)
    there = replace(moved(mech, position, stand.places), starts=with_told(one.mech, stand.rolled.told).starts)
    return There(mech=there, groups=one.groups, sides=Sides(kept=stand.taken))


def placed(desk: Desk, position: float) -> Desk:
    """The position diagram for this position of the drive (rad, or m), at the same scale, followed from the own one.

    Raises AssemblyError where the way there ends, DeadPointError likewise.
    """
    return _on_scratch(desk, elsewhere(desk.mech, position))


def placed_as_told(desk: Desk, position: float) -> Desk:
    """The same of the problem with its drive in this position: the statements are read there.

    Raises AssemblyError, DeadPointError.
    """
    return _on_scratch(desk, _as_told(desk.mech, position))


def _as_told(mech: Mechanism, position: float) -> There:
    drives = (replace(mech.drive, position=position), *mech.drives[1:])
    return There(mech=replace(mech, drives=drives), groups=decompose(mech), sides=Sides())


def _on_scratch(desk: Desk, there: There) -> Desk:
    scratch = Desk(
        board=desk.board.scratch(), mech=there.mech, coincident=desk.coincident, shapes=desk.shapes, sides=there.sides
    )
    for name, at in scratch.mech.frame.items():
        scratch.letter(name, at * scratch.mm(1.0))
    draw_positions(scratch, there.groups)
    return scratch


def refuse_thought(desk: Desk) -> None:
    """NoMethodError where another link is thought to drive: the positions that are asked for are the input's own."""
    if desk.thought:
        raise NoMethodError(
            Words(
                f"输入加在活动构件之间，作图时以构件 {desk.mech.drive.link} 为假想原动件；"
                "没有图解法得出输入在其他位置时的图，请用 vecpoly exact",
                f"the input acts between moving links, and link {desk.mech.drive.link} is thought to drive instead: no "
                "drawing on file follows the mechanism to other positions of the input; use 'vecpoly exact'",
            ),
            code="no-method",
        )
