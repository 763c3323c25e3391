"""What counterweights do over a whole turn, in words: the shaking force without them, and as they were drawn."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import degrees, isfinite, radians
from typing import TYPE_CHECKING

from ..mechanism.asked.counterweights import bearing, product
from ..mechanism.counterweights import Counterweights
from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..words import Words

if TYPE_CHECKING:
    from ..oracle.machine.balance import Hung


NOTHING = 1e-9  # of what is of its like: rounding


def shaking_of(problem: Problem, drawn: Mapping[str, float]) -> Words | None:
    """Of a linkage with counterweights that is driven at a speed of known size; drawn: what was read, by its key."""
    asked = problem.counterweights
    if asked is None:
        return None
    mech = problem.mechanism
    if not mech.drive.rate or _sense_only(problem):
        return None
    from ..oracle.machine.balance import counterweights
    from ..oracle.machine.counterweighted import shaking

    without, exact = shaking(mech, asked), shaking(mech, asked, counterweights(mech, asked))
    most, where = without.largest
    at = f"{degrees(mech.drive.told(where)):.4g}°"
    x, y = (_shown(1e3 * part, 1e3 * mech.scale, 4) for part in _parts(complex(exact.centre.mean())))
    told = Words(
        f"校核（{_over(len(without.at)).zh}）：不加配重时机架所受惯性力最大 {most:.4g} N"
        f"（原动件位于 {at}）；按精确的配重，总质心静止于 ({x}, {y}) mm，"
        f"惯性力为零",
        f"Check ({_over(len(without.at)).en}): without counterweights the shaking force on the frame is {most:.4g} N "
        f"at most (drive at {at}); with exact ones the common centre of mass rests at "
        f"({x}, {y}) mm and the force is zero",
    )
    hung = _hung(mech, asked, drawn)
    if hung is None or not most:
        return told + Words("。", ".")
    left = shaking(mech, asked, hung).largest[0]
    size, share = _shown(left, most, 2), _shown(100 * left / most, 100, 2)
    return told + Words(
        f"；按图上量得的配重，最大还剩 {size} N（{share} %）。",
        f"; with those read off the sheet {size} N are left at most ({share} %).",
    )


def _parts(place: complex) -> tuple[float, float]:
    return place.real, place.imag


def _shown(value: float, beside: float, digits: int) -> str:
    """A number; 0 where it is rounding beside the size of its like."""
    return f"{value:.{digits}g}" if abs(value) > NOTHING * beside else "0"


def _sense_only(problem: Problem) -> bool:
    """Whether of the drive's speed only the sense is given: 1 rad/s is taken."""
    rates = ("ω", "$ω", "n", "v")
    return not any(datum.symbol.startswith(rates) for datum in problem.given.motion)


def _over(positions: int) -> Words:
    return Words("整周分析", "whole turn") if positions > 1 else Words("图示位置", "position drawn")


def _hung(mech: Mechanism, asked: Counterweights, drawn: Mapping[str, float]) -> tuple[Hung, ...] | None:
    """The counterweights as drawn; None where not all of them were asked for."""
    from ..oracle.machine.balance import Hung

    found = []
    for one in asked.mounts:
        no, link = mech.number(one.link), mech.link(one.link)
        size, turn = drawn.get(product(no).key), drawn.get(bearing(no).key)
        if size is None or turn is None:
            return None
        line = link.points[one.towards] - link.points[one.outlets[0].point]
        way = cmath.rect(1.0, radians(turn)) * line / abs(line) if isfinite(turn) else 0.0
        found.append(Hung(of=one, w=size * way))
    return tuple(found)
