"""A value against another: bands of T for its size, its direction, its sense."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, degrees, hypot, radians, sin

from ..allowance import Allowance
from ..key import Graded, Kind, beside, come_round
from .measured import Measured
from .outcome import Outcome


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """What a value is held against: its size or value, T, the direction of a vector."""

    value: float
    allowed: float
    degrees: float | None = None
    mm: float | None = None
    at: tuple[float, float] | None = None


def target_of(graded: Graded) -> Target:
    """The exact value with its T."""
    return Target(value=graded.exact, allowed=graded.allowed, degrees=graded.degrees, mm=graded.mm, at=graded.at)


def gap(value: float, graded: Graded, target: Target) -> float:
    """How far a value is off, by size where its sense is told apart."""
    if graded.kind in (Kind.VECTOR, Kind.SIGNED, Kind.READING):
        return abs(value) - abs(target.value)
    if graded.kind is Kind.LINE:
        return float(beside(value, target.value)) - target.value
    if graded.unit == "deg":
        return float(come_round(value, target.value)) - target.value
    return value - target.value


def distance(given: Measured, graded: Graded, target: Target) -> float:
    """How far what was written is off, of a place in a straight line."""
    if given.at is not None and target.at is not None:
        return hypot(given.at[0] - target.at[0], given.at[1] - target.at[1])
    return abs(gap(given.value, graded, target))


def beside_line(given: Measured, graded: Graded, target: Target) -> float:
    """How far a place is off across the direction in which drawings scatter; nothing where they do so in all alike."""
    if given.at is None or target.at is None or graded.leans is None:
        return 0.0
    turn = radians(graded.leans)
    return abs((given.at[1] - target.at[1]) * cos(turn) - (given.at[0] - target.at[0]) * sin(turn))


def widened(given: Measured, target: Target) -> float:
    """T with what the last digit that was written hides: nobody writes more digits than he has; 0 hides nothing."""
    return target.allowed + (min(given.half, target.allowed) * 0.5 if given.value else 0.0)


def _upwards(graded: Graded, target: Target, rule: Allowance) -> float:
    """T of a length that is hardly one and comes out longer, where drawings scatter by more than it: none comes out
    less than nothing."""
    short = graded.demoted and graded.mm is not None and graded.mm < rule.short
    return rule.k * graded.sigma if short and target.allowed >= abs(target.value) else 0.0


def is_other_sense(given: Measured, graded: Graded) -> bool:
    """Whether a sense of turning was written, and is not the exact one."""
    turns = graded.kind is Kind.SIGNED and bool(graded.exact)
    return turns and given.sense != 0 and (given.sense > 0) is not (graded.exact > 0)


def weigh(given: Measured, graded: Graded, target: Target, rule: Allowance) -> Outcome:
    """The outcome: ≤ T right, ≤ `wrong` T close; a sense or a direction is looked at where the size is right."""
    if graded.kind is Kind.YES_NO:
        return Outcome.RIGHT if given.yes == bool(target.value) else Outcome.WRONG
    if graded.kind is Kind.PLACE and given.at is not None and target.at is not None:
        whole = _band(distance(given, graded, target), target.allowed, rule)
        return max(whole, _band(beside_line(given, graded, target), graded.across, rule), key=_PLACED.index)
    if _nothing(given, graded, target, rule):
        return Outcome.WRONG
    off = gap(given.value, graded, target)
    sized = _band(abs(off), max(widened(given, target), _upwards(graded, target, rule) if off > 0 else 0.0), rule)
    if sized is Outcome.WRONG:
        return _sign(given, graded, target, rule)
    turned = _turned(given, graded, target, rule)
    return sized if turned is None or (turned is Outcome.UNSAID and sized is Outcome.CLOSE) else turned


def _nothing(given: Measured, graded: Graded, target: Target, rule: Allowance) -> bool:
    """Whether 0 is written of what is there: however much drawings scatter, none shows nothing of what is no less than
    they may be off."""
    seen = target.mm is None or target.mm >= rule.short
    return not given.value and bool(target.value) and graded.unit != "deg" and seen and (
        target.allowed <= abs(target.value) * (1 + 1e-9)
    )  # fmt: skip


_PLACED = (Outcome.RIGHT, Outcome.CLOSE, Outcome.WRONG)  # the worse the farther behind


def _band(off: float, allowed: float, rule: Allowance) -> Outcome:
    if off <= allowed * (1 + 1e-9):
        return Outcome.RIGHT
    return Outcome.CLOSE if off <= rule.wrong * allowed else Outcome.WRONG


def _sign(given: Measured, graded: Graded, target: Target, rule: Allowance) -> Outcome:
    """Of a number with a sign: whether it is right but for that."""
    same = abs(abs(given.value) - abs(target.value)) <= rule.wrong * target.allowed
    return Outcome.SENSE if graded.kind is Kind.SCALAR and same and graded.unit != "deg" else Outcome.WRONG


def _turned(given: Measured, graded: Graded, target: Target, rule: Allowance) -> Outcome | None:
    """What is wrong with the sense or the direction of a value of the right size."""
    if abs(target.value) <= target.allowed:
        return None  # a vector of no length has none
    if graded.kind is Kind.SIGNED:
        if given.sense == 0:
            return Outcome.UNSAID
        return Outcome.SENSE if (given.sense > 0) is not (target.value > 0) else None
    if graded.kind is not Kind.VECTOR or given.direction is None or target.degrees is None:
        return None
    if target.mm is not None and target.mm < rule.short:
        return None
    off = given.direction.beside(target.degrees + (180.0 if given.value < 0 else 0.0))
    hand = max(rule.direction, rule.wrong * rule.k * graded.turned, degrees(target.allowed / abs(target.value)))
    reach = hand + given.direction.reach
    if off <= reach:
        return None
    return Outcome.SENSE if abs(off - 180.0) <= reach else Outcome.DIRECTION
