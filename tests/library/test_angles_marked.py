"""An angle that is marked with a number has it between its sides; what a candidate stands on is among its pins."""

from __future__ import annotations

import re
from itertools import combinations
from math import degrees, pi

import pytest

from tests.drawn_library import IDS, LIBRARY, drawn, given, ids
from tests.each import Later, each
from tests.found import APART
from vecpoly.board.paper.marks import AngleMark, Ground, Point
from vecpoly.designs.base import Design
from vecpoly.designs.limit_lines import LimitLines

NUMBERED = re.compile(r"= *−?(\d+(?:\.(\d+))?)°")
COMPLEMENT, DEGREES = re.compile(r"90° − (\S+)"), re.compile(r"([\d.]+) deg")
NUMBERS = re.compile(r"\^\{\(\d+\)\}")  # of a solution: marked with it, and read without where one was taken
LIMITS = ("8-3a", "8-3b", "8-3c", "8-17", "8-18")  # angles that are read in a given mechanism
DESIGNS = Later(lambda: (name for name in dict.fromkeys((*IDS, *LIMITS)) if isinstance(given(name).subject, Design)))


@each(Later(lambda: dict.fromkeys((*ids(mechanisms=False), *LIMITS, *APART))))
def test_an_angle_with_a_number_is_so_wide(name: str) -> None:
    for mark in angles(name):
        if (told := NUMBERED.search(mark.label)) is not None:
            half = 0.5001 * 10.0 ** -len(told[2] or "")
            assert abs(abs(degrees(mark.sweep)) - float(told[1])) <= half, mark


def test_the_complement_of_a_pressure_angle_is_marked_as_wide_where_the_line_is_produced_backwards_too() -> None:
    """The arc ran to the pivot, 130° under the letters of 50°."""
    marks = [mark for mark in angles("8-5") if mark.label == "90° − α_1"]
    assert [round(abs(degrees(mark.sweep)), 6) for mark in marks] == [50.0, 50.0]
    steps = [step.words.en for step in drawn("8-5").construction.steps]
    assert sum("produced backwards through $C_1$" in one for one in steps) == 1


@each(Later(lambda: (one for one in (*LIBRARY, *APART) if isinstance(given(one).subject, LimitLines))))
def test_an_angle_under_the_letters_of_a_complement_is_that_complement(name: str) -> None:
    told = dict(given(name).design.given())
    marks = [(mark, found[1]) for mark in angles(name) if (found := COMPLEMENT.fullmatch(mark.label))]
    assert marks
    for mark, symbol in marks:
        (size,) = DEGREES.fullmatch(told[symbol]).groups()  # type: ignore[union-attr]
        assert abs(degrees(mark.sweep)) == pytest.approx(90.0 - float(size)), mark


def angles(name: str) -> list[AngleMark]:
    """The angles that are marked in all figures."""
    figures = drawn(name).construction.figures
    return [mark for figure in figures for mark in figure.marks if isinstance(mark, AngleMark)]


@each(Later(lambda: dict.fromkeys((*DESIGNS, "8-7"))))
def test_no_direction_of_a_line_is_marked_twice_on_either_side_of_its_pivot(name: str) -> None:
    for a, b in combinations(angles(name), 2):
        if abs(a.at - b.at) < 1e-6 and abs(a.start - b.start) < 1e-6:
            assert abs(abs(a.sweep - b.sweep) - pi) > 1e-6, (a.label, b.label)


@each(DESIGNS)
def test_an_angle_that_was_read_of_a_linkage_is_marked_under_its_key(name: str) -> None:
    """γ_min apart: it is the smaller of two that are marked."""
    found = {NUMBERS.sub("", one.symbol): unnumbered(key) for key, one in drawn(name).construction.readings.items()}
    told = set[str]()
    for mark in angles(name):
        symbols = (NUMBERS.sub("", one) for one in mark.label.split(" = ")[:-1])
        keys = {found[symbol] for symbol in symbols if symbol in found}
        assert not keys or unnumbered(mark.key) in keys, mark
        told |= keys
    assert {*found.values()} & {"theta", "psi", "alpha_max"} <= told


def unnumbered(key: str) -> str:
    """Without the number of the solution."""
    return re.sub(r"_\d+$", "", key)


@each(Later(lambda: (name for name in ids(mechanisms=False) if drawn(name).construction.candidates)))
def test_every_ground_on_the_sheet_is_that_of_a_pivot_of_a_candidate(name: str) -> None:
    construction = drawn(name).construction
    pins = [at for one in construction.candidates for at in one.pins.values()]
    for mark in (one for one in construction.figures[0].marks if isinstance(one, Ground)):
        assert any(abs(mark.at - at) < 1e-6 for at in pins), mark


@each(Later(lambda: (name for name in dict.fromkeys((*IDS, *LIMITS)) if drawn(name).construction.candidates)))
def test_every_pin_of_a_candidate_has_a_place_of_its_own_with_a_letter_on_the_sheet(name: str) -> None:
    construction = drawn(name).construction
    lettered = [mark.at for mark in construction.figures[0].marks if isinstance(mark, Point) and mark.label]
    for pins in ([*one.pins.values()] for one in construction.candidates):
        assert all(any(abs(at - other) < 1e-6 for other in lettered) for at in pins)
        assert all(abs(at - other) > 1e-3 for at, other in combinations(pins, 2))
