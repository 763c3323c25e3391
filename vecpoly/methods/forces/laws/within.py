"""Whether a load that acts on a part of the cycle acts in this position: one sentence, from what the sheet shows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....algebra.quantity import number
from ....mechanism.laws.acting import is_within
from ....mechanism.laws.windows import During, Moving, Turning, Window
from ....names import Named
from ....plane import nominal
from ....words import Words, begun
from .off_paper import OffPaper

_SIDES = {
    0: Words("向右", "to the right"),
    1: Words("向上", "up"),
    2: Words("向左", "to the left"),
    3: Words("向下", "down"),
}


def tell_windows(at: OffPaper, named: Named, windows: Sequence[Window]) -> bool:
    """Whether the mechanism is within all of them; says of each, and what follows."""
    if not windows:
        return True
    found = [_told(at, window) for window in windows]
    acts, clauses = all(here for here, _ in found), [clause for _, clause in found]
    said = Words("，".join(clause.zh for clause in clauses), ", ".join(clause.en for clause in clauses))
    so = Words(
        f"，故 ${named.symbol}$ {'起' if acts else '不起'}作用。",
        f", so ${named.symbol}$ {'acts' if acts else 'does not act'} here.",
    )
    at.desk.board.remark(begun(said) + so)
    return acts


def _told(at: OffPaper, window: Window) -> tuple[bool, Words]:
    here = bool(nominal(is_within(window, at)))
    return here, _clause(at, window, here=here)


def _clause(at: OffPaper, window: Window, *, here: bool) -> Words:
    match window:
        case Moving():
            return _moving(at, window, here=here)
        case Turning(link=link, sense=sense):
            side = Words("逆时针", "counter-clockwise") if sense > 0 else Words("顺时针", "clockwise")
            return Words(
                f"构件 {link} 此时{'' if here else '不作'}{side.zh}转动",
                f"link {link} {'rotates' if here else 'does not rotate'} {side.en} here",
            )
        case During():
            return _during(at, window, here=here)


def _moving(at: OffPaper, window: Moving, *, here: bool) -> Words:
    """Which way the point moves, and where on its stroke it is."""
    point, way = window.point, window.direction
    goes = bool(nominal(at.speed(window.link, point, way)) > 0)
    side = _SIDES.get(round(way / (np.pi / 2)) % 4) if abs(way / (np.pi / 2) % 1) < 1e-9 else None
    side = side or Words(f"朝 {np.degrees(way):g}° 方向", f"in the direction {np.degrees(way):g}°")
    found = Words(
        f"由速度多边形知 ${point}$ 点此时{'' if goes else '不'}{side.zh}运动",
        f"by the velocity polygon ${point}$ {'moves' if goes else 'does not move'} {side.en} here",
    )
    return found + _part(at, window, here=here) if window.is_part and goes else found


def _part(at: OffPaper, window: Moving, *, here: bool) -> Words:
    gone, whole = at.travel((window.link, window.point, window.direction))
    part = 100 * float(nominal(gone.value)) / whole
    low, high = 100 * window.low, 100 * window.high
    return Words(
        f"；由极限位置 ${window.point}_0$ 量起，已走过行程 {1e3 * whole:.4g} mm 的 {part:.3g} %，"
        f"{'' if here else '不'}在 {low:g} %～{high:g} % 内",
        f"; measured from its dead position ${window.point}_0$ it has gone {part:.3g} % of its stroke of "
        f"{1e3 * whole:.4g} mm, {'' if here else 'not '}within {low:g} % to {high:g} %",
    )


def _during(at: OffPaper, window: During, *, here: bool) -> Words:
    """φ_1 = 120° within 60° to 150°, or s_1 in mm."""
    drive = at.desk.mech.drive
    unit, mark = (1e3, " mm") if drive.slide else (180 / np.pi, "°")
    place, starts, ends = (drive.told(float(nominal(size))) for size in (at.drive(), window.low, window.high))
    if here and window.period:
        shifted = starts + (place - starts) % window.period
        place = shifted if shifted <= ends else place % window.period  # 60° within 300° to 100°
    now, low, high = (f"{number(unit * size)}{mark}" for size in (place, starts, ends))
    return Words(
        f"${drive.symbol}$ = {now} {'' if here else '不'}在 {low}～{high} 内",
        f"the position ${drive.symbol}$ = {now} lies {'within' if here else 'outside'} {low} to {high}",
    )
