"""What explains one wrong value by itself: powers of ten, 2π, r/min, another vector taken for this one."""

from __future__ import annotations

from collections.abc import Iterator
from math import log10, pi, radians

from ...errors import UnknownNameError
from ...names import Rel, parse_rel
from ..compare.band import Target, distance, gap
from ..compare.measured import Measured
from ..key import AnswerKey, Graded, Kind
from ..told.message import Message, message
from ..told.named import Told
from .places import of_places

NEAR = 0.05  # a factor is one only as near as this
TENS = 7
ASKEW = 15.0  # deg by which a direction is nearer to that of one vector than to that of another
POWERS = {"m/s": (1,), "rad/s": (1,), "m/s^2": (2,), "rad/s^2": (1, 2)}  # of ω in what has this unit


def explanations(one: Graded, mine: Measured, target: Target, key: AnswerKey) -> tuple[Message, ...]:
    """Every explanation that fits; more than one is none."""
    if one.kind is Kind.PLACE:
        return tuple(of_places(one, mine, target, key))
    if one.kind is Kind.YES_NO:
        return ()
    if abs(target.value) <= one.allowed and not one.exact:
        return () if one.unit == "deg" else (_why_zero(one),)  # 0° is a direction
    if not target.value or not mine.value:
        return ()
    near = min(NEAR, one.allowed / abs(one.exact)) if one.exact else NEAR
    return (*_factors(one, abs(mine.value / target.value), near), *_others(one, mine, key))


def _factors(one: Graded, ratio: float, near: float) -> list[Message]:
    """What a value may be off by, without what fits far less well than the best."""
    fitting = [(abs(ratio / factor - 1), said) for factor, said in _known(one, ratio) if _is(ratio, factor, near)]
    nearest = min((off for off, _ in fitting), default=0.0)
    found: list[Message] = []
    for off, said in fitting:
        if off - nearest <= near / 2 and said not in found:
            found.append(said)
    return found


def _known(one: Graded, ratio: float) -> Iterator[tuple[float, Message]]:
    """Powers of ten; turns and minutes in what goes with ω, their squares in what goes with ω²."""
    power = round(log10(ratio))
    if power and abs(power) <= TENS:
        yield 10.0**power, message(Told.POW10, n=str(power))
    for exponent in POWERS.get(one.unit, ()):
        for factor, told in ((2 * pi, Told.TURNS), (2 * pi / 60, Told.PER_MINUTE)):
            yield from ((factor ** (sign * exponent), message(told)) for sign in (1, -1))
    if one.unit == "deg":
        yield from ((radians(1) ** sign, message(Told.DEGREES)) for sign in (1, -1))


def _is(ratio: float, factor: float, near: float) -> bool:
    return abs(ratio / factor - 1) <= near


def _others(one: Graded, mine: Measured, key: AnswerKey) -> Iterator[Message]:
    """Vectors of the same name or letters whose value this is: v for v_rel, pc for bc, a coincident point of another
    link.
    """
    yield from (message(Told.SWAPPED, other=other.symbol) for other in taken_for(one, mine, key))


def taken_for(one: Graded, mine: Measured, key: AnswerKey) -> Iterator[Graded]:
    """The quantities whose value stands in the place of this one's; none with the direction of this one."""
    for other in mistaken_for(one, key):
        if _has_direction_of(one, mine, other):
            continue
        target = Target(value=other.exact, allowed=other.allowed)
        if abs(gap(mine.value, other, target)) <= other.allowed / 2:
            yield other


def _has_direction_of(one: Graded, mine: Measured, other: Graded) -> bool:
    """Whether the direction that was written is that of this quantity, and not of the other."""
    if mine.direction is None or one.degrees is None or other.degrees is None:
        return False
    near, far = mine.direction.beside(one.degrees), mine.direction.beside(other.degrees)
    return near + ASKEW < far


def is_value_of(mine: Measured, one: Graded, other: Graded) -> bool:
    """Whether what was written of one quantity is the value of another of its kind."""
    if other.unit != one.unit or other.kind is not one.kind or one.kind is Kind.YES_NO:
        return False
    target = Target(value=other.exact, allowed=other.allowed, at=other.at)
    return distance(mine, other, target) <= other.allowed


def mistaken_for(one: Graded, key: AnswerKey) -> Iterator[Graded]:
    """The quantities that are easily taken for this one, and are far enough from it to be told apart."""
    for other in key.quantities:
        if other.symbol == one.symbol or other.unit != one.unit or other.kind is not one.kind or not _kin(one, other):
            continue
        apart = abs(gap(other.exact, one, Target(value=one.exact, allowed=0.0)))
        if apart > 2 * (one.allowed + other.allowed):
            yield other


def _kin(one: Graded, other: Graded) -> bool:
    """Whether one is easily taken for the other."""
    if one.kind is Kind.READING:
        return one.mu == other.mu and bool(set(_ends(one.letters)) & set(_ends(other.letters)))
    mine, theirs = _rel(one.key), _rel(other.key)
    if mine is None or theirs is None:
        return one.key.partition("_")[0] == other.key.partition("_")[0]  # R_12 and R_32, M and M_0
    if not mine.kind.is_vector:
        return mine.kind is theirs.kind
    return mine.to.point == theirs.to.point and mine.kind.stem[0] == theirs.kind.stem[0]


def _ends(letters: str) -> list[str]:
    """The two letters of a length: bc2 → b, c2; p'c' → p', c'."""
    parts: list[str] = []
    for sign in letters.rpartition(":")[2]:
        if sign.isalpha() or not parts:
            parts.append(sign)
        else:
            parts[-1] += sign
    return [part for part in parts if part.rstrip("'") != "p"]


def _rel(key: str) -> Rel | None:
    try:
        return parse_rel(key)
    except UnknownNameError:
        return None


def _why_zero(one: Graded) -> Message:
    """Why a value that was given is zero."""
    rel = _rel(one.key)
    if rel is not None and not rel.kind.is_vector:
        return message(Told.TRANSLATES, link=rel.to.link)
    return message(Told.ZERO)
