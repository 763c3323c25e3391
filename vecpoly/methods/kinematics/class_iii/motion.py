"""Velocity and acceleration of a class III group: its special point, a second point, then the image and the legs.

    v_S = v_O1 + (v_B1O1 + v_SB1) = v_O2 + (v_B2O2 + v_SB2),   v_B3 = v_S + v_B3S = v_O3 + v_B3O3

and the same for accelerations, whose normal parts are known by then. Where a leg with two slides keeps the central link
from turning of its own, ω and α are known, and one equation of two points of the link is enough.
"""

from __future__ import annotations

from typing import assert_never

from ....board.construction import View
from ....mechanism.groups.assur import Group
from ....mechanism.model import FRAME
from ....names import At, Kind, Rel
from ....plane import Points
from ....vector.close import Closed
from ....vector.equation import Equation
from ....words import Words
from ...desk import QUANTITY, VECTOR, Desk
from ...registry import Stage, method
from ..chains import coincident_tip, letters, never_turns, sliding_chain, solve
from ..dyads.rrr import opening, total, turn_of_link
from ..image import imaged, images_of_link
from ..terms import known
from ..turning import angular_acceleration, angular_velocity, same_turn
from .special import Special, find_special, special_of
from .star import Axial, Guided, Hinged, Parallel, Slotted, Star, called, point_of, star_of
from .ways import Chain, chain_of, on_plate, prepare, to_special, turned_on_plate

_SOURCE = "机械原理, class III groups by special points (Assur points)"


@method(
    stage=Stage.VELOCITY,
    group="class III",
    source=_SOURCE,
    example="three-legged-plate",
    title=Words("Ⅲ级杆组的速度（特殊点法）", "Velocity of a class III group, by a special point"),
)
def velocity_class_iii(desk: Desk, group: Group) -> None:
    """v_S from two legs, v_B3 from S and the third leg, the rest by the image."""
    _polygon(desk, View.VELOCITY, star_of(group))


@method(
    stage=Stage.ACCELERATION,
    group="class III",
    source=_SOURCE,
    example="three-legged-plate",
    title=Words("Ⅲ级杆组的加速度（特殊点法）", "Acceleration of a class III group, by a special point"),
)
def acceleration_class_iii(desk: Desk, group: Group) -> None:
    """a_S from two legs, a_B3 from S and the third leg, the rest by the image."""
    _polygon(desk, View.ACCELERATION, star_of(group))


def _polygon(desk: Desk, view: View, star: Star) -> None:
    for leg in star.axial:
        prepare(desk, view, leg)
    chains = (
        _over_special(desk, view, star) if star.parallel is None else _without_turning(desk, view, star, star.parallel)
    )
    images_of_link(desk, view, star.plate)
    for leg in star.axial:
        at = desk.canonical(point_of(star, leg))
        if not desk.has_tip(view, at):
            imaged(desk, view, star.plate, at)
    for leg in star.axial:
        _leg(desk, view, star, leg, chains[leg.link])
    if star.parallel:
        _slider_between(desk, view, star, star.parallel)
    for each in star.legs:
        images_of_link(desk, view, each.link)


# -- with a special point ---------------------------------------------------------------------------------------------


def _over_special(desk: Desk, view: View, star: Star) -> dict[str, Chain]:
    """v_S, then the third leg's point and the central link's ω (or α); the chains of the legs."""
    special = special_of(desk, star)
    find_special(desk, star, special)
    chains = _special_point(desk, view, star, special)
    to = desk.canonical(point_of(star, special.third))
    desk.board.step(opening(view, desk.name(to), star.plate, special.third.link), view)
    own = chain_of(desk, view, star, special.third)
    over = (known(desk, view, special.at), *on_plate(desk, view, star.plate, to, special.at, 3))
    left, right = (own, over) if len(own) <= len(over) else (over, own)
    closed = solve(desk, view, Equation(left=left, right=right, total=total(desk, view, to, len(left))), to)
    _turn(desk, view, star.plate, special.at, to, closed)
    return chains | {special.third.link: own}


