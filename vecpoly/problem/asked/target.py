"""A given curve beside which the path of a point is drawn: target: {point: E, through: [[60 mm, 0 mm], ...]}."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...errors import FaultError
from ...foundation.slotted import dataclass
from ...mechanism.model import Mechanism
from ...units.reading import Dim, read
from ...words import Words

if TYPE_CHECKING:
    from ..schema.faults import Faults
    from ..schema.models import ProblemSpec


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """Points (m) of the curve that a point of a link should run along, and whether it closes."""

    point: str
    through: tuple[complex, ...]
    closed: bool = False


def read_target(spec: ProblemSpec, mech: Mechanism, faults: Faults) -> Target | None:
    """The curve as it is written; a fault where the point does not exist, or where the drive slides."""
    if spec.target is None or faults.found:
        return None
    with faults.at("target"):
        unled = {*mech.frame, *(profile.centre for profile in mech.cams)}
        letters = [letter for link in mech.links for letter in link.points if letter not in unled]
        if spec.target.point not in letters:
            raise _unknown(spec.target.point, letters)
        if mech.drive.slide or mech.drive.between:
            raise FaultError(
                Words("target 只用于转动的原动件", "'target' goes with a driving link that turns"), code="contradiction"
            )
        through = tuple(complex(read(x, Dim.LENGTH).si, read(y, Dim.LENGTH).si) for x, y in spec.target.through)
        return Target(point=spec.target.point, through=through, closed=spec.target.closed)
    return None


def _unknown(point: str, letters: list[str]) -> FaultError:
    from ..schema.faults import meant  # late: the schema knows problems

    return FaultError(
        Words(f"运动构件上没有点“{point}”", f"no moving link carries a point '{point}'") + meant(point, letters),
        "point",
        code="unknown-name",
    )
