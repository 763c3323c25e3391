"""A load as it was found in this position."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ....mechanism.laws.springs import Elastic
from ....mechanism.loads import Load
from ....plane import Points, Reals


@dataclass(frozen=True, slots=True, kw_only=True)
class Pull:
    """Its size by every hand (N along its direction, or N·m), and the direction of a force; is_signed: its symbol has
    been told with its sign, F = −39.3 N."""

    size: Reals
    along: Points = 1 + 0j
    is_signed: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Acted:
    """What a load that depends on the motion, or a spring, does in this position: it is told once."""

    of: Load | Elastic
    loads: tuple[Load, ...] = ()
    pulls: Mapping[str, Pull] = field(default_factory=dict)
