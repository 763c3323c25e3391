"""What to say where the construction does not fit two figures: how far off what lies, and where the drive would do."""

from __future__ import annotations

from collections.abc import Callable
from math import degrees, inf, radians

from ...board.paper.extent import box_of
from ...errors import NotAskedError, VecpolyError
from ...foundation.slotted import replace
from ...plane import nominal
from ...words import Words
from ..desk import Desk
from ..positions.placed import placed_as_told
from .room import LEAST, REDUCED, Box, Wanted, room_for, sketched

STEPS = (5, -5, 10, -10, 15, -15, 20, -20, 30, -30, 40, -40, 50, -50, 60, -60, 80, -80, 100, -100, 120, -120, 150, 180)
FINE, MOST = 5.0, 36  # deg, how many of them: the steps by which a range is followed
EASY = 1.25  # times as large the mechanism must be where a position is recommended: letters do not shrink with it


def off_the_sheet(want: Wanted) -> NotAskedError:
    """With the range of the drive, about the nearest position of those tried, in which all fits."""
    desk = want.desk

    def fits(phi: float) -> bool:
        try:
            there = placed_as_told(desk, radians(phi))
            easy = replace(want, desk=there, box=_box(there), sharing=inf, least=EASY * LEAST, reduced=REDUCED / 10)
            return room_for(easy) is not None
        except VecpolyError:
            return False

    here = degrees(desk.mech.drive.position)
    steps = () if desk.mech.drive.slide or desk.thought else STEPS
    other = next((round(here + step, 6) for step in steps if fits(here + step)), None)
    if other is None:
        return NotAskedError(_why(want) + _other(None), code="off-the-sheet")
    low, high = (_end(fits, other, sense * FINE) for sense in (-1, 1))
    return NotAskedError(_why(want) + _other((low, high)), code="off-the-sheet", numbers={"from": low, "to": high})


def _end(fits: Callable[[float], bool], phi: float, step: float) -> float:
    """How far one may go on by these steps."""
    for _ in range(MOST):
        if not fits(phi + step):
            break
        phi += step
    return phi


def _box(there: Desk) -> Box:
    return box_of([complex(nominal(at)) for at in there.at.values()])


def _why(want: Wanted) -> Words:
    """Which of the points lies how far off."""
    low, high = want.box
    spots = sketched(want).spots
    name = max(spots, key=lambda one: abs(spots[one] - (low + high) / 2))
    times = abs(spots[name] - (low + high) / 2) / max((high - low).real, (high - low).imag)
    return Words(
        f"${name}$ 到机构的距离为机构大小的 {times:.0f} 倍，缩小图上也作不出",
        f"${name}$ lies {times:.0f} times as far from the mechanism as that is large: no reduced figure holds it",
    )


def _other(fitting: tuple[float, float] | None) -> Words:
    if fitting is None:
        return Words("；请另取原动件位置", "; choose another input position")
    low, high = fitting
    if high - low < FINE:
        return Words(f"；可取 φ = {low % 360:g}°", f"; φ = {low % 360:g}° would do")
    return Words(
        f"；可取 φ = {low % 360:g}° 至 {high % 360:g}°", f"; φ from {low % 360:g}° to {high % 360:g}° would do"
    )
