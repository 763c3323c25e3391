"""Another link as the driver (假想原动件): a drive between two moving links whose group is no dyad with the cylinder as
a side.

A link on the frame is thought to drive. Its position is found by trial: the groups are drawn until the cylinder has the
given length.
Velocities are proportional to its ω (or v): a polygon drawn with the rate 1 gives the factor. Accelerations are those
with α = 0 and a part
proportional to α, with the same factor. All trials are drawn on scratch paper by an exact hand; nothing else is known
of the mechanism.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from math import degrees, floor, log10, pi, remainder

import numpy as np

from ..algebra.quantity import number
from ..board.board import Scratch
from ..board.construction import Scale, View
from ..board.hand import hand
from ..board.place import views
from ..errors import AssemblyError, DeadPointError, NoMethodError, VecpolyError
from ..mechanism.assembly.bend import bend
from ..mechanism.assembly.branch import margin
from ..mechanism.groups.assur import Group, decompose
from ..mechanism.model import FRAME, Drive, Mechanism, Prismatic, Revolute
from ..mechanism.rams import driven_joint
from ..names import At, alpha, omega
from ..plane import nominal
from ..words import Words
from .coincident import coincident_letters
from .desk import Desk
from .kinematics.doors import draw_drive, draw_group
from .kinematics.image import found_tip
from .registry import Stage, find
from .roots import crossings

TRIALS = 360  # places in which the other link is tried
REACH = 2.0  # of the mechanism's size to either side: where a sliding one is tried
VANISHES = 1e-9  # of the mechanism's size: below it the cylinder does not move the link
_MOTION = (Stage.POSITION, Stage.VELOCITY, Stage.ACCELERATION)


@dataclass(frozen=True, slots=True)
class Exchange:
    """The mechanism with the other driver, and what is to be said of it at the beginning of each stage."""

    mech: Mechanism
    said: Mapping[Stage, Words] = field(default_factory=dict)


@lru_cache(maxsize=128)  # all places of a player's turn, each drawn again at other scales
def exchanged(mech: Mechanism, stages: tuple[Stage, ...]) -> Exchange:
    """The mechanism itself where its groups can be drawn as they are; else driven by another link, moved so that the
    input is as given.

    Raises NoMethodError, AssemblyError, DeadPointError.
    """
    group = next((g for g in decompose(mech) if g.kind == "driven"), None)
    if group is None:
        return Exchange(mech)
    drive = next(one for one in mech.drives if one.between and one.pair <= set(group.links))
    other = _other(mech, group, drive)
    mech = replace(mech, branches=(*mech.branches, *bend(mech, drive)))  # what the angle says of the assembly
    trial = _trial(mech, drive, other)
    placed = replace(other, position=_position(trial))
    moving = Stage.VELOCITY in stages or Stage.ACCELERATION in stages
    rated = _rated(trial, placed, Stage.ACCELERATION in stages) if moving else placed
    return Exchange(_driven_by(mech, drive, rated), _said(trial, rated))


def _other(mech: Mechanism, group: Group, drive: Drive) -> Drive:
    """A link of the group on the frame with which as the driver everything is drawn by methods on file."""
    for out in group.outer:
        if (
            out.parent == FRAME
            and isinstance(out.joint, Revolute | Prismatic)
            and not (isinstance(out.joint, Prismatic) and out.joint.block != out.link)
        ):
            other = Drive(link=out.link, position=0.0, rate=1.0, slide=isinstance(out.joint, Prismatic))
            if _drawable(_driven_by(mech, drive, other)):
                return other
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


def _driven_by(mech: Mechanism, drive: Drive, other: Drive) -> Mechanism:
    return replace(mech, drives=tuple(other if one == drive else one for one in mech.drives))


@lru_cache(maxsize=4)
def _structure(mech: Mechanism) -> tuple[tuple[Group, ...], dict[float, float]]:
    """The groups of a mechanism driven by the other link, and what trials have shown of it so far: neither knows the
    input's position."""
    return decompose(mech), {}


def _trial(mech: Mechanism, drive: Drive, other: Drive) -> _Trial:
    return _Trial(mech, drive, other, *_structure(_driven_by(mech, drive, other)))


@dataclass(frozen=True, slots=True)
class _Trial:
    """Trials of one exchange: the mechanism, its own drive, the link that is thought to drive, the groups then, and the
    input at each trial."""

    mech: Mechanism
    drive: Drive
    other: Drive
    groups: tuple[Group, ...]
    seen: dict[float, float]

    def desk(self, other: Drive, *stages: Stage) -> Desk:
        """Scratch paper on which these stages are drawn."""
        mech = _driven_by(self.mech, self.drive, other)
        sizes = {view: mech.scale / 100 if view is View.MECHANISM else 0.01 for view in views()}
        unit = {view: Scale(symbol="μ", value=size, unit="") for view, size in sizes.items()}
        desk = Desk(board=Scratch(hand("exact"), unit), mech=mech, coincident=coincident_letters(mech, self.groups))
        desk.at = {name: at * desk.mm(1.0) for name, at in mech.frame.items()}
        for stage in stages:
            for drive in (one for one in mech.drives if not one.between):
                draw_drive(desk, stage, drive)
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


def _position(trial: _Trial) -> float:
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


