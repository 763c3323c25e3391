"""The board: a hand's acts on an emulated sheet, done at once and recorded for ever.

The board knows paper, rule, compass and set square; it knows nothing of mechanisms. A method gets its numbers only by
laying off, meeting, measuring and computing here; what it gets knows the act that gave it (`plane.traced`), so that the
next act knows what it needed. It is the one mutable object of the program, while it is drawn on.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import cast

import numpy as np

from ..algebra.formula import Node, letters_node, plain
from ..algebra.quantity import Expr, Quantity, magnitude, paper
from ..algebra.worked import worked
from ..names import ascii_key
from ..plane import Points, Reals, around, nominal, shoelace
from ..plane.derived import variable
from ..plane.traced import Acts, acts_of, traced
from ..words import Words
from . import acts as done
from .acts import Way
from .compass import Compass
from .construction import EquationTable, Listing, Reading, Scale
from .hand import Hand
from .hand import hand as hand_of
from .otherwise.amended import AS_DRAWN, Amended, plain_letters
from .otherwise.formulas import wrongly
from .otherwise.slip import Chance, Mistake
from .otherwise.wrongly import FACTOR
from .place import Place, View
from .ruler import Ruler
from .said.short import laid
from .said.unreadable import unreadable
from .strokes import NO_ARROW, NO_LENGTH, amount, spot

__all__ = ["NO_ARROW", "NO_LENGTH", "Board", "Scratch", "Unwritten", "letters_node", "spot"]


class Board(Compass):
    """One sheet under one hand (and its repetitions), drawn as the hand would, or with amendments."""

    writes = True  # whether lines are worked out in its steps

    def __init__(
        self,
        hand: Hand,
        scales: Mapping[View, Scale] | Mapping[Place, Scale],
        amended: Amended = AS_DRAWN,
        *,
        recorded: bool = False,
    ) -> None:
        super().__init__(hand, scales, amended)
        self.recorded = recorded  # whether the numbers of its acts know how they were computed
        self._ruler = Ruler(hand)

    @property
    def readings(self) -> Mapping[str, Reading]:
        """What was found of the quantities: each in one place, as it is read."""
        return self.ledger.readings

    @property
    def found(self) -> Mapping[str, Reals]:
        """The same by every hand."""
        return self.ledger.found

    def scratch(self, scales: Mapping[View, Scale] | None = None, *, as_made: bool = False) -> Board:
        """Scratch paper for an exact hand, as_made: one that makes the sheet's mistake; its acts are not remembered,
        and what it gives came from where its inputs came from."""
        over = Scratch(hand_of("exact"), scales or self.scales, Amended(slip=self.amended.slip if as_made else None))
        over.ledger = self.ledger.below()
        return over

    def given(self, value: float, name: str) -> Reals:
        """What the problem gives and may be changed: on a recorded sheet a variable of this name."""
        return cast("float", variable(value, name)) if self.recorded else self.in_each(value, name)

    # -- measuring and computing --------------------------------------------------------------------------------

    def measure(self, a: Points, b: Points, letters: str) -> Quantity:
        """Read a length off the rule (mm): here, and only here, rounding happens.
        A segment is read once, from either end."""
        mm = self._ruler.length(a, b, lambda read: self._measured(read, a, b, letters))
        return paper(letters_node(letters), mm)

    def _measured(self, read: Reals, a: Points, b: Points, letters: str) -> Reals:
        known = [self.acts[n] for n in sorted(acts_of(a, b)) if n < len(self.acts)]  # scratch paper remembers none
        places = [act.head.place for act in reversed(known) if act.head.place is not None]
        place = places[0] if places else None
        self.weigh(letters, abs(spot(b - a)), place if len(set(places)) == 1 else None)
        mm = self.amended.reading(place, letters, read)
        key = plain_letters(letters)
        act = done.Measure(head=self.head(a, b, on=place, key=key), a=spot(a), b=spot(b), mm=amount(mm))
        return self.gave(mm, act)

    def area(
        self,
        view: Place,
        outline: Sequence[Points],
        symbol: str,
        way: Way = Way.SQUARES,
        *,
        curved: Reals | None = None,
    ) -> Quantity:
        """Measure the area within an outline (mm²) by counting squares, or with a planimeter; never less than 0.

        curved: what lies within, where part of the outline is a smooth curve, of which only some points are told.
        """
        straight = shoelace(outline)
        size = straight * np.sign(nominal(straight)) if curved is None else curved
        read = self.hand.count(size, around(outline)) if way is Way.SQUARES else self.hand.roll(size)
        key = plain_letters(symbol)
        mm2 = self.amended.value(view, key, self.amended.reading(view, key, np.maximum(read, 0.0)))
        corners = tuple(spot(corner) for corner in outline)
        act = done.Area(head=self.head(tuple(outline), on=view, key=key), outline=corners, way=way, mm2=amount(mm2))
        return magnitude(symbol, self.gave(mm2, act), "mm^2")

    def bearing(self, a: Points, b: Points) -> Points:
        """The direction from a to b read off the protractor, as a unit vector;
        a segment is read once, from either end."""
        return self._ruler.bearing(a, b, lambda read: traced(read, self._gauged(a, b, np.angle(nominal(read)))))

    def gauge(self, a: Points, b: Points) -> Reals:
        """The angle of the direction from a to b as the protractor shows it (rad)."""
        read = self.hand.gauge(np.angle(b - a))
        return traced(read, self._gauged(a, b, read))

    def _gauged(self, a: Points, b: Points, angle: Reals) -> Acts:
        return self.log(done.Gauge(head=self.head(a, b), angle=amount(angle)))

    def coordinates(self, at: Points, letter: str, on: Place | None = None) -> Points:
        """How far a point lies to the right of the origin and above it, both read off the rule (mm); on: the figure on
        which it lies, where it is not that of the step."""
        read = self.hand.read(at.real) + 1j * self.hand.read(at.imag)
        act = done.Measure(head=self.head(at, on=on, key=plain_letters(letter)), a=0j, b=spot(at), mm=abs(spot(read)))
        return traced(read, self.log(act))

    def keep(self, reading: Reading, value: Reals, each: Points | None = None) -> None:
        """Keep an answer, as it is read and by every hand; each: of a place both coordinates by every hand."""
        self.ledger.readings[reading.key], self.ledger.found[reading.key] = reading, value
        read = reading.scalar if reading.vector is None else reading.vector
        self.answer(reading.key, read, reading.unit, value, each=value if each is None else each)

    def revise(self, reading: Reading) -> None:
        """Say more of an answer that was kept: a remark, the length on paper, where it acts."""
        assert reading.key in self.readings
        self.ledger.readings[reading.key] = reading

    def answer(self, key: str, value: complex, unit: str, *found: Points | Reals, each: Points | Reals) -> None:
        """Write down what was found of a quantity (SI), and from what; each: the same by every hand."""
        self.gave(each, done.Answer(head=self.head(*found, key=key), value=value, unit=unit))

    def conclude(self, key: str, value: Reals, unit: str, *, chances: tuple[Chance, ...] = ()) -> Reals:
        """A value follows from others (SI): ω of a link, with its sense;
        goes on with somebody's own where there is one."""
        value = self.amended.value(self.here, key, value)
        head = self.head(value, key=key)
        return self.gave(value, done.Compute(head=head, value=amount(value), unit=unit, chances=chances))

    def divide(self, symbols: tuple[str, str], parts: tuple[Expr, Expr], unit_text: str) -> tuple[Quantity, Quantity]:
        """Write the two shares of a quantity into the step; somebody may take each of them for the other."""
        one, other = (ascii_key(symbol) for symbol in symbols)
        hands = [hand for hand, slip in self.amended.wrong(self.here, one) if slip.mistake is Mistake.SWAPPED]
        swapped = [[(hand, rest.value) for hand in hands] for rest in reversed(parts)]
        chance = Chance(Mistake.SWAPPED, other)
        first = self.compute(symbols[0], parts[0], unit_text, swapped[0], chances=(chance,))
        return first, self.compute(symbols[1], parts[1], unit_text, swapped[1])

    def formula(self, symbol: str, expr: Expr, unit_text: str) -> Quantity:
        """The same of a formula that is worked, not read: somebody may mistake one thing in it."""
        chances, others = wrongly(expr, self.amended.wrong(self.here, ascii_key(symbol)))
        return self.compute(symbol, expr, unit_text, others, chances=chances)

    def compute(
        self,
        symbol: str,
        expr: Expr,
        unit_text: str,
        others: Sequence[tuple[int | None, Reals]] = (),
        *,
        chances: tuple[Chance, ...] = (),
    ) -> Quantity:
        """Write symbol = formula = numbers = result into the step and go on with the result;
        NotAskedError where it is 0/0.

        others: the hands that go on with another value; chances: what may be done wrongly with it.
        """
        key = ascii_key(symbol)
        wrong = [
            (hand, FACTOR[slip.mistake]) for hand, slip in self.amended.wrong(self.here, key) if slip.mistake in FACTOR
        ]
        factors = [(hand, factor * expr.value) for hand, factor in wrong]
        value = self.amended.altered(expr.value, [*factors, *others])
        if not np.isfinite(nominal(value)):
            raise unreadable(symbol)
        if wrong:
            self._slipped.add(key)
        result = magnitude(symbol, self.conclude(key, value, unit_text, chances=chances), unit_text)
        self.write_worked(result.node, expr, unit_text)
        self.ledger.sizes[key] = result
        return result

    def given_size(self, symbol: str, value: Reals, unit_text: str) -> Quantity:
        """The size of a vector as the problem gives it."""
        size = self.ledger.sizes[ascii_key(symbol)] = magnitude(symbol, value, unit_text)
        return size

    def write_length(self, view: Place, letters: str, quantity: Quantity) -> None:
        """Write how long a quantity becomes on paper: pb = v_B / μ_v = 50 mm; it was needed when it was laid off."""
        if not self.writes:
            return
        mm, name = float(nominal(self.to_paper(view, quantity.value))), paper(letters_node(letters), 0.0).node
        line = worked(name, quantity / self.mu(view), "mm", laid(mm))
        self.write(line, when=self.laid_off(ascii_key(plain(quantity.symbol()))))

    def write_worked(self, node: Node, expr: Expr, unit_text: str) -> None:
        """Write symbol = formula = numbers = result into the step."""
        if self.writes:
            self.write(worked(node, expr, unit_text))


class Unwritten(Board):
    """A sheet of which nobody reads the lines that are worked out: its acts count, and what every hand found."""

    writes = False


class Scratch(Unwritten):
    """Paper that is thrown away: sketches, trials. Only what stands on it counts; nobody reads its text."""

    def log(self, act: done.Act) -> Acts:
        self.ink(act)
        return frozenset(act.inputs)

    def remark(self, words: Words) -> None:
        """Left out."""

    def graze(self, angle: float) -> None:
        """Left out."""

    def equate(self, table: EquationTable) -> None:
        """Left out."""

    def write(self, *formulas: Node, when: int | None = None) -> None:
        """Left out."""

    def tabulate(self, listing: Listing) -> None:
        """Left out."""
