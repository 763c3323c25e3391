"""Another link as the input: with which of them the mechanism falls into groups of a wanted kind alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ...errors import VecpolyError
from ...foundation.slotted import replace
from ..model import FRAME, Drive, Mechanism, Prismatic
from .assur import Group, decompose, ends, hinges


def other_inputs(mech: Mechanism, wanted: Callable[[Group], bool]) -> tuple[str, ...]:
    """Links on the frame, other than the input, with which as the input every group is as wanted."""
    return tuple(
        drive.link
        for drive in _on_frame(mech)
        if drive.link != mech.drive.link and _all(replace(mech, drives=(drive,)), wanted)
    )


def _on_frame(mech: Mechanism) -> Iterator[Drive]:
    """The links hinged to the frame, or sliding on it, that exist."""
    for names in hinges(mech).values():
        yield from (
            Drive(link=name, position=0.0, rate=1.0) for name in names if FRAME in names and name in mech.numbered
        )
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and FRAME in ends(joint):
            name = next(end for end in ends(joint) if end != FRAME)
            yield from [Drive(link=name, position=0.0, rate=1.0, slide=True)] * (name in mech.numbered)


def _all(mech: Mechanism, wanted: Callable[[Group], bool]) -> bool:
    try:
        return all(wanted(group) for group in decompose(mech))
    except VecpolyError:
        return False
