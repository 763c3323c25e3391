"""The law of a load as written: its windows, its table, a motor's characteristic, a constant moment over the period."""

from __future__ import annotations

from math import copysign
from typing import TypeVar

from ....errors import FaultError
from ....foundation.slotted import replace
from ....mechanism.laws.sizes import Law, Motor, Table, Travel
from ....mechanism.loads import Constant, Force, Moment
from ....units.reading import Dim, read
from ....words import Words
from ...links.bodies import Bodies
from ...links.draft import Draft
from ...schema.models import LoadSpec, TableSpec
from ..driven import Driven
from .tables import read_table
from .windows import read_windows

CONSTANT = ("constant", "常数", "常量")
_Load = TypeVar("_Load", Force, Moment)


def lawful(load: _Load, spec: LoadSpec, bodies: Bodies, driven: Driven) -> _Load:
    """The load with its law, where one is written; raises FaultError."""
    _refuse_loose(spec)
    windows, table = read_windows(spec, bodies, driven), _table(load, spec, driven)
    if load.size is None and (windows or table):
        raise FaultError(
            Words(
                '待求的载荷（size: "?"）在每一位置都要平衡其余载荷，不能只在部分位置作用；请删去 while、during',
                'the load that balances (size: "?") does so at every position, and cannot act at some only; leave out '
                "'while' and 'during'",
            ),
            code="contradiction",
        )
    size = table if table is not None else load.law.size if load.law is not None else None
    if table is not None:
        load = replace(load, size=table.greatest)
    return replace(load, law=Law(windows=windows, size=size)) if windows or size is not None else load


def _refuse_loose(spec: LoadSpec) -> None:
    """FaultError for what belongs to a spring."""
    loose = [key for key in ("k", "l_0", "phi_0", "preload", "c") if getattr(spec, key) is not None]
    if loose:
        raise FaultError(
            Words(
                f"{'、'.join(loose)} 属于弹簧或阻尼器；请写 spring: B-D 或 damper: B-D，或将其删去",
                f"{', '.join(loose)} belong to a spring or a damper; write spring: B-D or damper: B-D, or leave it out",
            ),
            loose[0],
            code="contradiction",
        )


def _table(load: Force | Moment, spec: LoadSpec, driven: Driven) -> Table | None:
    if not isinstance(spec.size, TableSpec):
        return None
    over = None
    if isinstance(load, Force) and not load.against:
        over = Travel(link=load.link, point=load.point, direction=load.direction)
    try:
        return read_table(spec.size, over, isinstance(load, Force), driven)
    except FaultError as fault:
        raise fault.under("size") from None


def read_motor(name: str, spec: LoadSpec, draft: Draft, driven: Driven) -> Moment:
    """A motor on the driving link by its characteristic, M = a - b ω in the sense of its rotation."""
    assert spec.motor is not None
    _refuse_elsewhere("motor", Words("电动机", "a motor"), spec, draft, driven)
    driven.refuse_unrated(Words("电动机的力矩", "the moment of a motor"))
    try:
        stall, slope = read(spec.motor[0], Dim.MOMENT).si, read(spec.motor[1], Dim.DRAG).si
    except FaultError as fault:
        raise fault.under("motor") from None
    if stall <= 0 or slope < 0:
        raise FaultError(
            Words(
                f"motor: [{spec.motor[0]}, {spec.motor[1]}]：M = a − b ω 中 a 应为正，b 不为负；"
                "如写 [2400 N*m, 330 N*m*s]",
                f"motor: [{spec.motor[0]}, {spec.motor[1]}]: in M = a - b omega a must be positive, b not negative; "
                "write e.g. [2400 N*m, 330 N*m*s]",
            ),
            "motor",
            code="out-of-range",
        )
    law = Law(size=Motor(stall=copysign(stall, driven.drive.rate), slope=slope))
    size = copysign(stall, driven.drive.rate) - slope * driven.drive.rate
    return Moment(name=name, link=draft.name, size=size, role=spec.role or "", law=law)


_NONE_OF_SLIDES = Words('请改写 size: "?"（求此位置的值）', 'write size: "?" instead, which is of this position')


def read_constant(name: str, spec: LoadSpec, draft: Draft, driven: Driven) -> Constant:
    """The unknown moment on the driving link that is the same over the period."""
    _refuse_loose(spec)
    _refuse_elsewhere(
        "size", Words("一周期内的常力矩", "a moment that is constant over the period"), spec, draft, driven
    )
    return Constant(name=name, link=draft.name, role=spec.role or "")


def _refuse_elsewhere(key: str, what: Words, spec: LoadSpec, draft: Draft, driven: Driven) -> None:
    """FaultError where it is not a moment on the turning driving link, always there."""
    drive = driven.drive
    if drive.link and (drive.slide or drive.between or draft.name != drive.link):  # else what drives is a fault itself
        turns = not (drive.slide or drive.between)
        here = Words("转动", "turns") if turns else Words("移动", "slides")
        remedy = Words(f"请写 on: {drive.link}", f"write on: {drive.link}") if turns else _NONE_OF_SLIDES
        raise FaultError(
            Words(
                f"{what.zh}只能作用于转动的原动件，而这里写在构件 {draft.name} 上，"
                f"原动件是构件 {drive.link}（{here.zh}）；",
                f"{what.en} acts on the driving link, which must turn; here it is on link {draft.name}, and link "
                f"{drive.link} drives ({here.en}); ",
            )
            + remedy,
            "on",
            code="no-period" if key == "size" else "contradiction",
        )
    extra = ["at", "direction", "between", "while", "during", *(["size"] if key == "motor" else [])]
    for one in extra:
        if getattr(spec, one) is not None:
            raise FaultError(
                Words(f"{what.zh}是始终作用的力矩；请删去 {one}", f"{what.en} always acts; leave out {one}"),
                one,
                code="contradiction",
            )
