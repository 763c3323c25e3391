"""Every load as it acts in this position: of constant size, of a size that was read, or not at all."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity, magnitude, number
from ....board.construction import Reading
from ....errors import EquilibriumError
from ....foundation.slotted import replace
from ....mechanism.asked.forces import load_named
from ....mechanism.laws.acting import is_beyond, is_within, place_in, tabulated
from ....mechanism.laws.sizes import Motor, Table
from ....mechanism.laws.springs import Coil
from ....mechanism.laws.told import beyond
from ....mechanism.laws.windows import During, Moving, Turning, Window
from ....mechanism.loads import Force, Load, Loads, Moment
from ....names import Named
from ....plane import Reals, nominal
from ....words import Words
from ...desk import Desk
from .off_paper import OffPaper
from .pull import Pull
from .springs import pulled, turned

Pulls = dict[str, Pull]
_SIDES = {
    0: Words("向右", "to the right"),
    1: Words("向上", "up"),
    2: Words("向左", "to the left"),
    3: Words("向下", "down"),
}


def found_loads(desk: Desk, loads: Loads) -> tuple[Loads, Pulls]:
    """The loads of this position, springs as forces, and those whose size was read off the sheet.

    Raises EquilibriumError where a table says nothing of it.
    """
    at, pulls = OffPaper(desk), Pulls()
    found: list[Load] = []
    for load in loads.at(desk.mech).all:
        here = load if load.law is None else _lawful(at, load, pulls)
        found += [] if here is None else [here]
    for spring in loads.springs:
        forces, read = turned(at, spring) if isinstance(spring, Coil) else pulled(at, spring)
        found += forces
        pulls |= read
    forces_, moments = (tuple(x for x in found if isinstance(x, kind)) for kind in (Force, Moment))
    return replace(loads, forces=forces_, moments=moments, springs=()), pulls


def _lawful(at: OffPaper, load: Load, pulls: Pulls) -> Load | None:
    """The load as it acts here; None where it does not."""
    assert load.law is not None
    named = load_named(load)
    at.desk.board.step(
        Words(f"载荷 ${named.symbol}$ 随位置变化。", f"The load ${named.symbol}$ depends on the position.")
    )
    inside = [_is_within(at, window) for window in load.law.windows]
    if not all(inside):
        at.desk.board.remark(Words(f"故此时 ${named.symbol}$ 不作用。", f" So ${named.symbol}$ does not act here."))
        _keep(at, named, 0.0)
        return None
    size = load.law.size
    if size is None:
        assert load.size is not None
        at.desk.board.remark(Words(f"故此时 ${named.symbol}$ 作用。", f" So ${named.symbol}$ acts here."))
        _keep(at, named, load.size)
        return replace(load, law=None)
    value = (_motor(at, load, size) if isinstance(size, Motor) else _by_table(at, load, size)).value
    _keep(at, named, value)
    along = complex(np.exp(1j * load.direction)) if isinstance(load, Force) else 1 + 0j
    pulls[load.name] = Pull(size=value, along=along)
    return replace(load, law=None, size=float(nominal(value))) if float(nominal(value)) else None


def _keep(at: OffPaper, named: Named, value: Reals) -> None:
    size = float(nominal(value))
    at.desk.board.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=size), value)


def _is_within(at: OffPaper, window: Window) -> bool:
    """Whether the mechanism is within the window, which is said."""
    here = bool(nominal(is_within(window, at)))
    board = at.desk.board
    match window:
        case Moving(link=link, point=point, direction=way):
            goes = at.speed(link, point, way)
            told = Words("朝该方向", "that way") if goes > 0 else Words("不朝该方向", "not that way")
            side = _SIDES.get(round(way / (np.pi / 2)) % 4) if abs(way / (np.pi / 2) % 1) < 1e-9 else None
            side = side or Words(f"沿 {np.degrees(way):g}°", f"along {np.degrees(way):g}°")
            board.remark(
                Words(
                    f"它仅在 ${point}$ 点{side.zh}运动时作用；由速度多边形知 ${point}$ 此时{told.zh}运动。",
                    f" It acts only while ${point}$ moves {side.en}; by the velocity polygon it moves {told.en} here.",
                )
            )
            if window.is_part and goes > 0:
                _say_part(at, window)
        case Turning(link=link, sense=sense):
            side = Words("逆时针", "counter-clockwise") if sense > 0 else Words("顺时针", "clockwise")
            does = Words("如此", "so") if here else Words("不如此", "not so")
            board.remark(
                Words(
                    f"它仅在构件 {link} {side.zh}转动时作用；此时{does.zh}。",
                    f" It acts only while link {link} turns {side.en}, and here it does {does.en}.",
                )
            )
        case During():
            does = Words("在", "within") if here else Words("不在", "not within")
            board.remark(
                Words(f"原动件{does.zh}其作用的范围内。", f" The drive is {does.en} the range in which it acts.")
            )
    return here


def _say_part(at: OffPaper, window: Moving) -> None:
    gone, whole = at.travel((window.link, window.point, window.direction))
    part = 100 * float(nominal(gone.value)) / whole
    low, high = 100 * window.low, 100 * window.high
    at.desk.board.remark(
        Words(
            f"由极限位置 ${window.point}_0$ 量起，已走过行程 {1e3 * whole:.4g} mm 的 {part:.3g} %"
            f"（作用范围 {low:g} %～{high:g} %）。",
            f" Measured from its dead position ${window.point}_0$ it has gone {part:.3g} % of its stroke of "
            f"{1e3 * whole:.4g} mm (the load acts from {low:g} % to {high:g} %).",
        )
    )


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
