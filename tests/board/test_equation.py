"""The vector equation checks itself and every one of its four cases closes."""

from __future__ import annotations

import cmath
from math import pi

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vecpoly.board.board import Board
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Vector
from vecpoly.errors import DeadPointError, EquationError, EquilibriumError
from vecpoly.figures import views
from vecpoly.names import At, Key, Kind, Named, Rel, reaction
from vecpoly.vector.close import close
from vecpoly.vector.equation import KNOWN, UNKNOWN, Equation, Term

SCALES = {v: Scale(symbol="μ", value=1.0, unit="m") for v in views()}
B, C = At("B"), At("C")
angles = st.floats(-pi, pi)
sizes = st.floats(5.0, 100.0)


def board() -> Board:
    it = Board(hand("exact"), SCALES)
    it.step(UNKNOWN)
    return it


def term(rel: Key, **known: object) -> Term:
    return Term(rel=rel, symbol=rel.key, direction=KNOWN, magnitude="?", **known)  # type: ignore[arg-type]


V_B, V_CB, V_C = Rel(Kind.V, B), Rel(Kind.V, C, B), Rel(Kind.V, C)


@given(sizes, angles, angles, angles)
def test_two_unknown_magnitudes_close_where_two_lines_meet(size: float, known: float, one: float, two: float) -> None:
    assume(abs(np.sin(one - two)) > 0.05)
    eq = Equation(
        left=(term(V_C, along=cmath.rect(1, one)),),
        right=(term(V_B, vector=cmath.rect(size, known)), term(V_CB, along=cmath.rect(1, two))),
    )
    ends = close(board(), View.VELOCITY, 0j, eq).ends
    assert np.abs(ends["v_C"][1] - ends["v_CB"][1]) < 1e-9
    assert ends["v_CB"][0] == pytest.approx(cmath.rect(size, known))
    assert np.abs((ends["v_C"][1] * cmath.rect(1, -one)).imag) < 1e-7


@given(sizes, angles, sizes, angles)
def test_one_wholly_unknown_vector_is_the_closing_side(size: float, a: float, other: float, b: float) -> None:
    eq = Equation(
        left=(term(V_C),), right=(term(V_B, vector=cmath.rect(size, a)), term(V_CB, along=cmath.rect(1, b), mm=other))
    )
    closed = close(board(), View.VELOCITY, 0j, eq)
    assert closed.ends["v_C"][1] == pytest.approx(cmath.rect(size, a) + cmath.rect(other, b))


@given(sizes, angles, sizes, sizes)
def test_two_unknown_directions_close_where_two_arcs_meet(size: float, a: float, one: float, two: float) -> None:
    assume(abs(one - two) + 1 < size < one + two - 1)
    eq = Equation(left=(term(V_C, mm=one),), right=(term(V_B, vector=cmath.rect(size, a)), term(V_CB, mm=two)))
    ends = close(board(), View.VELOCITY, 0j, eq).ends
    assert abs(ends["v_C"][1]) == pytest.approx(one)
    assert abs(ends["v_CB"][1] - ends["v_CB"][0]) == pytest.approx(two)
    assert ends["v_C"][1] == pytest.approx(ends["v_CB"][1])


@given(sizes, angles, angles, sizes)
def test_a_direction_and_a_magnitude_close_where_line_and_arc_meet(
    size: float, a: float, b: float, length: float
) -> None:
    offset = abs(size * np.sin(a - b))
    assume(offset < length - 1)
    eq = Equation(
        left=(term(V_C, along=cmath.rect(1, b)),), right=(term(V_B, vector=cmath.rect(size, a)), term(V_CB, mm=length))
    )
    ends = close(board(), View.VELOCITY, 0j, eq).ends
    assert abs(ends["v_CB"][1] - ends["v_CB"][0]) == pytest.approx(length)
    assert np.abs((ends["v_C"][1] * cmath.rect(1, -b)).imag) < 1e-6


@given(sizes, angles, angles, angles)
def test_two_unknowns_at_the_end_of_one_side_close_on_the_other_side(
    size: float, a: float, one: float, two: float
) -> None:
    assume(abs(np.sin(one - two)) > 0.05)
    d = Rel(Kind.V, At("D"), C)
    eq = Equation(
        left=(term(Rel(Kind.V, At("D")), vector=cmath.rect(size, a)),),
        right=(term(V_C, along=cmath.rect(1, one)), term(d, along=cmath.rect(1, two))),
    )
    ends = close(board(), View.VELOCITY, 0j, eq).ends
    assert ends["v_DC"][1] == pytest.approx(cmath.rect(size, a))
    assert ends["v_C"][1] == pytest.approx(ends["v_DC"][0])


def test_parallel_direction_lines_are_a_dead_point() -> None:
    eq = Equation(left=(term(V_C, along=1 + 0j),), right=(term(V_B, vector=10j), term(V_CB, along=-1 + 0j)))
    with pytest.raises(DeadPointError, match="parallel"):
        close(board(), View.VELOCITY, 0j, eq)


