"""A leg of a class III group under its loads:
what it presses on the central link along its axis is sought, all else is known.

    hinged   R-R  R^t at the outer pin from ΣM of the leg about the inner one; R^n along the leg is sought
    guided   P-R  the block's forces act on the central link at the pin; the guide's reaction on its normal is sought
    slotted  R-P  the slide's reaction, on its normal through the outer pin, is sought; the leg's loads turn the central
                  link by their moment about that pin, and press on the pin alone
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from ....foundation.slotted import replace
from ....plane import Line, Points
from ...kinematics.class_iii.star import Axial, Guided, Hinged, Slotted, Star
from ..acting import Acting
from ..groups.body import group_pane
from ..groups.corners import Reaction, part_named
from ..groups.reactions import lean
from ..groups.rrr import split
from ..lines.arms import Turning, acting_on, joined, moments_about, moments_at, moments_of
from ..state import Statics


@dataclass(frozen=True, slots=True, kw_only=True)
class Pressed:
    """A leg with its reaction, of which the part along `line` is sought.

    placed: the point about which the leg's loads, and with them the slide's reaction, have this moment; None of a bar.
    """

    leg: Axial
    reaction: Reaction
    line: Line
    placed: tuple[str, Turning] | None = None

    @property
    def inner(self) -> str:
        """The letter at which the leg's axis passes the central link."""
        return self.leg.outer if isinstance(self.leg, Slotted) else self.leg.inner


def pressed(st: Statics, star: Star, leg: Axial, links: tuple[str, ...]) -> Pressed:
    """The leg by itself: R^t of a bar, the direction of a slide's reaction, drawn into the group's free body."""
    pane, at = group_pane(st, *links), st.desk.at
    match leg:
        case Hinged(link=link, parent=parent, outer=o, inner=b):
            bar = split(st, links, parent, link, (o, b))
            return Pressed(leg=leg, reaction=bar, line=Line(at[o], bar.line))
        case Guided(link=link, parent=parent, slide=slide, inner=b):
            held = lean(st, links, slide, parent, link)
            about = (b, moments_about(st, pane, (link,), b))
            return Pressed(leg=leg, reaction=held, line=Line(at[b], held.line), placed=about)
        case Slotted(link=link, outer=q, slide=slide):
            held = lean(st, links, slide, link, star.plate)
            about = (q, moments_about(st, pane, (link,), q))
            return Pressed(leg=leg, reaction=held, line=Line(at[q], held.line), placed=about)
        case _:
            assert_never(leg)


def forces_in_chain(st: Statics, one: Pressed) -> list[Acting]:
    """The leg's forces that reach the central link: of a leg in a slot none, they press on its own pin."""
    return [] if isinstance(one.leg, Slotted) else acting_on(st, one.leg.link)


def known_moment(st: Statics, one: Pressed, about: tuple[str, Points], links: tuple[str, ...]) -> Turning:
    """The moment on the central link about a point, of all that is known of the leg."""
    letter, place = about
    pane = group_pane(st, *links)
    match one.leg:
        case Hinged(link=link, outer=o):
            bar = one.reaction
            named = part_named(st.named(bar.by, bar.on), "t")
            across = bar.across if bar.part else None
            tangential = [] if across is None else [Acting(named=named, vector=across, at=st.desk.at[o])]
            own = moments_at(st, pane, (link,), place, letter)
            return joined(own, moments_of(st, pane, tangential, place, letter))
        case Guided(link=link, inner=b):
            moved = [replace(force, at=st.desk.at[b]) for force in acting_on(st, link)]
            return moments_of(st, pane, moved, place, letter)
        case Slotted():
            assert one.placed is not None
            return one.placed[1]
        case _:
            assert_never(one.leg)
