"""What every mark knows."""

from __future__ import annotations

from ...foundation.slotted import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Ink:
    """What every mark knows: the step and the act that drew it;
    what it stands for, where it stands for a quantity; whose it is."""

    step: int = 0
    act: int = -1
    key: str = ""
    owner: str = ""