def _special_point(desk: Desk, view: View, star: Star, special: Special) -> dict[str, Chain]:
    """The equation whose sides are the two legs of the pair."""
    kind, s, legs = QUANTITY[view], desk.name(special.at), called(*special.pair)
    parts = Words(
        "等式每一侧的两个未知矢量方向相同，合为一项。",
        " On either side the two unknown vectors are parallel and count as one.",
    )
    desk.board.step(
        Words(
            f"求特殊点 ${s}$ 的{kind.zh}：分别由{legs.zh} 列矢量方程并作图。",
            f"Find the {kind.en} of the special point ${s}$: write the vector equation over {legs.en} and draw it.",
        )
        + parts,
        view,
    )
    (left, own_left), (right, own_right) = (
        to_special(desk, view, star, leg, special.at, primes) for leg, primes in zip(special.pair, (1, 2), strict=True)
    )
    sought = desk.symbol(Rel(VECTOR[view], special.at))
    solve(desk, view, Equation(left=left, right=right, total=sought), special.at)
    return {special.pair[0].link: own_left, special.pair[1].link: own_right}


def _turn(desk: Desk, view: View, plate: str, about: At, to: At, closed: Closed) -> None:
    """ω (from v) or α (from a^t) of the central link."""
    rel = Rel(Kind.V if view is View.VELOCITY else Kind.AT, to, about)
    if view is View.VELOCITY:
        angular_velocity(
            desk, plate, about.point, to.point, closed.ends[rel.key], letters(desk, view, about, to), desk.symbol(rel)
        )
    else:
        line = f"{desk.n_tip(plate, 3)} {desk.tip_label(view, to)}"
        angular_acceleration(desk, plate, about.point, to.point, closed.ends[rel.key], line, desk.symbol(rel))


# -- with a leg that keeps the central link from turning ---------------------------------------------------------------


def _without_turning(desk: Desk, view: View, star: Star, leg: Parallel) -> dict[str, Chain]:
    """v_B2 = v_B1 + v_B2B1, the last known since ω is: two points of the central link, each led by its leg."""
    if leg.parent == FRAME:
        never_turns(desk, leg.link)
        never_turns(desk, star.plate)
    else:
        same_turn(desk, leg.link, leg.parent, view)
        same_turn(desk, star.plate, leg.link, view)
    one, two = star.axial
    to, ref = (desk.canonical(point_of(star, other)) for other in (two, one))
    desk.board.step(opening(view, desk.name(to), star.plate), view)
    first, second = chain_of(desk, view, star, one), chain_of(desk, view, star, two)
    way = (*first, *turned_on_plate(desk, view, star.plate, to, ref, 1))
    left, right = (second, way) if len(second) <= len(way) else (way, second)
    solve(desk, view, Equation(left=left, right=right, total=total(desk, view, to, len(left))), to)
    return {one.link: first, two.link: second}


def _slider_between(desk: Desk, view: View, star: Star, leg: Parallel) -> None:
    """The leg with two slides: its own point by both of its guides."""
    at = At(next(iter(desk.mech.link(leg.link).points)))
    bases = [coincident_tip(desk, view, at.point, name) for name in (leg.parent, star.plate)]
    desk.board.step(opening(view, at.point, leg.link), view)
    sides = [
        sliding_chain(desk, view, at, base, slide, name)
        for base, slide, name in zip(bases, (leg.guide, leg.slide), (leg.parent, star.plate), strict=True)
    ]
    left, right = sorted(sides, key=len)
    solve(desk, view, Equation(left=left, right=right, total="" if len(left) == 1 else total(desk, view, at, 2)), at)


# -- the legs, once the central link is known --------------------------------------------------------------------------


def _leg(desk: Desk, view: View, star: Star, leg: Axial, chain: Chain) -> None:
    """The leg's own relative vector, between points that are now on the polygon; its ω or α."""
    last, to = chain[-1].rel, desk.canonical(point_of(star, leg))
    assert isinstance(last, Rel)
    ends = (_known_end(desk, view, chain), desk.tip(view, to))
    desk.board.arrow_once(view, *ends, key=desk.key(last))
    match leg:
        case Hinged(link=link, outer=o):
            turn_of_link(desk, view, {last.key: ends}, to, o, link)
        case Guided(link=link, parent=parent):
            if parent == FRAME:
                never_turns(desk, link)
            else:
                same_turn(desk, link, parent, view, said=not leg.slide.pin_in_slot)
        case Slotted(link=link):
            same_turn(desk, link, star.plate, view, said=not leg.slide.pin_in_slot)
        case _:
            assert_never(leg)


def _known_end(desk: Desk, view: View, chain: Chain) -> Points:
    """Where the known terms of a leg's chain end on the polygon."""
    if len(chain) == 1:
        return 0j
    before = chain[-2].rel
    assert isinstance(before, Rel)
    stood = desk.stands(before)
    assert stood is not None
    return stood.end
