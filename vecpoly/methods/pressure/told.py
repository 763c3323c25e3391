"""How the links, the force and the velocity of a pressure angle are called."""

from __future__ import annotations

from ...mechanism.asked.pressure import Driven
from ...mechanism.model import FRAME, Prismatic
from ...names import subscripted
from ...words import Words
from ..desk import Desk


def bodily(desk: Desk, link: str) -> Words:
    """构件 2, link 2; the block that is thought about a pin in a slot is that pin."""
    if link in desk.mech.slot_pins:
        pin = desk.mech.slot_pins[link].point
        return Words(f"销 ${pin}$ ", f"pin ${pin}$")
    if link == FRAME:
        return Words("机架", "the frame")
    return Words(f"构件 {desk.mech.number(link)} ", f"link {desk.mech.number(link)}")


def block_of(driven: Driven) -> Words:
    """Which of both links of the sliding pair the driving one is."""
    assert isinstance(driven.press, Prismatic)
    guide = driven.press.guide == driven.by
    return Words("导杆" if guide else "滑块", "the guide" if guide else "the block")


def moved_point(driven: Driven) -> str:
    """The point of the driven link at which the force acts, in a sentence: C, or B_3 where it is B of another link."""
    return subscripted(f"{driven.at}{driven.link}") if driven.thought else driven.at


def force_key(driven: Driven) -> str:
    """The key of the line of the force."""
    return f"F_{driven.name}".rstrip("_")


def velocity_key(driven: Driven) -> str:
    """The key of the line of the velocity."""
    return f"v_{driven.at}{driven.link if driven.thought else ''}"
