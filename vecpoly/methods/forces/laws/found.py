"""Every load as it acts in this position: of constant size, of a size that was read, or not at all."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity, magnitude, number
from ....board.construction import Reading
from ....errors import EquilibriumError
from ....foundation.slotted import replace
from ....mechanism.asked.forces import load_named
from ....mechanism.laws.acting import is_beyond, place_in, tabulated
from ....mechanism.laws.sizes import Law, Motor, Table
from ....mechanism.laws.springs import Coil, Elastic
from ....mechanism.laws.told import beyond
from ....mechanism.loads import Force, Load, Loads, Moment
from ....names import Named
from ....plane import Reals, nominal
from ....words import Words
from ...desk import Desk
from .coils import turned
from .off_paper import OffPaper
from .pull import Acted, Pull
from .springs import pulled
from .within import tell_windows

Pulls = dict[str, Pull]


def found_loads(desk: Desk, loads: Loads) -> tuple[Loads, Pulls]:
    """The loads of this position, springs as forces, and those whose size was read off the sheet.

    Raises EquilibriumError where a table says nothing of it.
    """
    at, pulls = OffPaper(desk), Pulls()
    found: list[Load] = []
    for one in (*loads.at(desk.mech).all, *loads.springs):
        here = _once(at, one)
        found += here.loads
        pulls |= here.pulls
    forces_ = tuple(one for one in found if isinstance(one, Force))
    moments = tuple(one for one in found if isinstance(one, Moment))
    return replace(loads, forces=forces_, moments=moments, springs=()), pulls


def _once(at: OffPaper, one: Load | Elastic) -> Acted:
    """What it does here; what was read already, for the reactions, is not read and told again."""
    if isinstance(one, Force | Moment) and one.law is None:
        return Acted(of=one, loads=(one,))
    known = at.desk.acting.get(one.name)
    if known is None or known.of != one:
        known = at.desk.acting[one.name] = _found(at, one)
    return known


def _found(at: OffPaper, one: Load | Elastic) -> Acted:
    if isinstance(one, Force | Moment):
        return _lawful(at, one)
    loads, pulls = turned(at, one) if isinstance(one, Coil) else pulled(at, one)
    return Acted(of=one, loads=loads, pulls=pulls)


def _lawful(at: OffPaper, load: Load) -> Acted:
    """The load as it acts here, or that it does not."""
    assert load.law is not None
    named, size = load_named(load), load.law.size
    at.desk.board.step(_opening(named, load.law))
    if not tell_windows(at, named, load.law.windows):
        _keep(at, named, 0.0)
        return Acted(of=load)
    if size is None:
        assert load.size is not None
        _keep(at, named, load.size)
        return Acted(of=load, loads=(replace(load, law=None),))
    value = (_motor(at, load, size) if isinstance(size, Motor) else _by_table(at, load, size)).value
    _keep(at, named, value)
    along = complex(np.exp(1j * load.direction)) if isinstance(load, Force) else 1 + 0j
    pull = {load.name: Pull(size=value, along=along, is_signed=not isinstance(size, Motor))}
    if not float(nominal(value)):
        return Acted(of=load, pulls=pull)
    return Acted(of=load, loads=(replace(load, law=None, size=float(nominal(value))),), pulls=pull)


def _opening(named: Named, law: Law) -> Words:
    """On what it depends, where that is not said by its windows."""
    if law.windows:
        return Words("", "")
    by = Words("速度", "speed") if isinstance(law.size, Motor) else Words("位置", "position")
    return Words(f"载荷 ${named.symbol}$ 随{by.zh}变化。", f"The load ${named.symbol}$ depends on the {by.en}.")


def _keep(at: OffPaper, named: Named, value: Reals) -> None:
    size = float(nominal(value))
    at.desk.board.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=size), value)


def _motor(at: OffPaper, load: Load, motor: Motor) -> Quantity:
    """M = M_0 - b ω at the speed of the drive."""
    named = load_named(load)
    rate = abs(at.desk.mech.drive.rate)
    expr = magnitude("a", abs(motor.stall), "N·m") - magnitude("b", motor.slope, "N·m·s") * magnitude(
        f"ω_{load.link}", rate, "rad/s"
    )
    size = at.desk.board.compute(named.symbol, expr, "N·m")
    return magnitude(named.symbol, np.sign(motor.stall) * size.value, "N·m")


def _by_table(at: OffPaper, load: Load, table: Table) -> Quantity:
    """The size that the table gives at the place that is given, or was measured."""
    named = load_named(load)
    if bool(np.any(nominal(is_beyond(load, at)))):
        place = float(nominal(place_in(table, at)))
        raise EquilibriumError(beyond(load, table, place, at.desk.mech), code="out-of-range")
    value = tabulated(table, at)
    size = float(nominal(value))
    at.desk.board.remark(
        Words(
            f"由数据表查得（直线内插）${named.symbol}$ = {number(size)} {named.unit}。",
            f" The table gives, on straight lines, ${named.symbol}$ = {number(size)} {named.unit}.",
        )
    )
    return magnitude(named.symbol, at.desk.board.conclude(named.key, value, named.unit), named.unit)
