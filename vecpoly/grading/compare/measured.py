"""What was written, in the unit of the quantity that was asked."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from math import copysign

from ..key import Graded, Kind
from ..reading.direction import Pointing
from ..reading.unit import unit
from ..reading.written import State, Written


class UnitFault(StrEnum):
    """What is wrong with a unit."""

    MISSING = "missing"
    DIMENSION = "dimension"


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """value: in the unit of the quantity, with its sign where one was written. sense: 1, −1; 0 where nothing says it.

    half: half a unit of the last digit. fault: of its unit, with which the value is as if the unit were right.
    """

    value: float
    sense: int = 0
    direction: Pointing | None = None
    at: tuple[float, float] | None = None
    yes: bool | None = None
    half: float = 0.0
    fault: UnitFault | None = None


_ANGLE = "angle 1 "
_RULED = {n: one for n, name in ((1.0, "mm"), (10.0, "cm")) if (one := unit(name)) is not None}


def measured(written: Written, graded: Graded, scale: float | None = None) -> Measured | None:
    """The value in the quantity's unit; None where nothing was read, or not what can be compared with it.

    scale: SI per mm, by which a length on paper stands for a vector.
    """
    if written.state is State.NONE and graded.exact == 0:
        return Measured(value=0.0, yes=False)  # “none” is the right answer where there is none
    if written.state is not State.READ or (written.yes is None) is (graded.kind is Kind.YES_NO):
        return _number_for_yes(written, graded)
    if (written.at is None) is (graded.kind is Kind.PLACE) or _beside_the_point(written, graded):
        return None
    factor, fault = _factor(written, graded)
    if fault is UnitFault.DIMENSION and scale and graded.kind is Kind.VECTOR and (paper := _on_paper(written)):
        factor, fault = scale * paper, None
    sense = written.sense or (1 if written.signed else 0) * (-1 if written.value < 0 else 1)
    at = None if written.at is None else (written.at[0] * factor, written.at[1] * factor)
    value = written.value if written.yes is None else float(written.yes)
    value = copysign(value, graded.exact) if graded.unsigned else value
    return Measured(
        value=value * factor, sense=sense, direction=written.direction, at=at, yes=written.yes,
        half=written.last * factor / 2, fault=fault,
    )  # fmt: skip


def _on_paper(written: Written) -> float | None:
    """How many mm one is of the unit, mm or cm, in which a length was read: a speed in m lacks its /s."""
    read = written.unit
    return next((n for n, one in _RULED.items() if read is not None and read[1:] == one[1:]), None)


def _beside_the_point(written: Written, graded: Graded) -> bool:
    """A sense of turning of what moves along a line, or a direction of what turns."""
    if graded.kind is Kind.VECTOR:
        return written.sense != 0
    return graded.kind is Kind.SIGNED and written.direction is not None


def _number_for_yes(written: Written, graded: Graded) -> Measured | None:
    """1 and 0 for yes and no."""
    if graded.kind is Kind.YES_NO and written.state is State.READ and written.value in (0.0, 1.0):
        return Measured(value=written.value, yes=bool(written.value))
    if graded.kind is Kind.YES_NO and written.state is State.NONE and written.yes is not None:
        return Measured(value=0.0, yes=written.yes)
    return None


def _factor(written: Written, graded: Graded) -> tuple[float, UnitFault | None]:
    if graded.kind is Kind.YES_NO:
        return 1.0, None
    asked = unit(graded.written_in) if graded.written_in else None
    if written.unit is None:
        return graded.one, None if asked is None else UnitFault.MISSING
    mine, theirs = "" if asked is None else asked.dimension, written.unit.dimension
    if mine == theirs or mine == _ANGLE + theirs:  # 1/s for rad/s
        return graded.one * written.unit.factor / (asked.factor if asked else 1.0), None
    return graded.one, UnitFault.DIMENSION
