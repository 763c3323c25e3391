"""Gears that mesh with nothing: their radii are given, so they are drawn."""

from __future__ import annotations

from ...mechanism.model import Circle, Joint, Rolling
from ..links.bodies import Bodies


def idle_gears(bodies: Bodies, joints: tuple[Joint, ...]) -> tuple[Circle, ...]:
    """The gears of links that mesh with nothing, neither by this radius nor by another."""
    meshing = {side.link for joint in joints if isinstance(joint, Rolling) for side in (joint.gear, joint.on)}
    gears = (draft.gear for draft in bodies.drafts.values())
    return tuple(gear for gear in gears if gear is not None and gear.link not in meshing)
