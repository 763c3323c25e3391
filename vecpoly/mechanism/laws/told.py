"""Laws in words."""

from __future__ import annotations

from math import degrees

from ...words import Words
from ..loads import Load
from ..model import Mechanism
from .sizes import Table


def beyond(load: Load, table: Table, place: float, mech: Mechanism) -> Words:
    """That a load's table says nothing of a place."""
    angle = table.over is None and not mech.drive.slide
    here, low, high = (
        f"{degrees(x):.6g}°" if angle else f"{1e3 * x:.6g} mm" for x in (place, table.places[0], table.places[-1])
    )
    over = Words("原动件", "the drive") if table.over is None else Words.same(f"${table.over.point}$")
    return Words(
        f"载荷 {load.name} 的表 {table.name} 只有 {low} 至 {high}，而{over.zh}到 {here}；请补全表，"
        "或用 during、between 限定载荷作用的范围",
        f"the table {table.name} of load {load.name} goes from {low} to {high}, and {over.en} comes to {here}; "
        "complete the table, or say with 'during' or 'between' where the load acts",
    )
