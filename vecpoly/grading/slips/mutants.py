"""What every slip that can be made with a problem makes of every graded quantity."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import Any, assert_never

import numpy as np
from numpy.typing import NDArray
from pydantic import TypeAdapter

from ...answer import bearing
from ...board.hand import scatter
from ...board.otherwise.amended import Amended, Own
from ...board.otherwise.slip import FOUND_AMISS, Mistake, Slip
from ...devices.base import Device
from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...mistakes import slips
from ...problem.problem import Problem
from ..key import AnswerKey, Graded, Kind, beside, come_round
from ..redraw import ByHand, by_hands

TURNING = (Mistake.REVERSED, Mistake.DROPPED, Mistake.TURNED, *FOUND_AMISS)  # by which a motion may turn round
FAR = 1e3  # times the exact value: no paper is so large
SAME = 0.25  # of T: two values nearer than this are one
HANDS = 24  # students who make each mistake, for what its values scatter by


@dataclass(frozen=True, slots=True, kw_only=True)
class Value:
    """A value as it is compared: SI (a reading in mm), of a vector its size; degrees of a vector, where known;
    at: of a place its coordinates.

    sigma: what students' hands that make the mistake scatter by, in the unit of `value`: lines that met well may meet
    badly where one of them is drawn wrongly.
    """

    value: float
    degrees: float | None = None
    at: tuple[float, float] | None = None
    sigma: float = 0.0


@dataclass(frozen=True, slots=True)
class _Work:
    """What an exact hand finds by a mistake: what comes out otherwise, and what it cannot find."""

    values: dict[str, Value]
    lost: frozenset[str] = frozenset()


NO_WORK: tuple[_Work, ByHand] = (_Work({}), {})


@dataclass(frozen=True, slots=True, kw_only=True)
class Mutant:
    """The solution of one who makes this slip: the quantities that come out otherwise than they should.

    also: the slips that give the same numbers throughout, and by these cannot be told from it. lost: the quantities for
    which an exact hand finds nothing, where students scatter as chance has it: the figure does not close.
    """

    slip: Slip
    values: Mapping[str, Value] = field(default_factory=dict)
    lost: frozenset[str] = frozenset()
    also: tuple[Slip, ...] = ()

    def value_of(self, one: Graded) -> Value:
        """What comes out by it: the exact value where it changes nothing."""
        return self.values.get(one.key) or Value(value=one.exact, degrees=one.degrees, at=one.at)

    def leaves_out(self, name: str) -> bool:
        """Whether it is this quantity that is left out: it may be written as 0, as well as right."""
        return any(one.mistake is Mistake.DROPPED and one.key == name for one in (self.slip, *self.also))


def mutants(problem: Problem, key: AnswerKey, of: Sequence[Slip] | None = None) -> tuple[Mutant, ...]:
    """Every slip that changes something and leaves a drawing.

    All in one drawing, each made by a hand of its own, and in another by `HANDS` students; but what `_is_alone` is
    drawn by itself.
    """
    made = tuple(slips(problem) if of is None else of)
    alone = tuple(one for one in made if _is_alone(problem, one))
    together = tuple(one for one in made if one not in alone)
    found = _drawn_together(problem, key, together) if together else {}
    for slip in alone:
        with suppress(VecpolyError):  # nothing can be drawn by this mistake
            found[slip] = _drawn_alone(problem, key, slip)
    each = [
        Mutant(slip=slip, values=work.values, lost=work.lost)
        for slip in made
        if _is_work((work := found.get(slip, NO_WORK)[0]).values)
    ]
    return tuple(_scattered(key, one, found[one.slip][1]) for one in _grouped(key, each))


def _is_work(values: Mapping[str, Value]) -> bool:
    """Whether something comes out otherwise, and not nothing throughout: a polygon whose only known force is left out
    shrinks to a point, which nobody hands in."""
    return any(one.value or one.at for one in values.values())


def _is_alone(problem: Problem, slip: Slip) -> bool:
    """Whether friction follows the senses of a motion that a slip changes, or what is chosen depends on what was drawn,
    as in a design; a figure apart tells nothing to choose by where a device says so."""
    if isinstance(problem.subject, Mechanism):
        return problem.loads is not None and slip.mistake in TURNING
    return not (isinstance(problem.subject, Device) and problem.subject.ends_apart and ":" in slip.key)


def _drawn_alone(problem: Problem, key: AnswerKey, slip: Slip) -> tuple[_Work, ByHand]:
    """The same of one slip. Where a quantity that is computed wrongly lets nothing more be drawn, a right sheet is
    drawn beside it: what was found before is then known. Raises VecpolyError where nothing can be drawn."""
    try:
        by_all = by_hands(problem, key, Amended(slip=slip, own=(Own(),) * HANDS), unsteady=True, nominal=True)
    except VecpolyError:
        if (computed := key.find(slip.key)) is None or computed.kind is Kind.READING:
            raise
        return _drawn_together(problem, key, (slip,))[slip]
    return _changed(key, by_all, 0), {name: values[1:] for name, values in by_all.items()}


def _drawn_together(problem: Problem, key: AnswerKey, made: Sequence[Slip]) -> dict[Slip, tuple[_Work, ByHand]]:
    """Of each slip what comes out otherwise, and what students who make it find."""
    by_all = by_hands(problem, key, Amended(each=tuple(made)))
    by_many = by_hands(problem, key, Amended(each=tuple(made) * HANDS), unsteady=True)
    theirs = [{name: values[i :: len(made)] for name, values in by_many.items()} for i in range(len(made))]
    return {slip: (_changed(key, by_all, i), theirs[i]) for i, slip in enumerate(made)}


def _grouped(key: AnswerKey, each: Sequence[Mutant]) -> tuple[Mutant, ...]:
    """Slips that give the same numbers are one, under the name of the first."""
    firsts: list[Mutant] = []
    for one in each:
        same = next((n for n, first in enumerate(firsts) if _same(key, first, one)), None)
        if same is None:
            firsts.append(one)
        else:
            firsts[same] = replace(firsts[same], also=(*firsts[same].also, one.slip))
    return tuple(firsts)


def _same(key: AnswerKey, first: Mutant, second: Mutant) -> bool:
    """Whether nothing that is graded tells one from the other."""
    if first.values.keys() != second.values.keys():
        return False
    pairs = ((key[name], value, second.values[name]) for name, value in first.values.items())
    return not any(_apart(one, mine, theirs) for one, mine, theirs in pairs)


def alike(key: AnswerKey, first: Mutant, second: Mutant, names: Mapping[str, bool]) -> bool:
    """Whether two mistakes give the same of these quantities. names: of each whether its direction is told."""
    return not any(
        _apart(one, first.value_of(one), second.value_of(one) if told else replace(second.value_of(one), degrees=None))
        for one, told in ((key[name], told) for name, told in names.items())
    )


def _changed(key: AnswerKey, found: ByHand, hand: int) -> _Work:
    """What comes out otherwise, without what rests on a figure that does not close; a step that falls away with the
    mistake, as where two points become one, leaves the others. Nothing, where no paper holds the figure."""
    if any(_off_the_paper(one, found[one.key][hand]) for one in key.quantities if one.key in found):
        return _Work({})
    values: dict[str, Value] = {}
    open_ended = set[str]()
    for one in (each for each in key.quantities if each.key in found):
        value = _value(one, found[one.key][hand])
        if value is None or open_ended.intersection(one.needs):
            open_ended.add(one.key)
        elif _apart(one, value, Value(value=one.exact, degrees=one.degrees, at=one.at)):
            values[one.key] = value
    return _Work(values, frozenset(open_ended))


def _scattered(key: AnswerKey, mutant: Mutant, students: ByHand) -> Mutant:
    values = {name: _among(key[name], value, students.get(name)) for name, value in mutant.values.items()}
    return replace(mutant, values=values)


def _among(one: Graded, value: Value, found: NDArray[Any] | None) -> Value:
    """With the σ of those who close the figure; about their mean, where lines that hardly meet lead all of them to one
    side of what an exact hand finds."""
    if found is None:
        return value
    closed = _compared(one, found[np.isfinite(found)], value.value)
    if not closed.size:
        return value
    mean, sigma = np.mean(closed), scatter(closed)
    aside = one.kind is not Kind.PLACE and abs(mean - value.value) > sigma
    return replace(value, value=float(np.real(mean)) if aside else value.value, sigma=sigma)


def _compared(one: Graded, found: Any, about: float) -> Any:
    """What is held against each other: sizes, signed numbers, places; angles as they lie nearest to one."""
    match one.kind:
        case Kind.VECTOR | Kind.READING:
            return np.abs(found)
        case Kind.SIGNED | Kind.SCALAR | Kind.YES_NO:
            return come_round(np.real(found), about) if one.unit == "deg" else np.real(found)
        case Kind.LINE:
            return beside(np.real(found), one.exact)
        case Kind.PLACE:
            return found
        case _:
            assert_never(one.kind)


def _off_the_paper(one: Graded, found: Any) -> bool:
    return one.kind is Kind.READING and bool(abs(found) > FAR * max(abs(one.exact), one.allowed))


def _value(one: Graded, found: Any) -> Value | None:
    """What a hand found; None where its figure does not close."""
    if not np.isfinite(found) or abs(found) > FAR * max(abs(one.exact), one.allowed):
        return None
    if one.kind is Kind.LINE:
        return Value(value=float(beside(np.real(found), one.exact)))
    if np.iscomplexobj(found) and one.kind is Kind.PLACE:
        return Value(value=float(abs(found)), at=(float(found.real), float(found.imag)))
    if np.iscomplexobj(found) and one.kind is Kind.VECTOR:
        return Value(value=float(abs(found)), degrees=bearing(complex(found)))
    return Value(value=float(abs(found)) if np.iscomplexobj(found) else float(found))


def _apart(one: Graded, first: Value, second: Value) -> bool:
    """Whether two values of a quantity are not the same."""
    if first.at is not None and second.at is not None:
        return abs(complex(*first.at) - complex(*second.at)) > SAME * one.allowed
    if abs(float(_compared(one, first.value, second.value)) - second.value) > SAME * one.allowed:
        return True
    if first.degrees is None or second.degrees is None:
        return False
    return abs((first.degrees - second.degrees + 180) % 360 - 180) > 1.0


@cache
def adapter() -> TypeAdapter[tuple[Mutant, ...]]:
    """To JSON and back, for a register."""
    return TypeAdapter(tuple[Mutant, ...])
