"""Another link as the driver (假想原动件):
a drive between two moving links whose group is no dyad with the cylinder as a side.

A link on the frame is thought to drive. Its position is found by trial: the groups are drawn until the cylinder has the
given length. Velocities are proportional to its ω (or v): a polygon drawn with the rate 1 gives the factor.
Accelerations are those with α = 0 and a part proportional to α, with the same factor. All trials are drawn on scratch
paper by an exact hand; nothing else is known of the mechanism.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from functools import lru_cache
from math import pi

import numpy as np

from ...board.construction import View
from ...errors import AssemblyError, DeadPointError, NoMethodError, VecpolyError
from ...foundation.slotted import dataclass, replace
from ...mechanism.assembly.bend import bend
from ...mechanism.assembly.branch import margin
from ...mechanism.groups.assur import Group, decompose
from ...mechanism.model import FRAME, Drive, Mechanism, Prismatic, Revolute
from ...plane import nominal
from ...words import Words
from ..desk import Desk
from ..registry import Stage, find
from ..roots import crossings
from .profile import osculated
from .told import said
from .trial import Trial, driven_by, trial_of

TRIALS = 360  # places in which the other link is tried
REACH = 2.0  # of the mechanism's size to either side: where a sliding one is tried
STILL = 20.0  # times the mechanism's size (or 1): an input that is so fast at ω = 1 moves a link that hardly turns
VANISHES = 1e-9  # of the mechanism's size: below it the cylinder does not move the link
_MOTION = (Stage.POSITION, Stage.VELOCITY, Stage.ACCELERATION)


@dataclass(frozen=True, slots=True)
class Exchange:
    """The mechanism with the other driver, and what is to be said of it at the beginning of each stage."""

    mech: Mechanism
    said: Mapping[Stage, Words] = field(default_factory=dict)


@lru_cache(maxsize=128)  # all places of a player's turn, each drawn again at other scales
def exchanged(mech: Mechanism, stages: tuple[Stage, ...]) -> Exchange:
    """The mechanism itself where its groups can be drawn as they are;
    else driven by another link, moved so that the input is as given.

    Raises NoMethodError, AssemblyError, DeadPointError.
    """
    mech, profiles = osculated(mech)
    by_centres = Stage.CENTRES in stages  # centres lead on from a link whose motion against the frame is known
    group = next((g for g in decompose(mech) if g.kind == "driven" or (by_centres and _driven_in(mech, g))), None)
    if group is None:
        return Exchange(mech, {} if profiles is None else {Stage.POSITION: profiles})
    drive = next(one for one in mech.drives if one.between and one.pair <= set(group.links))
    others = _others(mech, group, drive)
    mech = replace(mech, branches=(*mech.branches, *bend(mech, drive)))  # what the angle says of the assembly
    if not {Stage.VELOCITY, Stage.ACCELERATION, Stage.CENTRES} & set(stages):
        trial = trial_of(mech, drive, others[0])
        placed = replace(others[0], position=_position(trial))
        return Exchange(_thought(mech, drive, placed), said(trial, placed))
    trial, placed, factor = _liveliest(mech, drive, others)
    rated = _rated(trial, placed, factor, Stage.ACCELERATION in stages)
    return Exchange(_thought(mech, drive, rated), said(trial, rated))


def _thought(mech: Mechanism, drive: Drive, other: Drive) -> Mechanism:
    """The mechanism with the other link as the driver, which still knows its own drive."""
    return replace(driven_by(mech, drive, other), instead_of=drive)


def _liveliest(mech: Mechanism, drive: Drive, others: Sequence[Drive]) -> tuple[Trial, Drive, float]:
    """The first link that does not nearly stand still while the input acts, with the input's rate at its ω = 1; else
    the one that does so least: all else would be magnified from what hardly moves."""
    first, *rest = others
    trial = trial_of(mech, drive, first)
    placed = replace(first, position=_position(trial))
    found = [(trial, placed, _factor(trial, placed))]
    if _moves(*found[0]):
        return found[0]
    desk = trial.desk(placed, Stage.POSITION)
    for other in (one for one in rest if not one.slide):
        with suppress(VecpolyError):  # the first can be drawn, though badly
            another = trial_of(mech, drive, other)
            there = replace(other, position=float(np.angle(nominal(desk.axis(other.link)))))
            found.append((another, there, _factor(another, there)))
    return min(found, key=lambda one: abs(one[2]) / _unit(one[0], one[1]))


def _moves(trial: Trial, placed: Drive, factor: float) -> bool:
    """Whether the other link does not nearly stand still while the input acts."""
    return abs(factor) < STILL * _unit(trial, placed)


def _driven_in(mech: Mechanism, group: Group) -> bool:
    """Whether a drive between two moving links acts within the group."""
    return any(drive.between and drive.pair <= set(group.links) for drive in mech.drives)


def _others(mech: Mechanism, group: Group, drive: Drive) -> list[Drive]:
    """The links of the group on the frame with which as the driver everything is drawn by methods on file."""
    outer = (out for out in group.outer if out.parent == FRAME and isinstance(out.joint, Revolute | Prismatic))
    own = (out for out in outer if not (isinstance(out.joint, Prismatic) and out.joint.block != out.link))
    thought = [Drive(link=o.link, position=0.0, rate=1.0, slide=isinstance(o.joint, Prismatic)) for o in own]
    if found := [other for other in thought if _drawable(driven_by(mech, drive, other))]:
        return found
    raise NoMethodError(
        Words(
            f"驱动加在构件 {drive.on} 与 {drive.link} 之间；无论取哪个与机架相连的构件为假想原动件，"
            f"都不能只用已有的图解法求解 {group.name.zh}；vecpoly exact 给出其解析解",
            f"the input acts between links {drive.on} and {drive.link}; whichever link on "
            f"the frame is thought to drive instead, the {group.name.en} cannot be drawn "
            "by the methods on file; 'vecpoly exact' gives its analytic answers",
        ),
        code="no-exchange",
    )


def _drawable(mech: Mechanism) -> bool:
    try:
        for group in decompose(mech):
            for stage in _MOTION:
                find(stage, group.kind)
    except VecpolyError:
        return False
    return True


def _position(trial: Trial) -> float:
    """Where the other link stands when the input has its given position and the branch statements hold."""
    mech = trial.mech
    low, high = (-REACH * mech.scale, REACH * mech.scale) if trial.other.slide else (0.0, 2 * pi)
    found = crossings(
        trial.gap, np.linspace(low, high, TRIALS + 1).tolist(), 1e-3 * mech.scale if trial.drive.slide else 1e-3
    )
    places = ((at, trial.desk(replace(trial.other, position=at), Stage.POSITION)) for at in found)
    fits = [(at, desk) for at, desk in places if all(margin(s, _metres(desk)) > 0 for s in mech.branches)]
    if len(fits) > 1 and mech.guesses:
        fits = [min(fits, key=lambda fit: sum(abs(_metres(fit[1])[p] - place) for p, place in mech.guesses.items()))]
    if len(fits) != 1:
        raise _undecided(trial, len(found), len(fits))
    return fits[0][0]


def _metres(desk: Desk) -> dict[str, complex]:
    """All letters as drawn (m)."""
    return {letter: complex(nominal(at)) / desk.mm(1.0) for letter, at in desk.at.items()}


def _undecided(trial: Trial, found: int, fits: int) -> AssemblyError:
    link, input_ = trial.other.link, f"{trial.drive.on}-{trial.drive.link}"
    if not found:
        trial_at = replace(trial.other, position=trial.other.position)
        try:
            trial.desk(trial_at, Stage.POSITION)
        except DeadPointError:
            pass
        except AssemblyError as error:  # it says what is missing, a branch as a rule
            return error
        return AssemblyError(
            Words(
                f"无论构件 {link} 在何位置，输入 {input_} 都达不到给定值；请改变输入或尺寸",
                f"wherever link {link} stands, the input {input_} does not reach its given position; change it, or "
                "the lengths",
            ),
            code="out-of-reach",
        )
    if not fits:
        return AssemblyError(
            Words(
                f"试得构件 {link} 有 {found} 个位置满足输入 {input_}，但都不符合 branch 中的说明",
                f"link {link} has {found} positions for the input {input_}, but none of them fulfils the branch "
                "statements",
            ),
            code="no-branch",
        )
    return AssemblyError(
        Words(
            f"试得构件 {link} 有 {fits} 个位置满足输入 {input_}；请在 branch 中写明构件 {link} 在哪一侧，"
            "或以 guesses 给出各点的大致位置",
            f"link {link} has {fits} positions for the input {input_}; say in 'branch' "
            f"on which side link {link} lies, or give rough places as guesses",
        ),
        code="undecided-assembly",
    )


def _unit(trial: Trial, placed: Drive) -> float:
    """The rate of an input that goes with the rate 1 of the other link, by the mechanism's size alone."""
    if trial.drive.slide is placed.slide:
        return 1.0
    return trial.mech.scale if trial.drive.slide else 1.0 / trial.mech.scale


