"""Reactions of a class III group one leg of which has two slides: that leg by itself, then the two legs with an axis.

The leg presses on the central link square to the one of its slides, and is held square to the other: two unknown forces
of known direction, found by its own polygon. What the other two legs press along their axes closes the polygon of all
the rest. Where the two slides' reactions act is told by ΣM = 0 of the central link, and then of the leg.
"""

from __future__ import annotations

from ....board.construction import Pane
from ....mechanism.groups.assur import Group
from ....plane import Points, nominal
from ....words import Words
from ...kinematics.class_iii.star import Parallel, Slotted, Star
from ..acting import NO_LETTER, Acting, Drawn
from ..bodies.link_polygon import draw_polygon, pane_of
from ..groups.body import group_pane
from ..groups.polygon import name_side
from ..groups.reactions import lean, settle_slide
from ..lines.arms import Turning, acting_on, joined, moments_about, moments_at, moments_of
from ..lines.resultant import Resultant
from ..readings import SAME, say_measured
from ..state import Statics
from .chain import Sides, draw_chain_of_two
from .legs import Pressed, pressed
from .settling_legs import draw_group_body, name_legs, settle_leg


def forces_two_slides(st: Statics, group: Group, star: Star, leg: Parallel) -> None:
    """ΣF = 0 of the leg, then of the rest of the group; ΣM = 0 of the central link, then of the leg."""
    links, pane = group.links, group_pane(st, *group.links)
    on_plate, on_leg = _leg_alone(st, star, leg, links)
    one, two = (pressed(st, star, axial, links) for axial in star.axial)
    about = one.inner
    turning = moments_at(st, pane, (star.plate,), st.desk.at[about])
    sides = draw_chain_of_two(st, _rest(links, leg), star.plate, (one, two), _pushed(st, star, leg, on_plate))
    name_legs(st, star, (one, two), sides)
    for each, found in zip((one, two), sides, strict=True):
        settle_leg(st, star, each, found, links)
    turning = joined(
        turning, *(_on_plate(st, star, pane, *pair, about) for pair in zip((one, two), sides, strict=True))
    )
    settle_slide(st, links, leg.link, star.plate, on_plate, (about, turning))
    pin = leg.slide.pin if leg.slide.pin in st.mech.link(leg.link).points else leg.guide.pin
    settle_slide(st, links, leg.parent, leg.link, on_leg, (pin, moments_about(st, pane, (leg.link,), pin)))
    draw_group_body(st, star, (one, two), links)


def _rest(links: tuple[str, ...], leg: Parallel) -> tuple[str, ...]:
    return tuple(link for link in links if link != leg.link)


def _leg_alone(st: Statics, star: Star, leg: Parallel, links: tuple[str, ...]) -> tuple[Drawn, Drawn]:
    """The force of the leg on the central link, and that of its parent on the leg."""
    number = st.mech.number(leg.link)
    inner, outer = (lean(st, links, leg.slide, star.plate, leg.link), lean(st, links, leg.guide, leg.parent, leg.link))
    names = st.named(star.plate, leg.link), st.named(leg.parent, leg.link)
    known = acting_on(st, leg.link)
    if not known:
        one, two = (f"${named.symbol}$" for named in names)
        st.board.step(
            Words(
                f"构件 {number} 上无已知力（至多有力偶）；{one}、{two} 方向不同，其和为零，故 {one} = {two} = 0。",
                f"No known force acts on link {number}, but a couple at most; {one} and {two} have different "
                f"directions and sum to zero, so {one} = {two} = 0.",
            )
        )
        none = Drawn(place=group_pane(st, *links), start=0j, end=0j, letters=f"{NO_LETTER} {NO_LETTER}")
        return none, none
    st.board.step(
        Words(
            f"构件 {number} 的两移动副反力方向均已知：列其力平衡方程，按 $μ_F$ 作力多边形，各力首尾相接。",
            f"The forces of both slides of link {number} have known directions: write its equilibrium and draw its "
            "polygon to $μ_F$, the forces head to tail.",
        ),
        pane_of(st, leg.link),
    )
    load = Resultant(forces=tuple(known), vector=0j, at=0j)
    found = draw_polygon(st, leg.link, load, (outer.sought(st), inner.sought(st)))
    sides = [found[named.key] for named in names]
    say_measured(st, tuple((named.symbol, side) for named, side in zip(names, sides, strict=True)))
    name_side(st, sides[0], star.plate, leg.link)
    name_side(st, sides[1], leg.parent, leg.link)
    return sides[0].reversed(), sides[1]


def _pushed(st: Statics, star: Star, leg: Parallel, drawn: Drawn) -> list[Acting]:
    """The leg's force on the central link, for the polygon: its place is not known yet."""
    vector: Points = drawn.end - drawn.start
    if abs(complex(nominal(vector))) < SAME:
        return []
    return [Acting(named=st.named(leg.link, star.plate), vector=vector, at=0j, drawn=drawn)]


def _on_plate(st: Statics, star: Star, pane: Pane, one: Pressed, both: Sides, letter: str) -> Turning:
    """The moment of a leg on the central link about a letter: its force in its pin, what a leg in a slot turns beside
    it. What friction turns at the pin is among the couples of the central link."""
    force = Acting(
        named=st.named(one.leg.link, star.plate),
        vector=both.inner.end - both.inner.start,
        at=st.desk.at[one.inner],
        drawn=both.inner,
    )
    small = abs(complex(nominal(force.vector))) < SAME
    turned = moments_of(st, pane, [] if small else [force], st.desk.at[letter])
    if isinstance(one.leg, Slotted):
        assert one.placed is not None
        return joined(turned, one.placed[1])
    return turned
