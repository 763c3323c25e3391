"""Shafts and the pairs that join them, as they are written: {J: 0.1 kg*m^2, drives: 80 N*m}, 1 to 2 by 20/30."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, WithJsonSchema, model_validator

from ...errors import FaultError
from ...units.reading import Dim, Quantity, positive, pure
from ...words import Words
from ..base import Length, Mass, Torque

G = 9.81  # m/s²
NAME = r"[0-9A-Za-z]{1,4}[′']?"
_PAIR = re.compile(rf"\s*({NAME})\s+to\s+({NAME})\s+by\s+(.+?)\s*/\s*(.+?)\s*")


def _inertias(value: Any) -> tuple[Quantity, ...]:
    """One, or several on one shaft."""
    several = value if isinstance(value, list | tuple) else [value]
    return tuple(one if isinstance(one, Quantity) else positive(one, Dim.INERTIA) for one in several)


class Shaft(BaseModel):
    """J: of all that sits on it, several in brackets; what drives it, what resists; drum: the diameter (of the rope)
    on which it lifts a mass."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)
    J: Annotated[tuple[Quantity, ...], BeforeValidator(_inertias), WithJsonSchema({"type": ["string", "array"]})] = ()
    drives: Torque | None = None
    resists: Torque | None = None
    drum: Length | None = None
    lifts: Mass | None = None

    @model_validator(mode="after")
    def _lifts_by_a_drum(self) -> Shaft:
        if (self.drum is None) != (self.lifts is None):
            raise FaultError(
                Words(
                    "drum 与 lifts 应一并给出，如 drum: 400 mm, lifts: 500 kg",
                    "a drum goes with what it lifts: drum: 400 mm, lifts: 500 kg",
                ),
                code="missing",
                keys=("drum", "lifts"),
            )
        return self

    @property
    def moment(self) -> float:
        """What drives it, less what resists and what the load pulls on its drum (N·m)."""
        weight = self.lifts.si * G * self.drum.si / 2 if self.lifts and self.drum else 0.0
        return (self.drives.si if self.drives else 0.0) - (self.resists.si if self.resists else 0.0) - weight

    @property
    def inertia(self) -> float:
        """Of all that sits on it, and of what it lifts (kg·m²)."""
        lifted = self.lifts.si * (self.drum.si / 2) ** 2 if self.lifts and self.drum else 0.0
        return sum(one.si for one in self.J) + lifted


@dataclass(frozen=True, slots=True, kw_only=True)
class Pair:
    """Two shafts and the sizes, teeth or diameters, of their wheels; belt: whether diameters were given."""

    first: str
    second: str
    sizes: tuple[float, float]
    belt: bool
    text: str

    @property
    def letter(self) -> str:
        """d of pulleys, z of gears."""
        return "d" if self.belt else "z"

    @property
    def sizes_written(self) -> tuple[str, ...]:
        """Teeth or diameters as they were written: 20, 30."""
        return tuple(size.strip() for size in self.text.partition(" by ")[2].split("/"))

    @property
    def ratio(self) -> float:
        """ω of the second over ω of the first."""
        return self.sizes[0] / self.sizes[1]


def read_pair(value: Any) -> Pair:
    """`1 to 2 by 20/30`: 20 teeth on shaft 1, 30 on shaft 2; `0 to 1 by 80 mm/240 mm`: a belt."""
    if isinstance(value, Pair):
        return value
    m = _PAIR.fullmatch(str(value))
    if m is None:
        raise FaultError(
            Words(
                f"“{value}”不是一对轮；请写 1 to 2 by 20/30（齿数），或 0 to 1 by 80 mm/240 mm（带轮直径）",
                f"'{value}' is no pair of wheels; write 1 to 2 by 20/30 (teeth) or 0 to 1 by 80 mm/240 mm (pulleys)",
            ),
            code="spelling",
        )
    belt = "m" in m[3] + m[4]
    sizes = tuple(positive(part).si if belt else pure(part, "20") for part in (m[3], m[4]))
    if not belt and any(size < 1 or size % 1 for size in sizes):
        raise FaultError(
            Words(
                f"“{value}”：齿数应为正整数；带轮直径请带单位，如 1 to 2 by 80 mm/240 mm",
                f"'{value}': numbers of teeth are whole and positive; diameters of pulleys have their unit, as in 1 to "
                "2 by 80 mm/240 mm",
            ),
            code="out-of-range",
        )
    return Pair(first=m[1], second=m[2], sizes=(sizes[0], sizes[1]), belt=belt, text=str(value))


Meshing = Annotated[Pair, BeforeValidator(read_pair), WithJsonSchema({"type": "string"})]


def ways(pairs: Sequence[Pair], start: str, shafts: Mapping[str, Shaft]) -> dict[str, tuple[tuple[Pair, bool], ...]]:
    """From one shaft to every other: the pairs on the way, and whether each is gone through from its first wheel.

    Raises FaultError for a shaft that is not joined, joined twice, or not there.
    """
    found: dict[str, tuple[tuple[Pair, bool], ...]] = {start: ()}
    left = list(pairs)
    while (pair := next((one for one in left if one.first in found or one.second in found), None)) is not None:
        left.remove(pair)
        forwards = pair.first in found
        here, there = (pair.first, pair.second) if forwards else (pair.second, pair.first)
        if there in found:
            raise FaultError(
                Words(
                    f"轴 {there} 由两条路径传动（{pair.text}），轮系封闭；请删去一对",
                    f"shaft {there} is reached twice ({pair.text}): the train is closed; leave one pair out",
                ),
                "pairs",
                code="contradiction",
            )
        found[there] = (*found[here], (pair, forwards))
    for name in (*shafts, *(name for pair in left for name in (pair.first, pair.second)), *found):
        if name not in found or name not in shafts:
            raise FaultError(
                Words(
                    f"轴 {name} 没有与轴 {start} 相联，或不在 shafts 中",
                    f"shaft {name} is not joined to shaft {start}, or does not stand among the shafts",
                ),
                "pairs",
                code="unknown-name",
            )
    return found
