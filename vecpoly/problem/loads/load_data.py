"""The loads for 已知."""

from __future__ import annotations

import re
from decimal import Decimal
from typing import assert_never

from ...foundation.slotted import replace
from ...mechanism.laws.sizes import Motor, Table
from ...mechanism.loads import Force, Load, Loads
from ...mechanism.model import Mechanism
from ...units.patterns import SENSE
from ...words import Words
from ..problem import Datum
from ..schema.models import LoadSpec, ProblemSpec
from .laws.law_data import told_constant, told_motor, told_spring, told_table, told_windows, written

_SENSE = re.compile(rf"\s*{SENSE}\s*$")


def data_of_loads(spec: ProblemSpec, loads: Loads, mech: Mechanism) -> tuple[Datum, ...]:
    """The loads for 已知, and whether weights and inertia forces count."""
    acting = (load for load in loads.all if load.name in spec.loads)
    data = [_lawful(load, spec.loads[load.name], not spec.find or load.name in spec.find) for load in acting]
    data += [told_spring(spring, spec.loads[spring.name], mech) for spring in loads.springs]
    if loads.constant is not None:
        data.append(told_constant(loads.constant))
    if loads.weight:
        data.append(Datum(words=Words("计各构件重力，$g$ = 9.81 m/s²", "the links' weights count, $g$ = 9.81 m/s²")))
    if loads.masses and not loads.inertia:
        data.append(Datum(words=Words("不计惯性力", "inertia forces are neglected")))
    return tuple(data)


def _lawful(load: Load, spec: LoadSpec, asked: bool) -> Datum:
    """A load, with when it acts; asked: whether an unknown one is sought, or only balances the others."""
    size = load.law.size if load.law is not None else None
    when = told_windows(load, spec)
    match size:
        case Table():
            told = told_table(load, spec)
            assert told.words is not None
            return replace(told, words=told.words + _on(load, _direction(spec)) + when)
        case Motor():
            return told_motor(load, spec)
        case None:
            plain = _told(load, _sensed(load, written(str(spec.size))), _direction(spec), asked)
            return replace(plain, words=plain.words + when) if plain.words is not None else plain
        case other:
            assert_never(other)


def _sensed(load: Load, size: str) -> str:
    """A moment with its sense, whichever way that was written: −30 N·m and 30 N·m 顺时针 are 30 N·m cw."""
    if isinstance(load, Force) or not load.size:
        return size
    return f"{_SENSE.sub('', size).lstrip('-−+ ')} {'ccw' if load.size > 0 else 'cw'}"


def _direction(spec: LoadSpec) -> str:
    """As it is written; one told clockwise is told counter-clockwise, as all directions of vectors are."""
    text = spec.direction or ""
    clockwise = re.fullmatch(r"\s*[-−]\s*(\d+(?:\.\d+)?)(\s*(?:deg|°))\s*", text)
    return f"{360 - Decimal(clockwise[1])}{clockwise[2]}" if clockwise else text


def _on(load: Load, direction: str) -> Words:
    """Where it acts, after its size."""
    if isinstance(load, Force):
        return Words(
            f"，作用于构件 {load.link} 的 ${load.point}$ 点，{_way(load, direction).zh}",
            f", on link {load.link} at ${load.point}$, {_way(load, direction).en}",
        )
    return Words(f"，作用于构件 {load.link}", f", on link {load.link}")


def _way(load: Force, direction: str) -> Words:
    """Its direction: an angle, or from one point of its link to another."""
    if load.along is None:
        return _towards(direction)
    start, end = load.along
    return Words(
        f"方向由 ${start}$ 指向 ${end}$，随构件 {load.link} 转动",
        f"directed from ${start}$ to ${end}$, turning with link {load.link}",
    )


_SQUARE = (
    Words("水平向右", "directed horizontally to the right"), Words("竖直向上", "directed vertically upwards"),
    Words("水平向左", "directed horizontally to the left"), Words("竖直向下", "directed vertically downwards"),
)  # fmt: skip
_SLANTED = (Words("右上", "upwards to the right"), Words("左上", "upwards to the left"),
            Words("左下", "downwards to the left"), Words("右下", "downwards to the right"))  # fmt: skip
_DEGREES = re.compile(r"\s*(\d+(?:\.\d+)?)\s*(?:deg|°)\s*")


def _towards(direction: str) -> Words:
    """30 deg: upwards to the right, at 30° to the horizontal; as it is written where that is no plain angle."""
    found = _DEGREES.fullmatch(direction)
    if found is None or Decimal(found[1]) >= 360:
        return Words(f"方向角 {direction}", f"direction {direction}")
    quarter, rest = divmod(Decimal(found[1]), 90)
    if not rest:
        return _SQUARE[int(quarter)]
    way, off = _SLANTED[int(quarter)], f"{90 - rest if quarter in (1, 3) else rest} deg"
    return Words(f"指向{way.zh}方，与水平线成 {off}", f"directed {way.en} at {off} to the horizontal")


_ROLE = {"": Words("", ""), "driving": Words("驱动", "driving "), "resisting": Words("阻", "resisting ")}


def _told(load: Load, size: str, direction: str, asked: bool) -> Datum:
    role = _ROLE[load.role]
    if isinstance(load, Force) and load.against:
        zh = f"为油缸 {load.against}-{load.link} 的推力，使其伸长者为正"
        en = f"as the thrust of the cylinder {load.against}-{load.link}, positive where it lengthens it"
        name = Words(f"{role.zh}力" if role.zh else "力", f"{role.en}force")
    elif isinstance(load, Force):
        zh = f"作用于构件 {load.link} 的 ${load.point}$ 点，{_way(load, direction).zh}"
        en = f"on link {load.link} at ${load.point}$, {_way(load, direction).en}"
        name = Words(f"{role.zh}力" if role.zh else "力", f"{role.en}force")
    else:
        zh, en = f"作用于构件 {load.link}", f"on link {load.link}"
        name = Words(f"{role.zh}力矩" if role.zh else "力矩", f"{role.en}moment")
    if load.size is None:
        known = Words("待求的", "the unknown ") if asked else Words("大小未知的", "the unknown ")
        where = f"${load.name}$ {zh}", f"${load.name}$ acts {en}"
        return Datum(words=known + name + Words(*(f" {one}" for one in where)))
    told = Words(f"{name.zh} ${load.name}$ = {{}}，{zh}", f"{name.en} ${load.name}$ = {{}} {en}")
    return Datum(symbol=load.name, si=load.size, text=size, words=told)
