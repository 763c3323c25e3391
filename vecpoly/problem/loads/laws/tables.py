"""A size by a table, as written: ``size: {table: card.csv, bore: 80 mm}``, its header ``s (mm), p (MPa)``."""

from __future__ import annotations

from itertools import pairwise
from math import degrees, pi

from ....errors import FaultError
from ....foundation.patterns import pattern
from ....mechanism.laws.sizes import Table, Travel
from ....units.names import plain, unit_of
from ....units.reading import Dim, positive, pure
from ....words import Words
from ...schema.models import TableSpec
from ..driven import Driven

TABLE_HEAD = pattern(r"\s*(.*?)\s*[(（\[/]\s*(.+?)\s*[)）\]]?\s*")
_SLACK = 1e-6  # of a turn


def read_table(table: TableSpec, over: Travel | None, force: bool, driven: Driven) -> Table:
    """The table in SI; raises FaultError. over: the point whose travel its places may be; force: or a moment."""
    if table.columns is None or table.rows is None:
        raise FaultError(
            Words(
                "缺少数据表；请写 {table: card.csv}，或写出 columns 与 rows",
                "the table is missing; write {table: card.csv}, or its columns and rows",
            ),
            code="missing",
        )
    places_of, sizes_of = (_head(cell) for cell in table.columns)
    travels = places_of[1] == Dim.LENGTH.dimension and not driven.drive.slide
    _refuse_place(places_of, travels, over, driven)
    factor = sizes_of[0] * _area(table, sizes_of[1], force)
    rows = [(pure(a, "30") * places_of[0], pure(b, "100") * factor) for a, b in table.rows]
    name = table.table or ""
    if travels:
        return _travelled(rows, over, name)
    lead = driven.lead
    places = tuple(place + lead for place, _ in _rising(rows, name))
    return Table(places=places, sizes=tuple(size for _, size in rows), period=_period(places, driven), name=name)


def turns_of(table: TableSpec) -> int:
    """Two, where a table over the drive's angle goes twice round; else one, also of a table that cannot be read."""
    try:
        factor, dimension = _head(table.columns[0]) if table.columns else (1.0, "")
        places = [pure(a, "30") * factor for a, _ in table.rows or ()]
    except FaultError:
        return 1
    turns = dimension == Dim.ANGLE.dimension and bool(places) and (places[-1] - places[0]) / (2 * pi)
    return 2 if abs(turns - 2) <= _SLACK else 1


def _head(cell: str) -> tuple[float, str]:
    """SI factor and dimension of the unit in a column's head."""
    m = TABLE_HEAD.fullmatch(cell)
    if m is None:
        raise FaultError(
            Words(
                f"表头“{cell}”没有单位；请写如 phi (deg)、s (mm)、F (N)、p (MPa)",
                f"the head '{cell}' names no unit; write e.g. phi (deg), s (mm), F (N), p (MPa)",
            ),
            "columns",
            code="no-unit",
        )
    return unit_of(plain(m[2]))


def _refuse_place(head: tuple[float, str], travels: bool, over: Travel | None, driven: Driven) -> None:
    wanted = Dim.LENGTH if driven.drive.slide or travels else Dim.ANGLE
    if head[1] != wanted.dimension or (travels and over is None):
        raise FaultError(
            Words(
                "表的第一列应为原动件的位置（phi (deg)），或力的作用点沿力的方向自行程起点量起的位移（s (mm)）",
                "the first column of a table is the place of the drive, phi (deg), or, of a force, the travel of its "
                "point along it from the beginning of its stroke, s (mm)",
            ),
            "columns",
            code="wrong-unit",
        )


def _area(table: TableSpec, dimension: str, force: bool) -> float:
    """1 for a column of forces or moments; for one of pressures the area (m²) on which they act."""
    if dimension == (Dim.FORCE if force else Dim.MOMENT).dimension:
        if table.area is not None or table.bore is not None:
            raise FaultError(
                Words(
                    "表中已是力（或力矩），不再乘以活塞面积；请删去 area 或 bore",
                    "the table gives forces or moments already, and no area counts; leave out area or bore",
                ),
                code="contradiction",
            )
        return 1.0
    if dimension != Dim.PRESSURE.dimension or not force:
        raise FaultError(
            Words(
                f"表的第二列应为{'力 F (N) 或压强 p (MPa)' if force else '力矩 M (N*m)'}",
                f"the second column of the table must be {'F (N) or p (MPa)' if force else 'M (N*m)'}",
            ),
            "columns",
            code="wrong-unit",
        )
    if (table.area is None) == (table.bore is None):
        raise FaultError(
            Words(
                "表中是压强；请给出活塞的面积 area: 5000 mm^2 或直径 bore: 80 mm（其一）",
                "the table gives pressures; give the piston's area: 5000 mm^2 or its bore: 80 mm, one of them",
            ),
            code="missing",
        )
    if table.area is not None:
        return positive(table.area, Dim.AREA).si
    return pi * positive(table.bore).si ** 2 / 4


def _rising(rows: list[tuple[float, float]], name: str) -> list[tuple[float, float]]:
    for number, ((a, _), (b, _)) in enumerate(pairwise(rows), 2):
        if not a < b:
            raise FaultError(
                Words(
                    f"{name} 第 {number} 行数据的位置 {b:g} 不大于前一行的 {a:g}（SI）；请按由小到大的次序排列",
                    f"{name}: the place in row {number}, {b:g}, is not greater than the one before, {a:g} (SI); put "
                    "them in increasing order",
                ),
                "rows",
                code="contradiction",
            )
    return rows


def _travelled(rows: list[tuple[float, float]], over: Travel | None, name: str) -> Table:
    """A table over a travel: there, or there and back."""
    top = max(range(len(rows)), key=lambda i: rows[i][0])
    there, back = _rising(rows[: top + 1], name), _rising(rows[top:][::-1], name)
    if rows[0][0] < -_SLACK:
        raise FaultError(
            Words(
                f"位移从行程起点量起，不得为负；{name} 的第一行为 {1e3 * rows[0][0]:g} mm",
                f"a travel counts from the beginning of the stroke and is not negative; the first of {name} is "
                f"{1e3 * rows[0][0]:g} mm",
            ),
            "rows",
            code="out-of-range",
        )
    places, sizes = zip(*there, strict=True)
    return Table(
        places=places,
        sizes=sizes,
        back=((), ()) if len(back) < 2 else (tuple(a for a, _ in back), tuple(b for _, b in back)),
        over=over,
        name=name,
    )


def _period(places: tuple[float, ...], driven: Driven) -> float:
    """2π, or 4π of a table that goes twice round (rad); raises FaultError for more than that."""
    if driven.drive.slide:
        return 0.0
    span = (places[-1] - places[0]) / (2 * pi)
    turns = 2 if abs(span - 2) <= _SLACK else 1
    if span > turns + _SLACK:
        raise FaultError(
            Words(
                f"表覆盖 {degrees(2 * pi * span):.6g}°，超过一转（360°）而不是两转（720°），没有这样的周期",
                f"the table covers {degrees(2 * pi * span):.6g} deg, more than one turn (360 deg) and not two (720 "
                "deg); there is no such period",
            ),
            "rows",
            code="no-period",
        )
    return 2 * pi * turns
