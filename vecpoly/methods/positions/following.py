"""The mechanism in other positions of its drive as it comes there from its own: place by place, never taken apart.

A branch statement is read at the given position only. Elsewhere a group takes of two meeting points the one that it
took before: on the same side of the line of its outer hinges, on the same side of the foot on its guide. Where another
lies nearer to where the last places lead, the stride is halved: either they then agree, or the mechanism passes a
change point, and the nearest is taken.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.groups.assur import Group, decompose
from ...mechanism.model import Mechanism, Shaped
from ...plane import nominal
from ..desk import Desk
from ..exchange.profile import touching
from ..kinematics.diagram.cam import letter_contacts
from ..kinematics.doors import draw_drives, draw_group
from ..registry import Stage
from .rolled import Contacts, contacts, opened, rolled_on, with_told
from .scratch import position_desk
from .sides import Key, Sides

STEP, BY_TRIAL = np.radians(4.9486), np.radians(2.4743)  # no place falls on a change point by its round number
FINEST = 2.0**-10  # of a step: the shortest stride
SEED = 1e-3  # of a step: how far off the second place lies, from which one sees where the first ones lead
JUMP = 0.5  # of the way gone: a group found by trial that lies farther from where it is led may be another assembly
SAME = 1e-7  # of the mechanism's size: two drawings of one place
Places = dict[str, complex]


@dataclass(frozen=True, slots=True, kw_only=True)
class Stand:
    """A place on the way: how far from the own position, where all letters are (m), which sides were taken; before:
    this place and the last ones; rolled: how the gears stand; desk: as it was drawn, where it still is at hand."""

    way: float
    places: Places
    taken: Mapping[Key, int]
    before: tuple[tuple[float, Places], ...]
    rolled: Contacts
    desk: Desk | None = None

    def led(self, way: float) -> Places:
        """Where these places lead, as a parabola through three of them goes on."""
        ways = [one for one, _ in self.before]
        shares = [np.prod([(way - b) / (a - b) for b in ways if b != a]) for a in ways]
        return {
            p: complex(sum(share * at[p] for share, (_, at) in zip(shares, self.before, strict=True)))
            for p in self.places
        }


@dataclass(slots=True, eq=False)
class Follower:
    """The places of all letters, step by step from the mechanism's own position on; none is drawn twice."""

    mech: Mechanism
    groups: tuple[Group, ...]
    step: float
    by_trial: frozenset[str]  # letters of groups without two meeting points
    stands: dict[int, Stand] = field(default_factory=dict)
    ends: dict[int, tuple[float, VecpolyError]] = field(default_factory=dict)

    def at(self, position: float) -> Stand:
        """The place of this position (rad, or m). Raises AssemblyError, DeadPointError where the way there ends."""
        way = position - self.mech.drive.position
        sense = 1 if way >= 0 else -1
        if sense in self.ends and abs(way) >= self.ends[sense][0]:
            raise self.ends[sense][1].with_traceback(None)  # it would grow with every raise, and keep all frames
        try:
            return self._reached(way, sense)
        except VecpolyError as error:
            self.ends[sense] = (abs(way), error)
            raise

    def _reached(self, way: float, sense: int) -> Stand:
        number = int(way / self.step)
        for k in range(sense, number + sense, sense):
            if k not in self.stands:
                self.stands[k] = replace(self._gone(self.stands[k - sense], k * self.step), desk=None)
        return self._gone(self.stands[number], way)

    def _gone(self, stand: Stand, way: float) -> Stand:
        """On from a place, in shorter strides where one does not see how."""
        stride = way - stand.way
        while stand.way != way:
            stride = way - stand.way if abs(way - stand.way) <= abs(stride) else stride
            last = abs(stride) < FINEST * self.step
            found = self._next(stand, way if stride == way - stand.way else stand.way + stride, last=last)
            stand, stride = (stand, stride / 2) if found is None else (found, 2 * stride)
        return stand

    def _next(self, stand: Stand, way: float, *, last: bool) -> Stand | None:
        """The next place; None where one does not see how, unless strides come no shorter."""
        led = stand.led(way)
        try:
            desk, rolled = self._rolled(stand, way, led, stand.taken)
            if last and desk.sides.nearest:
                kept = {key: side for key, side in stand.taken.items() if key not in desk.sides.nearest}
                desk, rolled = self._rolled(stand, way, led, kept)
        except VecpolyError:
            if last:
                raise
            return None
        places = letters(desk)
        if not last and (desk.sides.nearest or self._is_jump(stand.places, led, places)):
            return None
        before = ((way, places), *stand.before[:2])
        return Stand(way=way, places=places, taken=desk.sides.taken, before=before, rolled=rolled, desk=desk)

    def _is_jump(self, here: Places, led: Places, there: Places) -> bool:
        gone, off = (max((abs(there[p] - one[p]) for p in self.by_trial), default=0.0) for one in (here, led))
        return off > JUMP * gone + SAME * self.mech.scale

    def drawn(self, position: float) -> tuple[Desk, tuple[Group, ...]]:
        """The position diagram there by an exact hand, the drive at unit rate; and the groups."""
        stand = self.at(position)
        return stand.desk or self._drawn(stand.way, stand.places, stand.taken, stand.rolled.told), self.groups

    def _rolled(self, stand: Stand, way: float, led: Places, kept: Mapping[Key, int]) -> tuple[Desk, Contacts]:
        """Drawn where gears have rolled on from this place, and how they stand."""
        return rolled_on(lambda told: self._drawn(way, led, kept, told), stand.rolled, way - stand.way)

    def _drawn(self, way: float, led: Places, kept: Mapping[Key, int], told: Iterable[float]) -> Desk:
        mech = with_told(moved(self.mech, self.mech.drive.position + way, led), told)
        return drawn(mech, self.groups, Sides(kept=_carried(mech, kept)))

    def comes_to(self, mech: Mechanism, places: Places) -> bool:
        """Whether it comes to these places at this mechanism's own position."""
        try:
            found = self.at(mech.drive.position).places
        except VecpolyError:
            return False
        return all(abs(found[p] - at) < SAME * mech.scale for p, at in places.items())


