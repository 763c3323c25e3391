"""A linkage that a synthesis found on paper: one of several that fit the data, of any use or not."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass
from ..words import Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """Its number, its pins (mm on paper, every position's), what was read of it, and why it is rejected.

    kind: what linkage it is, where that is told. last: whether its other link on the frame must drive it, since with
    the first one for the driver it does not come through its positions.
    verdict: the name of the reason, VALID where there is none; values: by the key of a quantity without a number,
    lengths in mm, angles in deg; spread: the expected drawing error of each, 3σ of the repeated hands; lost: the
    share of those that do not find it.
    """

    number: int
    pins: Mapping[str, complex]
    verdict: str
    reason: Words | None = None
    kind: Words | None = None
    last: bool = False
    values: Mapping[str, float] = field(default_factory=lambda: FrozenMap({}))
    spread: Mapping[str, float] = field(default_factory=lambda: FrozenMap({}))
    lost: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "pins", FrozenMap(dict(self.pins)))
        object.__setattr__(self, "values", FrozenMap(dict(self.values)))
        object.__setattr__(self, "spread", FrozenMap(dict(self.spread)))
