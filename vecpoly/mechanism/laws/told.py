"""Laws in words."""

from __future__ import annotations

from math import degrees

from ...words import Words
from ..loads import Load
from ..model import Mechanism
from .sizes import Table
from .springs import Spring


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


STILL, ENDLESS = 1e-9, 1e3  # of the mechanism's size: a stroke of less is none, one of more has no end


def no_stroke(link: str, point: str, direction: float, stroke: float, scale: float) -> Words | None:
    """Why a point has no stroke along a direction: it does not move, or runs away; None where it has one (m)."""
    way = f"{degrees(direction):g}°"
    if stroke <= STILL * scale:
        return Words(
            f"构件 {link} 的点 {point} 沿 {way} 方向不动，行程为 0；请另取点或方向",
            f"point {point} of link {link} does not move along {way}: its stroke is 0; name another point, or another "
            "direction",
        )
    if stroke <= ENDLESS * scale:
        return None
    return Words(
        f"构件 {link} 的点 {point} 沿 {way} 方向可移到无穷远，没有行程可言；请用 during 限定载荷作用的范围",
        f"point {point} of link {link} runs away to infinity along {way} and has no stroke; say with 'during' where "
        "the load acts",
    )


def no_direction(spring: Spring) -> Words:
    """That the ends of a spring are at one place, so that nothing says along which line it acts."""
    zh, en = ("弹簧", "spring") if spring.stiffness else ("阻尼器", "damper")
    return Words(
        f"{zh} {spring.name} 的两端 {spring.foot}、{spring.point} 在此位置重合，长度为 0，其力没有方向；"
        "请改原动件的位置，或另取连接点",
        f"the ends {spring.foot} and {spring.point} of {en} {spring.name} are at one place here, so that its force has "
        "no direction; give another position of the drive, or another point",
    )