def _factor(trial: Trial, placed: Drive) -> float:
    """The input's rate while the other link has the rate 1. Raises DeadPointError where the input does not change."""
    factor = trial.rate(trial.desk(replace(placed, rate=1.0), Stage.POSITION, Stage.VELOCITY), View.VELOCITY)
    if abs(factor) < VANISHES * _unit(trial, placed):
        raise DeadPointError(
            Words(
                f"输入 {trial.drive.on}-{trial.drive.link} 处于死点：构件 {placed.link} 转动时其长度不变，"
                "速度无确定值；请改变位置",
                f"the input {trial.drive.on}-{trial.drive.link} is at a dead point: it "
                f"does not change while link {placed.link} moves, so the velocities have "
                "no single value; choose another position",
            )
        )
    return factor


def _rated(trial: Trial, placed: Drive, factor: float, bent: bool) -> Drive:
    """The other link's rates: ω = v / v*, α = (a - a*) / v*, v* the input's rate at ω = 1, a* its acceleration at α =
    0."""
    rate = trial.drive.rate / factor
    if not bent:
        return replace(placed, rate=rate)
    even = trial.rate(trial.desk(replace(placed, rate=rate), *_MOTION), View.ACCELERATION)
    return replace(placed, rate=rate, accel=(trial.drive.accel - even) / factor)
