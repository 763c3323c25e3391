"""The reactions of the legs of a class III group, once its polygon is drawn: named on it, and put where they act."""

from __future__ import annotations

from typing import assert_never

from ....words import Words
from ...kinematics.class_iii.star import Guided, Hinged, Slotted, Star
from ..acting import Drawn
from ..bodies.link_polygon import closing_side, pane_of
from ..groups.body import draw_forces, group_pane
from ..groups.polygon import name_side
from ..groups.reactions import settle_pin, settle_slide
from ..lines.arms import acting_on
from ..lines.resultant import Resultant
from ..readings import say_measured
from ..state import Statics
from .chain import Sides
from .legs import Pressed


def name_legs(st: Statics, star: Star, legs: tuple[Pressed, ...], sides: tuple[Sides, ...]) -> None:
    """Every reaction that is a side or a diagonal, measured and named."""
    found: list[tuple[str, str, Drawn]] = []
    for one, both in zip(legs, sides, strict=True):
        if not isinstance(one.leg, Slotted):
            found.append((one.leg.parent, one.leg.link, both.outer))
        found.append((one.leg.link, star.plate, both.inner))
    say_measured(st, tuple((st.named(by, on).symbol, drawn) for by, on, drawn in found))
    for by, on, drawn in found:
        name_side(st, drawn, by, on)


def settle_leg(st: Statics, star: Star, one: Pressed, both: Sides, links: tuple[str, ...]) -> None:
    """Where each reaction of the leg acts."""
    match one.leg:
        case Hinged(link=link, parent=parent, outer=o, inner=b):
            settle_pin(st, parent, link, o, both.outer)
            settle_pin(st, link, star.plate, b, both.inner)
        case Guided(link=link, parent=parent, inner=b):
            assert one.placed is not None
            settle_slide(st, links, parent, link, both.outer, one.placed)
            settle_pin(st, link, star.plate, b, both.inner)
        case Slotted(link=link, parent=parent, outer=q):
            assert one.placed is not None
            outer = both.inner if not acting_on(st, link) else None
            settle_slide(st, links, star.plate, link, both.inner.reversed(), one.placed)
            settle_pin(st, parent, link, q, outer or _closing(st, parent, link))
        case _:
            assert_never(one.leg)


def _closing(st: Statics, parent: str, link: str) -> Drawn:
    """The force of a pin on a leg whose other forces are all known, by a polygon of its own."""
    named, number = st.named(parent, link), st.mech.number(link)
    st.board.step(
        Words(
            f"列构件 {number} 的力平衡方程，作其力多边形，得 ${named.symbol}$。",
            f"Write the equilibrium of link {number} and draw its polygon, which gives ${named.symbol}$.",
        ),
        pane_of(st, link),
    )
    rest = Resultant(forces=tuple(acting_on(st, link)), vector=0j, at=0j)
    return closing_side(st, parent, link, rest)


def draw_group_body(st: Statics, star: Star, legs: tuple[Pressed, ...], links: tuple[str, ...]) -> None:
    """All forces on the group at their lines of action; what its links do to each other stays inside."""
    own = {st.named(by, on).key for leg in star.legs for by, on in ((leg.link, star.plate), (star.plate, leg.link))}
    own |= {st.named(leg.parent, leg.link).key for leg in star.axial}
    forces = [force for link in links for force in st.known(link) if force.named.key not in own]
    for one in legs:
        whole = st.push(one.leg.parent, one.leg.link)
        outer = one.reaction.parts(st) if not isinstance(one.leg, Slotted) else [] if whole is None else [whole]
        forces += outer
    draw_forces(st, group_pane(st, *links), links, forces)
