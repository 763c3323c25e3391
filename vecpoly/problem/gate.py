"""What the drawing of every variant must be like: ``gate: {vectors: 15 mm, meetings: 20 deg}``."""

from __future__ import annotations

from math import radians
from typing import TYPE_CHECKING

from ..errors import FaultError
from ..foundation.slotted import dataclass
from ..units.reading import Dim, pure, read
from ..words import Words
from .schema.faults import Faults

if TYPE_CHECKING:
    from .schema.models import GateSpec

MEETING = radians(20.0)
FLATTER = 0.75  # of the least angle of meeting in the problem as it stands, where that is under MEETING


@dataclass(frozen=True, slots=True, kw_only=True)
class Gate:
    """What every variant must be like.

    vectors: mm that a graded vector measures at least; meetings: rad between lines or arcs, where None: MEETING, or a
    little less than in the problem as it stands; dead_point: rad from a dead point; deviation: 2σ of a graded quantity
    over its size, at most. slips, apart: how many tolerances T the readings of somebody who makes a slip, and those of
    two students (in two readings), must differ at least; 0: not asked for. alike: whether senses and acts must be those
    of the problem as it stands.
    """

    vectors: float = 15.0
    meetings: float | None = None
    dead_point: float = radians(10.0)
    deviation: float = 0.15
    slips: float = 1.0
    apart: float = 3.0
    alike: bool = True

    def meeting(self, as_it_stands: float) -> float:
        """The least angle (rad) at which lines may meet; as_it_stands: the least one in the problem itself."""
        return min(MEETING, FLATTER * as_it_stands) if self.meetings is None else self.meetings


def read_gate(spec: GateSpec, faults: Faults) -> Gate:
    """The gate as written; where nothing is said it has its defaults."""
    given: dict[str, float] = {}
    for key, dim, per in (("vectors", Dim.LENGTH, 1e3), ("meetings", Dim.ANGLE, 1.0), ("dead_point", Dim.ANGLE, 1.0)):
        with faults.at("gate", key):
            if (text := getattr(spec, key)) is not None:
                given[key] = _not_negative(read(text, dim).si * per, text)
    for key in ("deviation", "slips", "apart"):
        with faults.at("gate", key):
            if (text := getattr(spec, key)) is not None:
                given[key] = _not_negative(_part(text), text)
    return Gate(**given, alike=spec.alike)


def _part(text: str) -> float:
    """A pure number, or so many per cent."""
    bare = text.strip().replace("％", "%")
    return pure(bare[:-1], "15 %") / 100.0 if bare.endswith("%") else pure(bare, "15 %")


def _not_negative(value: float, text: str) -> float:
    if value < 0:
        raise FaultError(
            Words(f"“{text}”不能为负；0 表示不作要求", f"'{text}' cannot be negative; 0 asks for nothing"),
            code="out-of-range",
        )
    return value
