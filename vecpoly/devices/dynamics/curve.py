"""A moment over the angle of a period, as it is written: one value, pairs, or a table; straight from place to place.

M_d: [[0 deg, 0 N*m], [30 deg, 420 N*m], [90 deg, 150 N*m], [360 deg, 0 N*m]]
M_r: 57 N*m
M_d: {columns: [phi (deg), M (N*m)], rows: [[0, 0], [30, 420], [360, 0]]}
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import degrees
from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from ...errors import FaultError
from ...units.names import plain, unit_of
from ...units.reading import Dim, pure, read
from ...words import Words
from ..base import Tabled

MOST = 1000  # places of a curve
SHOWN = 2  # places that are told in a line; more of them, more than five numbers, stand in a table
SAME = 1e-9  # rad
_HEAD = re.compile(r"\s*(.*?)\s*[(（\[/]\s*(.+?)\s*[)）\]]?\s*")


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """Places (rad, from 0 on, two alike where it jumps) and moments (N·m); one value alone holds everywhere."""

    places: tuple[float, ...]
    sizes: tuple[float, ...]
    text: str

    @property
    def constant(self) -> bool:
        """Whether it is one value for the whole period."""
        return len(self.sizes) == 1

    @property
    def end(self) -> float:
        """Where it ends (rad); 0 of one value."""
        return self.places[-1]

    def over(self, period: float) -> tuple[tuple[float, float], ...]:
        """The corners over a period."""
        if self.constant:
            return (0.0, self.sizes[0]), (period, self.sizes[0])
        return tuple(zip(self.places, self.sizes, strict=True))

    @property
    def tabled(self) -> Tabled | None:
        """Its places, where they are too many for a line."""
        return Tabled(over="φ", unit="°", rows=_cells(self.over(self.end))) if len(self.places) > SHOWN else None

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest of its values."""
        return min(self.sizes), max(self.sizes)


def read_curve(value: Any) -> Curve:
    """A curve as it is written; raises FaultError with the row that is wrong."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, str):
        moment = read(value, Dim.MOMENT)
        return Curve(places=(0.0,), sizes=(moment.si,), text=moment.text)
    rows = list(_of_table(value) if isinstance(value, dict) else _of_pairs(value))
    _check(rows)
    places, sizes = zip(*rows, strict=True)
    return Curve(places=places, sizes=sizes, text=_told(rows))


def _of_pairs(value: Any) -> Iterator[tuple[float, float]]:
    if not isinstance(value, list | tuple):
        raise _unreadable()
    for number, pair in enumerate(value, 1):
        if not isinstance(pair, list | tuple) or len(pair) != 2:
            raise FaultError(
                Words(
                    f"第 {number} 项应为一个转角和一个力矩，如 [30 deg, 420 N*m]",
                    f"entry {number} must be an angle and a moment, e.g. [30 deg, 420 N*m]",
                ),
                number - 1,
                code="spelling",
            )
        yield read(str(pair[0]), Dim.ANGLE).si, read(str(pair[1]), Dim.MOMENT).si


def _of_table(value: dict[str, Any]) -> Iterator[tuple[float, float]]:
    if set(value) - {"table", "columns", "rows"} or not {"columns", "rows"} <= set(value):
        raise _unreadable()
    factors = [_factor(head, dim) for head, dim in zip(value["columns"], (Dim.ANGLE, Dim.MOMENT), strict=True)]
    for row in value["rows"]:
        yield pure(row[0], "30") * factors[0], pure(row[1], "420") * factors[1]


def _factor(head: str, dim: Dim) -> float:
    """The SI factor of the unit in a column's head."""
    m = _HEAD.fullmatch(str(head))
    factor, dimension = unit_of(plain(m[2])) if m else (1.0, "")
    if m is None or dimension != dim.dimension:
        raise FaultError(
            Words(
                f"表头“{head}”应为{dim.label.zh}并带单位；两列请写 phi (deg) 和 M (N*m)",
                f"the head '{head}' must name {dim.label.en} with its unit; write phi (deg) and M (N*m)",
            ),
            "columns",
            code="no-unit",
        )
    return factor


def _check(rows: Sequence[tuple[float, float]]) -> None:
    """FaultError for a curve of one place, of too many, one that does not begin at 0, or runs back."""
    if not 2 <= len(rows) <= MOST:
        raise FaultError(
            Words(
                f"曲线应有 2 至 {MOST} 个点，这里有 {len(rows)} 个；常数力矩请直接写如 57 N*m",
                f"a curve has 2 to {MOST} places, not {len(rows)}; write a constant moment as 57 N*m",
            ),
            code="out-of-range",
        )
    if abs(rows[0][0]) > SAME:
        raise FaultError(
            Words(
                f"曲线从 {degrees(rows[0][0]):g}° 开始；应从 0 deg 开始，周期终了处结束",
                f"the curve begins at {degrees(rows[0][0]):g} deg; it must begin at 0 deg and end with the period",
            ),
            0,
            code="out-of-range",
        )
    for number, ((a, _), (b, _)) in enumerate(pairwise(rows), 2):
        if b < a - SAME:
            raise FaultError(
                Words(
                    f"第 {number} 点的转角 {degrees(b):g}° 小于前一点的 {degrees(a):g}°；请按由小到大排列"
                    "（突变处同一转角写两次）",
                    f"place {number}, {degrees(b):g} deg, is before the one above, {degrees(a):g} deg; put them in "
                    "rising order (a jump: one angle twice)",
                ),
                number - 1,
                code="contradiction",
            )
    _refuse_three(rows)
    if rows[-1][0] <= SAME:
        raise FaultError(Words("曲线没有长度", "the curve has no length"), code="out-of-range")


def _refuse_three(rows: Sequence[tuple[float, float]]) -> None:
    """FaultError for a third moment at one angle: those between would be lost."""
    for number, ((a, _), (b, _)) in enumerate(zip(rows, rows[2:], strict=False), 3):
        if b < a + SAME:
            raise FaultError(
                Words(
                    f"转角 {degrees(a):g}° 处写了三个或更多力矩；突变处只写前、后两个",
                    f"three or more moments stand at {degrees(a):g} deg; a jump has two, before and behind it",
                ),
                number - 1,
                code="contradiction",
            )


def _unreadable() -> FaultError:
    return FaultError(
        Words(
            "力矩应写成一个值（57 N*m）、若干点（[[0 deg, 0 N*m], [30 deg, 420 N*m], …]）或 {table: M.csv}",
            "a moment is one value (57 N*m), places ([[0 deg, 0 N*m], [30 deg, 420 N*m], ...]) or {table: M.csv}",
        ),
        code="spelling",
    )


def _told(rows: Sequence[tuple[float, float]]) -> str:
    return ", ".join(f"{phi}°: {moment}" for phi, moment in _cells(rows)) + " N·m"


def _cells(rows: Sequence[tuple[float, float]]) -> tuple[tuple[str, str], ...]:
    """Angles in deg and moments, as they are told."""
    return tuple((f"{degrees(phi):.6g}", f"{moment:.6g}") for phi, moment in rows)


Moments = Annotated[Curve, BeforeValidator(read_curve), WithJsonSchema({"type": ["string", "array", "object"]})]
