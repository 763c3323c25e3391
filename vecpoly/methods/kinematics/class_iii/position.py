"""A class III group located by trial (试凑法): the central link is turned,
held by two legs, until the third fits too."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Role
from ....errors import AssemblyError, DeadPointError
from ....mechanism.assembly.branch import margin
from ....mechanism.assembly.told import as_guesses, which
from ....mechanism.groups.assur import Group
from ....mechanism.model import Statement
from ....plane import Points
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..position.assembly import HAIR, said
from .assemblies import Assembly, assemblies, bare, places, settled, trial
from .led import led
from .loci import Ring, locus_of, meet, orientation, put
from .star import Axial, Hinged, Slotted, Star, star_of
from .words import led_words, trial_words

SHOWN = np.linspace(-0.2, 0.2, 9)  # rad from the orientation found: trials that are drawn
DULL = 1e-5  # of Assembly.sharp: below it the drawing has no position to show


@method(
    stage=Stage.POSITION,
    group="class III",
    source="机械原理, class III groups by trial",
    example="class-iii",
    title=Words("Ⅲ级杆组的位置（试凑法）", "Position of a class III group, by trial"),
)
def position_class_iii(desk: Desk, group: Group) -> None:
    """The central link is turned, held by two legs, until it fits the third as well."""
    star = star_of(group)
    near = led(desk, star)
    found, deciding = _chosen(desk, star, assemblies(desk, star)) if near is None else (near, None)
    desk.board.step(
        led_words(desk, star, found.legs) if star.parallel else trial_words(desk, star, found.legs), View.MECHANISM
    )
    which = (
        Words("（取与题给装配形式相符的一种）", "; of the possible assemblies the given one is taken")
        if deciding is None
        else said(deciding)
    )
    desk.board.remark(which + Words("。", "."))
    u = orientation(desk, star, star.parallel) if star.parallel else np.exp(1j * settled(desk, star, found))
    if not star.parallel:
        _draw_trials(desk, star, found)
    u = desk.board.turn(u)
    put(desk, star, _laid(desk, star, found, u), u)
    for leg in found.legs:
        _draw_locus(desk, star, leg)


def _chosen(desk: Desk, star: Star, options: list[Assembly]) -> tuple[Assembly, Statement | None]:
    """The assembly that branch statements and guesses mean; raises AssemblyError where they mean none, or several."""
    if not options:
        raise AssemblyError(
            Words(
                f"构件 {star.links} 不能装配：无论中心构件 {star.plate} 取什么方位，"
                "三个支链都不能同时满足（或恰在死点位置）；请检查各杆长和导路，或改换原动件的位置。",
                f"links {star.links} cannot be joined: in no orientation does link {star.plate} fit all "
                "three legs, or they stand just at a dead point; check the lengths and guides, or move the "
                "input",
            ),
            code="no-assembly",
        )
    after = [places(desk, star, option) for option in options]
    new = set(after[0]) - set(desk.at)
    told = [s for s in desk.mech.branches if set(s.letters) <= set(after[0]) and set(s.letters) & new]
    hair = HAIR * desk.mm(desk.mech.scale)
    fits = [k for k, at in enumerate(after) if all(margin(s, at) > hair for s in told)]
    guessed = {p: at * desk.mm(1.0) for p, at in desk.mech.guesses.items() if p in new}
    if not fits or (len(fits) > 1 and not guessed):
        raise AssemblyError(
            _which(desk, star, [after[k] for k in fits] or after, bool(fits)),
            code="which-assembly",
            numbers={"assemblies": len(fits) or len(options)},
        )
    best = min(fits, key=lambda k: sum(abs(after[k][p] - at) for p, at in guessed.items()))
    if options[best].sharp < DULL:
        raise DeadPointError(
            Words(
                f"构件 {star.links} 处于死点位置附近：两种装配几乎重合，不能分辨；请改换原动件的位置。",
                f"links {star.links} are at a dead point, or within a hair of it: two of their assemblies coincide and "
                "cannot be told apart; choose another input position",
            ),
            code="dead-point",
        )
    deciding = next((s for s in told if any(margin(s, at) <= hair for at in after)), None)
    return options[best], deciding


def _which(desk: Desk, star: Star, after: list[dict[str, complex]], fits: bool) -> Words:
    """The assemblies there are, by the places of the central link's points."""
    told = as_guesses(after, desk.mech.link(star.plate).axis, 1e3 / desk.mm(1.0))
    if not fits:
        return Words(
            f"构件 {star.links} 的 {len(after)} 种装配都不符合 branch 的要求；可能的装配（guesses）：{told}",
            f"links {star.links}: none of their {len(after)} assemblies fulfils the branch statements; "
            f"the assemblies are, as guesses: {told}",
        )
    return which(Words.same(star.links), len(after), told)


def _laid(desk: Desk, star: Star, found: Assembly, u: Points) -> Points:
    """The origin of the central link: two loci drawn by hand, met on the side that was found."""
    loci = [locus_of(desk, star, leg, u) for leg in found.legs[:2]]
    one, two = (
        Ring(locus.centre, desk.board.hand.carry(locus.radius)) if isinstance(locus, Ring) else locus for locus in loci
    )
    return meet(one, two)[0 if found.first else 1]


def _draw_locus(desk: Desk, star: Star, leg: Axial) -> None:
    """The arc of a bar about its pin; a guide is drawn with its slider."""
    if isinstance(leg, Hinged):
        held = desk.mech.link(leg.link).points
        desk.board.swing(
            View.MECHANISM, desk.at[leg.outer], desk.mm(abs(held[leg.inner] - held[leg.outer])), desk.at[leg.inner]
        )


def _draw_trials(desk: Desk, star: Star, found: Assembly) -> None:
    """The path of the point by which the third leg is tried, through some trials."""
    leg = found.legs[2]
    if isinstance(leg, Slotted):
        return
    theta = found.theta + SHOWN
    local = desk.mech.link(star.plate).points[leg.inner]
    path = trial(bare(desk), star, found.legs, found.first, theta) + np.exp(1j * theta) * desk.mm(1.0) * local
    seen = [complex(at) for at in np.asarray(path) if np.isfinite(at)]
    for one, next_one in pairwise(seen):
        desk.board.join(View.MECHANISM, one, next_one, Role.CONSTRUCTION)
