"""Simulated students: whole classes drawn in one go, each by an own hand, and what each of them writes down."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vecpoly.answer import bearing
from vecpoly.board.hand import EXACT, Hand
from vecpoly.board.hand import hand as hand_of
from vecpoly.board.otherwise.amended import AS_DRAWN, Amended
from vecpoly.grading import redraw
from vecpoly.grading.allowance import STUDENT
from vecpoly.grading.key import AnswerKey, Graded, Kind
from vecpoly.methods.drawn import Drawn
from vecpoly.problem.problem import Problem

SLOPPY = replace(
    hand_of("pencil").repeated, protractor=1.0 * pi / 180, dividers=0.35, square=0.7 * pi / 180, squares=0.5
)
Cells = dict[str, str]


@dataclass(frozen=True, slots=True)
class Class:
    """What each of many students finds: key → value by student (a vector x + iy where it is known)."""

    key: AnswerKey
    found: Mapping[str, NDArray[Any]]
    count: int

    def sheet(self, student: int, rng: np.random.Generator) -> Cells:
        """What one of them writes: lengths to half a millimetre, values to three digits, directions to a degree."""
        cells: Cells = {}
        for one in self.key.quantities:
            if one.key in self.found and (one.asked or one.kind is Kind.READING):
                value = self.found[one.key][student]
                if np.isfinite(value) and (one.kind is not Kind.PLACE or np.iscomplexobj(value)):
                    cells[one.key] = _written(one, value, rng)
        return cells


def drawn_class(
    problem: Problem, key: AnswerKey, skill: str, count: int, seed: int, amended: Amended = AS_DRAWN
) -> Class:
    """So many students of this skill (pencil, student: as the key assumes, sloppy), all with the same mistake where
    there is one.
    """
    known = {"pencil": hand_of("pencil").repeated, "student": STUDENT.hand(0).repeated, "sloppy": SLOPPY}[skill]
    by = Hand("pencil", EXACT, known, count, np.random.Generator(np.random.PCG64(seed)))
    drawn = redraw.drawn_by(redraw.as_keyed(problem, key), by, amended)
    return Class(key, {one.key: _each(drawn, one, count) for one in key.quantities if redraw.act_of(drawn, one)}, count)


def _each(drawn: Drawn, one: Graded, count: int) -> NDArray[Any]:
    act = redraw.act_of(drawn, one)
    assert act is not None
    return np.broadcast_to(redraw.values_of(drawn, act), (count + 1,))[1:]


def _written(one: Graded, value: Any, rng: np.random.Generator) -> str:
    if one.kind is Kind.YES_NO:
        return "yes" if value else "no"
    if one.kind is Kind.PLACE:
        mm = value / one.one
        return f"({mm.real:.4g}, {mm.imag:.4g})" if np.iscomplexobj(value) else f"{mm:.4g}"
    if one.kind is Kind.READING:
        return f"{abs(value):.1f}"
    if one.kind is Kind.SIGNED:
        return f"{abs(value):.3g} {'ccw' if value > 0 else 'cw'}"
    size = f"{abs(value):.3g}" if one.kind is Kind.VECTOR else f"{value.real:.3g}"
    if one.kind is Kind.VECTOR and np.iscomplexobj(value) and abs(value) and rng.random() < 0.5:
        return f"{size} ∠ {bearing(complex(value)):.0f}°"
    return size


def times(cell: str, factor: float) -> str:
    """What was written, by a factor."""
    number, blank, rest = cell.partition(" ")
    return f"{float(number) * factor:.3g}{blank}{rest}"