@dataclass(slots=True, eq=False)
class Assemblies:
    """The followers of one mechanism, each of another of its assemblies."""

    found: list[Follower] = field(default_factory=list)

    def of(self, mech: Mechanism) -> Follower:
        """That which comes to this mechanism's own position; begun there where none does."""
        groups = decompose(mech)
        desk = drawn(mech, groups)
        places = letters(desk)
        one = next((one for one in self.found if one.comes_to(mech, places)), None)
        if one is None:
            one = _begun(mech, groups, desk)
            self.found.append(one)
        return one


@lru_cache(maxsize=256)
def follower(mech: Mechanism) -> Follower:
    """Of a mechanism in its own position: the same for all its positions that follow from each other.

    Raises AssemblyError, DeadPointError where its own position cannot be drawn.
    """
    mech = opened(replace(mech, drives=tuple(replace(drive, rate=1.0, accel=0.0) for drive in mech.drives)))
    mech = touching(mech)
    return _assemblies(moved(mech, 0.0, {})).of(mech)


@lru_cache(maxsize=64)
def _assemblies(bare: Mechanism) -> Assemblies:
    """Of a mechanism without a position of its own, and without the statements that are read there."""
    return Assemblies()


def _begun(mech: Mechanism, groups: tuple[Group, ...], own: Desk) -> Follower:
    places, taken = letters(own), own.sides.taken
    trial = [group for group in groups if group.dyad is None and group.ram is None]
    found = frozenset(p for group in trial for link in group.links for p in mech.link(link).points)
    step = (BY_TRIAL if trial else STEP) * (mech.scale if mech.drive.slide else 1.0)
    one = Follower(mech=mech, groups=groups, step=step, by_trial=found & places.keys())
    first = Stand(way=0.0, places=places, taken=taken, before=((0.0, places),), rolled=contacts(own))
    for way in (SEED * step, -SEED * step):
        try:
            beside = letters(one._rolled(first, way, places, taken)[0])
        except VecpolyError:
            continue
        first = replace(first, before=(*first.before, (way, beside)))
        break
    one.stands[0] = first
    return one


def moved(mech: Mechanism, position: float, led: Mapping[str, complex]) -> Mechanism:
    """The mechanism with its drive there, its letters near these places, and the statements that hold all round; with
    discs that touch there for its profiles."""
    drives = (replace(mech.drive, position=position), *mech.drives[1:])
    held = tuple(one for one in mech.branches if isinstance(one, Shaped))
    guesses = {**mech.guesses, **led} if led else {}
    return touching(replace(mech, drives=drives, branches=held, guesses=guesses))


def _carried(mech: Mechanism, kept: Mapping[Key, int]) -> Mapping[Key, int]:
    """The sides that are carried on: not that of a cam's follower, whose disc is another in every place."""
    ends = {profile.end for profile in mech.cams}
    return {key: side for key, side in kept.items() if key[0] not in ends} if ends else kept


def drawn(mech: Mechanism, groups: tuple[Group, ...], sides: Sides | None = None) -> Desk:
    """The position diagram by an exact hand, on scratch paper."""
    desk = position_desk(mech, groups, sides=sides)
    draw_positions(desk, groups)
    return desk


def draw_positions(desk: Desk, groups: tuple[Group, ...]) -> None:
    """Drives and groups where they are."""
    draw_drives(desk, Stage.POSITION)
    for group in groups:
        draw_group(desk, Stage.POSITION, group)
        letter_contacts(desk, group.links)


def letters(desk: Desk) -> Places:
    """All letters as drawn (m)."""
    return {letter: complex(nominal(at)) / desk.mm(1.0) for letter, at in desk.at.items()}
