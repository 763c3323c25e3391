"""Loads that depend on place and speed, for 已知."""

from __future__ import annotations

from typing import assert_never

from ....mechanism.laws.sizes import Table
from ....mechanism.laws.springs import Coil, Elastic
from ....mechanism.laws.windows import During, Moving, Turning
from ....mechanism.loads import Constant, Load
from ....mechanism.model import FRAME, Mechanism
from ....words import Words
from ...problem import Datum
from ...schema.models import LoadSpec, TableSpec
from ...values.given import GivenTable, by_table
from .tables import TABLE_HEAD

_GREEK = {"phi": "φ", "theta": "θ", "alpha": "α"}
_WAYS = {
    0: Words("向右", "to the right"),
    90: Words("向上", "up"),
    180: Words("向左", "to the left"),
    -90: Words("向下", "down"),
}


def written(text: str) -> str:
    """A unit as a book prints it: N*m → N·m, kg/m^3 → kg/m³."""
    return text.replace("**", "^").replace("*", "·").replace("^2", "²").replace("^3", "³")


def told_windows(load: Load, spec: LoadSpec) -> Words:
    """Behind the load: when it acts; empty for always."""
    found = Words("", "")
    for window in load.law.windows if load.law is not None else ():
        match window:
            case Moving():
                found += _told_moving(window, spec)
            case Turning(link=link, sense=sense):
                way = Words("逆时针", "counter-clockwise") if sense > 0 else Words("顺时针", "clockwise")
                found += Words(f"，仅在构件 {link} {way.zh}转动时作用", f", only while link {link} turns {way.en}")
            case During():
                assert spec.during is not None
                a, b = spec.during
                found += Words(f"，仅在原动件由 {a} 到 {b} 时作用", f", only while the drive goes from {a} to {b}")
            case other:
                assert_never(other)
    return found


def _told_moving(window: Moving, spec: LoadSpec) -> Words:
    from math import degrees

    angle = round(degrees(window.direction), 9)
    way = _WAYS.get(int(angle)) if angle == int(angle) else None
    if way is None:
        way = Words(f"朝 {angle:g}° 方向", f"in the direction {angle:g}°")
    found = Words(f"，仅在 ${window.point}$ 点{way.zh}运动时作用", f", only while ${window.point}$ moves {way.en}")
    if spec.between is None:
        return found
    low, high = 100 * window.low, 100 * window.high
    return found + Words(f"（其行程的 {low:g} % 至 {high:g} %）", f" (from {low:g} % to {high:g} % of its stroke)")


def told_table(load: Load, spec: LoadSpec) -> Datum:
    """A load by its table."""
    assert isinstance(spec.size, TableSpec) and spec.size.columns is not None and spec.size.rows is not None
    heads = [_head(cell) for cell in spec.size.columns]
    (over, _), (sizes, _) = heads
    area = spec.size.area or spec.size.bore
    piston = Words("", "")
    if area is not None:
        which = Words("面积", "area") if spec.size.area else Words("直径", "bore")
        text = written(area)
        piston = Words(f"，活塞{which.zh} {text}", f", {which.en} of the piston {text}")
    return Datum(
        words=by_table(f"${load.name}$", sizes, over) + _counted(load, over) + piston,
        table=GivenTable(
            head=tuple(f"{symbol} /{unit}" for symbol, unit in heads),
            rows=tuple(tuple(str(cell).strip().replace("-", "−") for cell in row) for row in spec.size.rows),
        ),
    )


def _counted(load: Load, place: str) -> Words:
    """Of what a table over a length tells the sizes: of the travel of the load's point, or of the driving slider."""
    table = load.law.size if load.law is not None else None
    if not isinstance(table, Table) or table.period:
        return Words("", "")
    if table.over is None:
        return Words(f"（{place} 为原动件的位移）", f" ({place}: the travel of the driving link)")
    return Words(
        f"（{place} 为 ${table.over.point}$ 点沿力的方向自行程起点量起的位移）",
        f" ({place}: the travel of ${table.over.point}$ along the force from the beginning of its stroke)",
    )


def _head(cell: str) -> tuple[str, str]:
    """Symbol and unit of a column: phi (deg) gives $φ$ and °."""
    found = TABLE_HEAD.fullmatch(cell)
    assert found is not None  # the table was read
    symbol, unit = found[1], written(found[2])
    return f"${_GREEK.get(symbol, symbol)}$", "°" if unit == "deg" else unit


def told_motor(load: Load, spec: LoadSpec) -> Datum:
    """A motor by its characteristic."""
    assert spec.motor is not None
    a, b = (written(text) for text in spec.motor)
    return Datum(
        words=Words(
            f"原动件 {load.link} 由电动机驱动，${load.name}$ = {a} − ({b}) ω",
            f"a motor drives link {load.link}, ${load.name}$ = {a} − ({b}) ω",
        )
    )


def told_constant(one: Constant) -> Datum:
    """The moment that is the same over the period."""
    role = {"": Words("", ""), "driving": Words("驱动", "driving "), "resisting": Words("阻", "resisting ")}[one.role]
    return Datum(
        words=Words(
            f"作用于构件 {one.link} 的{role.zh}力矩 ${one.name}$ 大小未知，在一周期内为常数",
            f"the {role.en}moment ${one.name}$ on link {one.link}, of unknown size, is constant over the period",
        )
    )


def told_spring(spring: Elastic, spec: LoadSpec, mech: Mechanism) -> Datum:
    """A spring or a damper."""
    symbols = (("k", "k"), ("l_0", "l_0"), ("phi_0", "φ_0"), ("preload", "F_0"), ("c", "c"))
    values = [
        Words.same(f"${'M_0' if key == 'preload' and isinstance(spring, Coil) else symbol}$ = {written(told)}")
        + (angle_of(spring, mech) if key == "phi_0" and isinstance(spring, Coil) else Words("", ""))
        for key, symbol in symbols
        if (told := getattr(spec, key)) is not None
    ]
    kind = Words("弹簧", "a spring") if spring.stiffness else Words("阻尼器", "a damper")
    if isinstance(spring, Coil):
        other = Words(f"构件 {spring.against} ", f"link {spring.against}")
        other = Words("机架", "the frame") if spring.against == FRAME else other
        kind = Words("扭簧", "a torsion spring") if spring.stiffness else Words("转动阻尼器", "a rotary damper")
        where = Words(f"构件 {spring.link} 与{other.zh}之间", f"link {spring.link} and {other.en}")
    else:
        ends = " ".join(f"${letter}$" for letter in (spring.foot, spring.point))
        where = Words(f"{ends.replace(' ', '、')} 两点之间", ends.replace(" ", " and "))
    return Datum(
        words=Words(
            f"{where.zh}有{kind.zh} ${spring.name}$：{'，'.join(one.zh for one in values)}",
            f"{kind.en} ${spring.name}$ between {where.en}: {', '.join(one.en for one in values)}",
        )
    )


def angle_of(coil: Coil, mech: Mechanism) -> Words:
    """Of which line the free angle is, and from where it counts: a link is turned as the line of its first letters."""
    axes = [mech.link(name).axis for name in (coil.link, coil.against)]
    if len(axes[0]) < 2:
        return Words("", "")
    own, other = map("".join, axes)
    if coil.against == FRAME:
        return Words(f"（${own}$ 自 $x$ 轴起的转角）", f" (angle of ${own}$ from the $x$ axis)")
    return Words(f"（${own}$ 相对 ${other}$ 的转角）", f" (angle of ${own}$ from ${other}$)")
