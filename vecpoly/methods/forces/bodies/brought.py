"""Forces whose lines pass far from their body: drawn at it, with the couple of their transfer."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.board import NO_LENGTH
from ....foundation.slotted import replace
from ....mechanism.groups.assur import ends
from ....mechanism.model import Prismatic, Rolling
from ....plane import nominal
from ....plane.geometry import cross
from ....words import Words
from ..acting import Acting
from ..state import Statics
from .arrows import REACH

AWAY = 45.0  # mm: farther from its block the reaction of a guide leaves the free body, as any force beyond REACH


def brought_near(
    st: Statics, link: str, forces: Sequence[Acting], points: Sequence[complex]
) -> tuple[list[Acting], list[tuple[str, float]]]:
    """The forces with those far off carried to the nearest point of the body, and the couples M = F h of these, each
    with its name; each is remarked on."""
    near, couples, guides = list[Acting](), list[tuple[str, float]](), _guides_of(st, link)
    for force in forces:
        at = complex(nominal(force.at))
        to = min(points, key=lambda point: abs(at - point))
        if abs(nominal(force.vector)) <= NO_LENGTH or abs(at - to) <= (AWAY if force.named.symbol in guides else REACH):
            near.append(force)
            continue
        symbol = force.named.symbol
        near.append(replace(force, at=to))
        couples.append((f"M({symbol})", float(cross(at - to, complex(nominal(force.vector))))))
        st.board.remark(
            Words(
                f"${symbol}$ 的作用线距构件 {abs(at - to):.0f} mm，移至构件上画出，并附加力偶 $M$(${symbol}$)。",
                f" The line of ${symbol}$ is {abs(at - to):.0f} mm off: it is drawn at the link, with the couple "
                f"$M$(${symbol}$) of its transfer.",
            )
        )
    return near, couples


def _guides_of(st: Statics, link: str) -> set[str]:
    """The reactions of the guides of a block that nothing else touches: bars, racks and followers go on to where
    theirs act."""
    touched = {end for joint in st.mech.joints if isinstance(joint, Rolling) for end in ends(joint)}
    touched |= {end for contact in st.mech.contacts for end in contact.links}
    slides = [joint for joint in st.mech.joints if isinstance(joint, Prismatic) and joint.block == link]
    return set() if link in touched else {st.named(slide.guide, link).symbol for slide in slides}
