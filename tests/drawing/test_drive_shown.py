"""Where the arrow with ω stands at a driving pivot, and how the angles of the drive are marked."""

from __future__ import annotations

from math import degrees

import numpy as np
import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import AngleMark, FixedGuide, Segment, Slot, TurnArrow
from vecpoly.devices.structure import Structure
from vecpoly.devices.structure_pairs import FRAME

NAMES = ("3-5", "3-8", "3-9", "3-12", "A-27", "class-iii")
CLEAR = 4.0  # mm


@pytest.mark.parametrize("name", NAMES)
def test_the_arrow_of_the_drive_keeps_clear_of_every_line_that_was_there(name: str) -> None:
    (figure,) = (one for one in drawn(name).figures(View.MECHANISM) if not one.name)
    (arrow,) = (mark for mark in figure.marks if isinstance(mark, TurnArrow) and mark.label == "ω_1")
    lines = np.array(
        [
            mark.a + (mark.b - mark.a) * np.linspace(0.0, 1.0, 200)
            for mark in figure.marks[: figure.marks.index(arrow)]
            if isinstance(mark, Segment | FixedGuide | Slot)
        ]
    )
    turns = arrow.start + (1.0 if arrow.ccw else -1.0) * np.linspace(0.0, 1.8, 19)
    places = arrow.at + arrow.radius * np.exp(1j * turns)
    assert np.abs(places[:, None] - lines.ravel()).min() > CLEAR


def test_the_crank_s_angle_is_marked_in_both_limit_positions_as_it_is_read() -> None:
    solution = drawn("3-2").solution
    marked = [m for figure in solution.construction.figures for m in figure.marks if isinstance(m, AngleMark)]
    for key, primes in (("phi_C_extended", "′"), ("phi_C_overlapped", "′′")):
        (mark,) = (m for m in marked if m.label == f"φ_C^{{{primes}}}")
        assert mark.start == 0 and degrees(mark.sweep) == pytest.approx(solution.answers[key].exact, abs=1e-6)


@each(Later(lambda: (name for name in IDS if isinstance(given(name).subject, Structure))))
def test_every_driver_that_is_left_when_all_groups_are_detached_has_its_arrow(name: str) -> None:
    device = given(name).subject
    assert isinstance(device, Structure)
    for figure in drawn(name).construction.figures:
        if figure.name.startswith("left "):
            drivers = figure.name.removeprefix("left ").split("+")
            turning = [one for one in drivers if any(p.hinged and FRAME in p.links for p in device.chain.at(one))]
            assert sum(isinstance(mark, TurnArrow) for mark in figure.marks) == len(turning)
