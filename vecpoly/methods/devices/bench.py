"""What a device's construction works on: a board, and the answers found so far. Lengths on paper are in mm."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...algebra.formula import Node, Row, Txt
from ...algebra.formula import named as name_of
from ...algebra.quantity import Expr, Quantity, Sum, magnitude
from ...algebra.worked import stated, worked
from ...board.board import NO_LENGTH, Board
from ...board.construction import LineOfAction, Place, Reading, Scale
from ...board.otherwise.slip import Chance
from ...board.said.protractor import degrees_told
from ...foundation.slotted import replace
from ...names import Named, ascii_key
from ...plane import Points, Reals, nominal
from ...plane.traced import acts_of, traced
from ...words import Words

NO_SCALE = Scale(symbol="", value=1.0, unit="")  # of a sketch and of a block diagram


def trial_board(board: Board, *, like: Place | None = None) -> Board:
    """Scratch paper on which something is tried; like: the figure that is tried on it, with the mistake that is made
    there."""
    trial = board.scratch(as_made=like is not None)
    trial.step(Words("试作", "trial"), like)
    return trial


@dataclass(slots=True)
class Bench:
    """The state of one solution of a device."""

    board: Board

    def measured(
        self,
        named: Named,
        place: Place,
        start: Points,
        end: Points,
        letters: str,
        acts: LineOfAction | None = None,
        told: bool = True,
    ) -> Quantity:
        """Read a vector off a polygon: its length × μ, its direction by protractor;
        written into the step as a formula where it is told."""
        board, scale = self.board, self.board.scale_of(place)
        on_paper = board.measure(start, end, letters)
        size = on_paper.value * scale.value
        formula = worked(name_of(named.symbol), board.mu(place) * on_paper, named.unit)
        each: Points | None = None
        if named.is_vector:
            zero = abs(complex(nominal(end - start))) < NO_LENGTH
            each = 0j * size if zero else size * np.exp(1j * board.gauge(start, end))
        if told:
            board.write(formula)
        self._keep(
            Reading(
                key=named.key,
                symbol=named.symbol,
                unit=named.unit,
                scalar=float(nominal(size)),
                vector=None if each is None else complex(nominal(each)),
                mm=float(nominal(on_paper.value)),
                line=letters,
                scale=scale.symbol,
                formula=formula,
                acts=acts,
            ),
            size,
            each,
        )
        return magnitude(named.symbol, size, named.unit)

    def laid(
        self, named: Named, expr: Expr, ends: tuple[Points, Points], letters: str, acts: LineOfAction | None = None
    ) -> None:
        """Keep a vector that a line of the step worked out and that was then laid off: its size as it was worked out,
        its direction by protractor."""
        size, each = expr.value, expr.value * np.exp(1j * self.board.gauge(*ends))
        self._keep(
            Reading(
                key=named.key,
                symbol=named.symbol,
                unit=named.unit,
                scalar=float(nominal(size)),
                vector=complex(nominal(each)),
                line=letters,
                formula=worked(name_of(named.symbol), expr, named.unit),
                acts=acts,
            ),
            size,
            each,
        )

    def worked(self, named: Named, expr: Expr, sense: int = 1) -> Quantity:
        """Compute a quantity from others; written into the step as symbol = formula = numbers = result.

        sense: how it turns, where the line gives its size alone.
        """
        size = self.board.formula(named.symbol, expr, named.unit)
        return self._computed(named, expr, size if sense == 1 else replace(size, value=sense * size.value))

    def divided(self, named: tuple[Named, Named], parts: tuple[Expr, Expr]) -> tuple[Quantity, Quantity]:
        """Compute the two shares of a quantity; a reader may take each for the other."""
        (one, other), (first, second) = named, parts
        shares = self.board.divide((one.symbol, other.symbol), parts, one.unit)
        return self._computed(one, first, shares[0]), self._computed(other, second, shares[1])

    def _computed(self, named: Named, expr: Expr, result: Quantity) -> Quantity:
        self._keep(
            Reading(
                key=named.key,
                symbol=named.symbol,
                unit=named.unit,
                scalar=float(nominal(result.value)),
                formula=worked(name_of(named.symbol), expr, named.unit),
            ),
            result.value,
        )
        return result

    def read_off(
        self, named: Named, place: Place, on_paper: Quantity, letters: str, scale: Scale | None = None, factor: str = ""
    ) -> None:
        """Note the length on paper from which a quantity was computed. scale: of an axis with its own."""
        mm, mu = float(nominal(on_paper.value)), (scale or self.board.scale_of(place)).symbol
        self.board.revise(replace(self.board.readings[named.key], mm=mm, line=letters, scale=mu, factor=factor))

    def stated(self, named: Named, value: Reals, formula: Node | None = None) -> Quantity:
        """Keep a value found in another way: by formula given here, or as it stands."""
        result = magnitude(named.symbol, value, named.unit)
        node = formula if formula is not None else self._line(result)
        self.board.write(node)
        self._keep(
            Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(value)), formula=node),
            value,
        )
        return result

    def _line(self, result: Quantity) -> Row:
        """symbol = value with unit; of an angle off the protractor with its tenth."""
        if result.unit != "deg":
            return stated(result)
        return Row((result.node, Txt(f" = {degrees_told(self.board.acts, result.value)}°")))

    def told_otherwise(self, named: Named, quantity: Quantity) -> Quantity:
        """Keep a quantity that has a line already, under another name, or that is given."""
        size = float(nominal(quantity.value))
        self._keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=size), quantity.value)
        return quantity

    def counted(self, named: Named, value: float, otherwise: Mapping[Chance, float]) -> Quantity:
        """Keep a number that was counted, and what others make of it who count wrongly."""
        board, key = self.board, ascii_key(named.symbol)
        slipped = ((hand, Chance(slip.mistake, slip.instead)) for hand, slip in board.amended.wrong(board.here, key))
        wrong = [(hand, otherwise[chance]) for hand, chance in slipped if chance in otherwise]
        return self.stated(
            named, board.conclude(key, board.amended.altered(value, wrong), named.unit, chances=tuple(otherwise))
        )

    def judged(self, named: Named, yes: Reals, remark: Words, *by: Points | Reals) -> None:
        """Keep the answer to a question, 1 yes and 0 no, and what it was judged by; the sentence that answers it goes
        into the step."""
        self.board.remark(remark)
        value = traced(np.where(yes, 1.0, 0.0), acts_of(*by))
        self._keep(
            Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(value)), remark=remark),
            value,
        )

    def _keep(self, reading: Reading, values: Reals, each: Points | None = None) -> None:
        self.board.keep(reading, values, each)


def with_sign(expr: Expr, sign: float) -> Expr:
    """The expression, or what is opposite to it: of what lies the other way the minus stands before all, for a scale is
    positive."""
    return expr if sign > 0 else Sum((expr,), (-1,))
