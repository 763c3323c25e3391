"""Which slips show in what is written, and which can be told from each other by it."""

from __future__ import annotations

from dataclasses import replace

from tests.grader_proof.judge import Trial
from tests.grader_proof.students import Cells
from vecpoly.board.otherwise.slip import Slip
from vecpoly.grading.key import Graded, Kind
from vecpoly.grading.slips.mutants import Mutant, Value
from vecpoly.grading.slips.whole import mutated

VISIBLE = 2.0  # T: a slip shows where it moves an answer by more


def shows(trial: Trial, mutant: Mutant) -> bool:
    """Whether the mistake moves something that is written by more than the tolerance."""
    for name, value in mutant.values.items():
        one = trial.key[name]
        turned = (
            one.kind is Kind.SIGNED
            and value.value * one.exact < 0
            and min(abs(value.value), abs(one.exact)) > one.allowed
        )
        if turned and (one.asked or one.kind is Kind.READING):
            return True
        if _far(trial, name, value):
            return True
    return False


def as_written(mutant: Mutant, cells: Cells) -> Mutant:
    """What the mistake moves of a sheet: a length that vanishes by it is on nobody's."""
    return replace(mutant, values={name: value for name, value in mutant.values.items() if name in cells})


def distinct(trial: Trial, mutant: Mutant, cells: Cells) -> bool:
    """Whether it can be told from every other, and from right work, by sizes and senses, as those who make it write
    them; and shows in more than one sense. mutant: as far as it moves what is written."""
    sizes = [name for name, value in mutant.values.items() if _far(trial, name, value) and _clear(trial, name, mutant)]
    senses = [
        name
        for name, value in mutant.values.items()
        if trial.key[name].kind is Kind.SIGNED and trial.key[name].asked and value.value * trial.key[name].exact < 0
    ]
    if not sizes and len(senses) < 2:
        return False
    others = [one for one in trial.mutants if one.slip != mutant.slip]
    return not any(alike(trial, one.slip, mutant, cells) or _blurred(trial, one, mutant, cells) for one in others)


def _clear(trial: Trial, name: str, mutant: Mutant) -> bool:
    """Whether those who make the mistake scatter by less than it moves the value: lines may hardly meet."""
    one, rule = trial.key[name], trial.key.allowance
    return _between(one, mutant.values[name], _right(one)) > mutated(one, mutant, rule).allowed


def _blurred(trial: Trial, first: Mutant, second: Mutant, cells: Cells) -> bool:
    """Whether nothing that is written differs by more than what both scatter by."""
    return not any(_apart(trial, one, first, second) for one in trial.key.quantities if one.key in cells)


def _apart(trial: Trial, one: Graded, first: Mutant, second: Mutant) -> bool:
    room = sum(mutated(one, each, trial.key.allowance).allowed for each in (first, second))
    return _between(one, first.value_of(one), second.value_of(one)) > room


def _far(trial: Trial, name: str, value: Value) -> bool:
    one = trial.key[name]
    written = one.asked or one.kind is Kind.READING
    return written and _between(one, value, _right(one)) > VISIBLE * one.allowed


def _right(one: Graded) -> Value:
    return Value(value=one.exact, at=one.at)


def _between(one: Graded, first: Value, second: Value) -> float:
    """How far two values are apart: by size, of places in a straight line."""
    if first.at is not None and second.at is not None:
        return abs(complex(*first.at) - complex(*second.at))
    return abs(abs(first.value) - abs(second.value))


def alike(trial: Trial, slip: Slip, other: Mutant, cells: Cells) -> bool:
    """Whether a named slip is the one, or gives the same sizes on this sheet."""
    if slip == other.slip:
        return True
    mine = next(one for one in trial.mutants if one.slip == slip)
    for one in trial.key.quantities:
        if one.key in cells:
            first, second = mine.value_of(one), other.value_of(one)
            if _between(one, first, second) > 2 * one.allowed:
                return False
    return True