def _undecided(trial: _Trial, found: int, fits: int) -> AssemblyError:
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


def _rated(trial: _Trial, placed: Drive, bent: bool) -> Drive:
    """The other link's rates: ω = v / v*, α = (a - a*) / v*, v* the input's rate at ω = 1, a* its acceleration at α =
    0."""
    factor = trial.rate(trial.desk(replace(placed, rate=1.0), Stage.POSITION, Stage.VELOCITY), View.VELOCITY)
    size = (
        trial.mech.scale
        if trial.drive.slide and not placed.slide
        else 1.0 / trial.mech.scale
        if placed.slide and not trial.drive.slide
        else 1.0
    )
    if abs(factor) < VANISHES * size:
        raise DeadPointError(
            Words(
                f"输入 {trial.drive.on}-{trial.drive.link} 处于死点：构件 {placed.link} 转动时其长度不变，"
                "速度无确定值；请改变位置",
                f"the input {trial.drive.on}-{trial.drive.link} is at a dead point: it "
                f"does not change while link {placed.link} moves, so the velocities have "
                "no single value; choose another position",
            )
        )
    rate = trial.drive.rate / factor
    if not bent:
        return replace(placed, rate=rate)
    even = trial.rate(trial.desk(replace(placed, rate=rate), *_MOTION), View.ACCELERATION)
    return replace(placed, rate=rate, accel=(trial.drive.accel - even) / factor)


def _said(trial: _Trial, rated: Drive) -> dict[Stage, Words]:
    """How the other link's motion was found."""
    drive, link = trial.drive, rated.link
    symbol, rates = ("s", ("v", "a")) if rated.slide else ("φ", ("ω", "α"))
    own, given = (("m/s", "m/s²") if one.slide else ("rad/s", "rad/s²") for one in (rated, drive))
    place, factor = _shown(rated.position, rated.slide), drive.rate / rated.rate if rated.rate else 0.0
    tried, tried_en = _tried(trial, rated)
    first = Words(
        f"输入加在活动构件 {drive.on}、{drive.link} 之间：改取构件 {link} 为假想原动件，"
        f"取一系列 ${symbol}_{link}$ 逐组作图试凑{tried}，当 ${symbol}_{link}$ = {place} 时输入恰为给定的 "
        f"{_shown(drive.position, drive.slide)}。",
        f"The input acts between the moving links {drive.on} and {drive.link}: let link {link} "
        f"drive instead and draw the groups for trial values of ${symbol}_{link}${tried_en}; with "
        f"${symbol}_{link}$ = {place} the input has its given "
        f"{_shown(drive.position, drive.slide)}.",
    )
    ratio = (
        f"{number(factor, 4)} {given[0]}",
        f"{number(drive.rate, 4)} {given[0]}",
        f"${rates[0]}_{link}$ = {number(rated.rate, 4)} {own[0]}",
    )
    second = Words(
        f"各速度与 ${rates[0]}_{link}$ 成正比：先取 ${rates[0]}_{link}$ = 1 {own[0]} 试作速度多边形，"
        f"得输入的速度为 {ratio[0]}；实际为 {ratio[1]}，故 {ratio[2]}。",
        f"All velocities are proportional to ${rates[0]}_{link}$: a trial polygon with "
        f"${rates[0]}_{link}$ = 1 {own[0]} gives the input the rate {ratio[0]}; it is "
        f"{ratio[1]}, so {ratio[2]}.",
    )
    even = (
        f"{number(drive.accel - rated.accel * factor, 4)} {given[1]}",
        f"{number(drive.accel, 4)} {given[1]}",
        f"${rates[1]}_{link}$ = {number(rated.accel, 4)} {own[1]}",
    )
    third = Words(
        f"先取 ${rates[1]}_{link}$ = 0 试作加速度多边形，得输入的加速度为 {even[0]}，实际为 {even[1]}；"
        f"差额与 ${rates[1]}_{link}$ 成正比（比例同速度），故 {even[2]}。",
        f"A trial polygon with ${rates[1]}_{link}$ = 0 gives the input the acceleration "
        f"{even[0]}; it is {even[1]}. The rest is proportional to ${rates[1]}_{link}$ by the "
        f"factor of the velocities, so {even[2]}.",
    )
    return {Stage.POSITION: first, Stage.VELOCITY: second, Stage.ACCELERATION: third}


def _tried(trial: _Trial, rated: Drive) -> tuple[str, str]:
    """Two of the trials, at round places to either side of the one found."""
    step = 10.0 ** floor(log10(0.1 * trial.mech.scale)) if rated.slide else pi / 36
    near = step * round(rated.position / step)
    shown = [(at, trial.gap(at)) for at in (near - step, near + step)]
    told = [
        (_shown(at, rated.slide), _shown(trial.drive.position + gap, trial.drive.slide))
        for at, gap in shown
        if np.isfinite(gap)
    ]
    if not told:
        return "", ""
    return "（" + "，".join(f"{at} 时得 {got}" for at, got in told) + "）", " (" + ", ".join(
        f"{at} gives {got}" for at, got in told
    ) + ")"


def _shown(position: float, slide: bool) -> str:
    """620 mm, or 52.5°: as near as paper shows it."""
    return f"{number(1e3 * position, 4)} mm" if slide else f"{number(degrees(position), 4)}°"
