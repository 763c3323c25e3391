"""Speeds that are given in turns a minute, as angular velocities."""

from __future__ import annotations

from math import pi

from ...algebra.formula import Txt
from ...algebra.quantity import Expr, Quantity, magnitude
from ...board.board import Board
from ...board.otherwise.slip import Chance, Mistake
from ...plane import Reals, nominal

PI, THIRTY = Quantity(Txt("π"), pi, ""), Quantity(Txt("30"), 30.0, "")


def turns_a_minute(symbol: str, rate: float) -> Quantity:
    """n of a rate (rad/s), in r/min."""
    return magnitude(symbol, rate * 30 / pi, "r/min")


def of_turns(symbol: str, rate: Reals) -> Expr:
    """π n / 30, of the speed n (r/min) at this rate (rad/s), which is called so."""
    return PI * turns_a_minute(symbol, float(nominal(rate))) / THIRTY


def angular_velocity(board: Board, symbol: str, rate: float) -> Quantity:
    """ω = π n / 30, of the speed n (r/min) at this rate (rad/s)."""
    return board.compute(symbol, of_turns("n", rate), "rad/s", chances=(Chance(Mistake.PER_MINUTE),))
