"""How the offset of a guide is called: e; of several guides each by the block that slides there."""

from __future__ import annotations

from .model import Mechanism, Prismatic


def offset_symbol(mech: Mechanism, joint: Prismatic) -> str:
    """e, where one guide alone has an offset; else e_4 of block 4, e_45 where it has two on its guides."""
    named = [one for one in mech.joints if isinstance(one, Prismatic) and one.aside]
    if len(named) == 1:
        return "e"
    number = mech.number(joint.block)
    alone = sum(one.block == joint.block for one in named) == 1
    return f"e_{{{number if alone else number + mech.number(joint.guide)}}}"