def test_three_unknowns_are_refused() -> None:
    with pytest.raises(EquationError, match="exactly two"):
        Equation(left=(term(V_C),), right=(term(V_B, vector=10j), term(V_CB, along=1j)))


def test_a_relative_vector_must_start_where_the_sum_has_arrived() -> None:
    with pytest.raises(EquationError, match="starts at B"):
        Equation(left=(term(V_C, along=1j),), right=(term(V_CB, along=1 + 0j),))


def test_both_sides_must_end_at_one_point() -> None:
    with pytest.raises(EquationError, match="different points"):
        Equation(left=(term(V_C),), right=(term(V_B, vector=1j),))


def test_the_table_has_a_direction_and_a_magnitude_for_every_term() -> None:
    eq = Equation(left=(term(V_C, along=1j),), right=(term(V_B, vector=1 + 0j), term(V_CB, along=1 + 0j)), total="v_D")
    table = eq.table()
    assert table.symbols == ("v_D", "v_C", "v_B", "v_CB")
    assert table.signs == ("", "=", "=", "+")
    assert len(table.directions) == len(table.magnitudes) == 4


Q, R12, R32 = Named("Q", "Q", "N"), reaction("1", "2"), reaction("3", "2")


def force(named: Named, **known: object) -> Term:
    return Term(rel=named, symbol=named.symbol, direction=KNOWN, magnitude="?", **known)  # type: ignore[arg-type]


def test_forces_in_equilibrium_print_as_a_sum_that_is_zero() -> None:
    eq = Equation(left=(force(R12, along=1j), force(R32, along=1 + 0j), force(Q, along=-1j, mm=10.0)))
    assert str(eq) == "R_12 + R_32 + Q = 0"
    table = eq.table()
    assert table.symbols == ("R_{12}", "R_{32}", "Q", "0")
    assert table.signs == ("", "+", "+", "=")
    assert len(table.directions) == len(table.magnitudes) == 4


@given(sizes, angles, angles, angles)
def test_a_sum_of_forces_closes_at_its_start(size: float, known: float, one: float, two: float) -> None:
    assume(abs(np.sin(one - two)) > 0.05)
    eq = Equation(
        left=(
            force(Q, along=cmath.rect(1, known), mm=size),
            force(R32, along=cmath.rect(1, one)),
            force(R12, along=cmath.rect(1, two)),
        )
    )
    ends = close(board(), View.FORCE, 3 + 4j, eq).ends
    assert ends["Q"][0] == ends["R_12"][1] == 3 + 4j
    assert (ends["Q"][1], ends["R_32"][1]) == (ends["R_32"][0], ends["R_12"][0])
    assert np.abs(sum(b - a for a, b in ends.values())) < 1e-9 * size
    assert all(
        np.abs(((ends[key][1] - ends[key][0]) * cmath.rect(1, -way)).imag) < 1e-7
        for key, way in (("R_32", one), ("R_12", two))
    )


@given(sizes, angles, sizes, angles)
def test_one_force_unknown_altogether_closes_the_sum(size: float, a: float, other: float, b: float) -> None:
    eq = Equation(left=(force(Q, vector=cmath.rect(size, a)), force(R32, along=cmath.rect(1, b), mm=other), force(R12)))
    start, end = close(board(), View.FORCE, 0j, eq).ends["R_12"]
    assert end == 0
    assert start == pytest.approx(cmath.rect(size, a) + cmath.rect(other, b))


def test_forces_carry_their_symbols_and_one_that_is_drawn_is_not_drawn_again() -> None:
    eq = Equation(left=(force(Q, vector=-30j, drawn=True), force(R32, along=1 + 0j), force(R12, along=1 + 1j)))
    sheet = board()
    close(sheet, View.FORCE, 0j, eq)
    assert [mark.label for mark in sheet.marks(View.FORCE) if isinstance(mark, Vector)] == ["R_{32}", "R_{12}"]


def test_forces_on_parallel_lines_are_in_no_equilibrium() -> None:
    eq = Equation(left=(force(Q, along=-1j, mm=10.0), force(R32, along=1 + 0j), force(R12, along=-1 + 0j)))
    with pytest.raises(EquilibriumError, match=r"Q \+ R_32 \+ R_12 = 0.*parallel"):
        close(board(), View.FORCE, 0j, eq)


def test_a_sum_of_forces_needs_exactly_two_unknowns() -> None:
    with pytest.raises(EquationError, match="has 1"):
        Equation(left=(force(Q, along=-1j, mm=10.0), force(R32, along=1 + 0j)))


def test_velocities_without_a_right_side_are_no_equation() -> None:
    with pytest.raises(EquationError, match="empty side"):
        Equation(left=(term(V_C),))
