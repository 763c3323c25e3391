"""An area is measured on paper: by squares or planimeter, with the scatter of each, and can be somebody's own."""

from __future__ import annotations

import cmath
from math import pi, sqrt

import numpy as np
import numpy.typing as npt
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.board.acts import Area, Judge, Way
from vecpoly.board.board import Board
from vecpoly.board.construction import Scale
from vecpoly.board.hand import hand
from vecpoly.board.otherwise.amended import AS_DRAWN, Amended
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.board.paper.marks import Hatched
from vecpoly.figures import view_named
from vecpoly.foundation.frozen import FrozenMap
from vecpoly.methods.diagrams.lobes import middle_of
from vecpoly.plane import Reals, around, nominal, shoelace
from vecpoly.plane.traced import bare
from vecpoly.words import Words

TORQUE = view_named("torque")
SQUARE = (0j, 40 + 0j, 40 + 30j, 30j)
SCALES = {TORQUE: Scale.of(TORQUE, 5.0, 0.05)}


def board(by: str = "exact", repeats: int = 0, amended: Amended = AS_DRAWN, seed: int = 0) -> Board:
    made = Board(hand(by, repeats=repeats, seed=seed), SCALES, amended)
    made.step(Words.same(""), TORQUE)
    return made


def hands(found: Reals) -> npt.NDArray[np.float64]:
    return np.asarray(bare(found), dtype=float)


@given(st.floats(1, 200), st.floats(1, 100), st.floats(-3, 3), st.floats(-pi, pi))
def test_the_area_of_a_trapezium_is_found_wherever_it_stands(
    width: float, high: float, lean: float, turn: float
) -> None:
    outline = [
        np.exp(1j * turn) * corner + 3 - 2j
        for corner in (0, width, width + lean * high + 1j * high, lean * high + 1j * high)
    ]
    assert float(shoelace(outline)) == pytest.approx(width * high)
    assert float(shoelace(outline[::-1])) == pytest.approx(-width * high)


def test_an_exact_hand_reads_what_is_there_whichever_way_round() -> None:
    assert board().area(TORQUE, SQUARE, "A_1").value == board().area(TORQUE, SQUARE[::-1], "A_1").value == 1200


def test_a_careful_hand_counts_whole_squares_and_a_planimeter_reads_tens() -> None:
    odd = (0j, 40 + 0j, 40 + 30.37j, 30.37j)
    assert nominal(board("drafting").area(TORQUE, odd, "A_1").value) == pytest.approx(1215.0)
    assert nominal(board("drafting").area(TORQUE, odd, "A_1", Way.PLANIMETER).value) == pytest.approx(1210.0)


@pytest.mark.parametrize("by", ["drafting", "pencil"])
def test_counted_squares_scatter_by_the_root_of_the_perimeter(by: str) -> None:
    found = hands(board(by, 4000).area(TORQUE, SQUARE, "A_1").value)[1:]
    assert float(around(SQUARE)) == 140
    assert float(np.std(found)) == pytest.approx(0.3 * sqrt(140), rel=0.06)
    assert float(np.mean(found)) == pytest.approx(1200, abs=0.3)


def test_a_planimeter_is_off_by_ten_at_most() -> None:
    outline = (0j, 40 + 0j, 40 + 30.1j, 30.1j)
    found = hands(board("pencil", 2000).area(TORQUE, outline, "A_1", Way.PLANIMETER).value)
    assert 5 < float(np.max(np.abs(found - 1204))) <= 10


def test_no_area_is_less_than_nothing() -> None:
    thin = (0j, 40 + 0j, 40 + 0.01j, 0.01j)
    assert float(np.min(hands(board("pencil", 500).area(TORQUE, thin, "A_1").value))) == 0


def test_the_act_knows_its_outline_and_its_corners() -> None:
    sheet = board()
    corner = sheet.locate(TORQUE, "a", 40 + 30j)
    sheet.area(TORQUE, (0j, 40 + 0j, corner, 30j), "A_1", Way.PLANIMETER)
    act = sheet.acts[-1]
    assert isinstance(act, Area) and act.key == "A1" and act.way is Way.PLANIMETER
    assert act.outline == SQUARE and act.mm2 == 1200 and act.inputs == (0,)


@pytest.mark.parametrize("key", ["A1", "torque:A1"])
def test_somebodys_own_area_is_gone_on_with(key: str) -> None:
    own = Amended(readings=FrozenMap({key: 1180.0}))
    assert float(board(amended=own).area(TORQUE, SQUARE, "A_1").value) == 1180


def test_a_hatched_area_leaves_its_mark() -> None:
    sheet = board()
    sheet.hatch(TORQUE, SQUARE, rising=False)
    (mark,) = sheet.marks(TORQUE)
    assert isinstance(mark, Hatched) and mark.points == SQUARE and not mark.rising


@pytest.mark.parametrize("crosses", [True, False])
def test_who_counts_a_touch_as_a_crossing_goes_on_with_the_wrong_sign(crosses: bool) -> None:
    wrong = Amended(slip=Slip(Mistake.COUNTED, "c"))
    taken = [float(board(amended=how).judged(TORQUE, "c", crosses=crosses)) for how in (AS_DRAWN, wrong)]
    assert taken == ([-1, -1] if crosses else [1, -1])
    sheet = board()
    sheet.judged(TORQUE, "c", crosses=crosses)
    assert isinstance(sheet.acts[-1], Judge) and sheet.acts[-1].crosses is crosses


OUTLINES = {
    "a bar": [0j, 40 + 0j, 40 + 20j, 20j],
    "a triangle": [0j, 30 + 0j, 15 + 26j],
    "an L": [0j, 60 + 0j, 60 + 6j, 14 + 6j, 14 + 40j, 40j],
    "a comb": [0j, 50 + 0j, 50 + 30j, 40 + 30j, 40 + 5j, 30 + 5j, 30 + 30j, 20 + 30j, 20 + 5j, 12 + 5j, 12 + 30j, 30j],
}


@pytest.mark.parametrize("name", OUTLINES)
@pytest.mark.parametrize("size", [0.2, 1.0, 3.0])
def test_the_letter_of_an_area_stands_where_there_is_most_room(name: str, size: float) -> None:
    outline = [corner * size * cmath.rect(1.0, 0.3) for corner in OUTLINES[name]]
    area, at = shapely.Polygon([(z.real, z.imag) for z in outline]), middle_of(outline)
    spot = shapely.Point(at.real, at.imag)
    widest = shapely.maximum_inscribed_circle(area).length  # its radius
    assert area.contains(spot) and area.exterior.distance(spot) > 0.75 * widest
