"""Why nothing can be drawn at a position: what the drawing refused there, in a word."""

from __future__ import annotations

from ....errors import (
    AssemblyError,
    BranchError,
    DeadPointError,
    EquationError,
    EquilibriumError,
    LockedError,
    NoSlipSenseError,
    VecpolyError,
)
from ....words import Words

_CAUSES: tuple[tuple[type[VecpolyError], Words], ...] = (  # the first that the refusal is
    (LockedError, Words("自锁", "self-locking")),
    (NoSlipSenseError, Words("接触处无相对运动，摩擦力指向不定", "no slip in a joint: friction has no sense")),
    (EquilibriumError, Words("方向线平行，力多边形不能封闭", "parallel lines of action: no force polygon closes")),
    (DeadPointError, Words("死点", "a dead point")),
    (BranchError, Words("装配方式不定", "an assembly that is not told")),
    (AssemblyError, Words("机构不能装配", "links that do not meet")),
    (EquationError, Words("方向线平行", "parallel directions")),
)
_OTHERWISE = Words("图形超出图纸", "a figure larger than the sheet")


def cause(error: VecpolyError) -> Words:
    """Self-locking, a dead point, links that do not meet; of what is none of these a figure too large."""
    return next((words for kind, words in _CAUSES if isinstance(error, kind)), _OTHERWISE)
