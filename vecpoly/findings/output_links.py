"""Which links a mechanism ends in: those on the frame, rocking, turning or sliding,
from which no further group hangs."""

from __future__ import annotations

from ..mechanism.groups.assur import decompose, hinges
from ..mechanism.model import FRAME, Prismatic
from .study.study import Study


def ends(study: Study) -> tuple[str, ...]:
    """The output links in order; of a mechanism that ends in a floating link that one."""
    mech, groups = study.mech, decompose(study.mech)
    used = {outer.parent for group in groups for outer in group.outer}
    last = [group for group in groups if not used & set(group.links)] or list(groups[-1:])
    found = [link for group in last for link in group.links if link in on_frame(study)]
    thought = {*mech.substitutes, *mech.slot_pins}
    return tuple(found) or tuple(
        next(link for link in reversed(group.links) if link not in thought)
        for group in last
        if not set(group.links) <= thought
    )


def on_frame(study: Study) -> set[str]:
    """The links pinned to, or sliding on, the frame."""
    mech = study.mech
    pinned = {name for names in hinges(mech).values() if FRAME in names for name in names}
    sliding = {
        name
        for j in mech.joints
        if isinstance(j, Prismatic) and FRAME in (j.guide, j.block)
        for name in (j.guide, j.block)
    }
    return (pinned | sliding) - {FRAME, *mech.slot_pins}


def motions(study: Study, link: str) -> tuple[str, ...]:
    """Keys of the motions by which an output is judged:
    ω and α of a link that turns, speed and acceleration of one that slides."""
    turning = tuple(key for key in (f"omega_{link}", f"alpha_{link}") if study.varies(key))
    if turning:
        return turning
    frame, keys = study.mech.frame_number, {column.key for column in study.whole.columns}
    name = study.mech.number(link)
    pair = next((p for p in (f"{name}{frame}", f"{frame}{name}") if f"v_{p}" in keys), "")
    return tuple(key for key in (f"v_{pair}", f"a_{pair}") if pair and study.varies(key))
