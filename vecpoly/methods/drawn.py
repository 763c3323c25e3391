"""What drawing a problem yields, before anything is compared with it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from ..board.construction import Construction, Reading
from ..names import Rel
from ..plane import nominal
from .answers import Repeats
from .desk import VECTOR, Desk


class Drawn(NamedTuple):
    """The construction; every asked answer by all hands;
    what an ideal hand, which neither rounds nor scatters, reads instead."""

    construction: Construction
    repeats: Repeats
    ideal: Mapping[str, Reading]
    motion: Mapping[
        Rel, complex | float
    ] = {}  # every velocity, acceleration, ω and α that an ideal hand found, asked for or not
    hands: Mapping[
        int, Any
    ] = {}  # number of an act → what it gave by every hand: lengths read, values computed, points


def motion_of(desk: Desk) -> dict[Rel, complex | float]:
    """What stands on the polygons of a finished drawing:
    the vectors of all lettered points, ω and α of all links (SI)."""
    found: dict[Rel, complex | float] = {rel: float(nominal(turn.value)) for rel, turn in desk.turns.items()}
    for view in VECTOR:
        for at in desk.tips(view):
            found[Rel(VECTOR[view], at)] = complex(nominal(desk.tip(view, at))) * desk.board.scales[view].value
    return found
