"""A polygon of products: laid off head to tail from the pole O, closed by the one that balances them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, number
from ....board.board import NO_LENGTH
from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....board.place import view_named, view_of
from ....devices.balancing.asked import CLOSES
from ....foundation.slotted import dataclass
from ....names import Named
from ....plane import Points, Reals, nominal
from ....vector.close import close
from ....vector.equation import KNOWN, UNKNOWN, Equation, Term
from ....words import Words
from ..bench import Bench
from ..inclined import row_of

POLYGONS = tuple(map(view_named, ("products", "unbalances", "couples")))  # which stand on one sheet
_ROW = "abcdefghkmnqrstuvw"
_LETTERS = (*_ROW, *(f"{letter}_{turn}" for turn in range(1, 10) for letter in _ROW))


@dataclass(frozen=True, slots=True, kw_only=True)
class Laid:
    """A product to be laid off: its key, its size (in the unit of the figure; negative: the other way), its direction
    (deg)."""

    named: Named
    size: Reals
    degrees: Reals


@dataclass(frozen=True, slots=True, kw_only=True)
class Polygon:
    """A polygon as drawn: its figure, the end of the chain and its letter; the pole is O, at the origin.

    least: the length (mm) up to which its closing side counts as none.
    """

    place: Pane
    tip: Points
    letter: str
    least: float


def heading(degrees: Reals) -> Points:
    """The unit vector in a direction."""
    along: Points = np.exp(1j * np.radians(degrees))
    return along


def free_letters(bench: Bench, place: Pane) -> tuple[str, ...]:
    """The letters that stand on no polygon of the sheet: the two of a side name one side."""
    taken = frozenset[str]().union(*map(bench.board.lettered, {view_of(place), *POLYGONS}))
    return tuple(letter for letter in _LETTERS if letter not in taken)


def chain(bench: Bench, place: Pane, laid: Sequence[Laid], closing: Named, whole: float | None = None) -> Polygon:
    """Draw the products that have a length, and the closing side from the last tip back to the pole.

    whole: all products of the rotor together, where only shares of them are laid off here.
    """
    board = bench.board
    drawn = [one for one in laid if abs(float(nominal(board.to_paper(place, one.size)))) > NO_LENGTH]
    letters = free_letters(bench, place)
    terms = [_term(bench, place, one, letter) for one, letter in zip(drawn, letters, strict=False)]
    last = Term(rel=closing, symbol=closing.symbol, direction=UNKNOWN, magnitude="?")
    equation = Equation(left=(*terms, last))
    board.equate(equation.table())
    board.plot(place, 0j, "O", Dot.POLE)
    start, _ = close(board, place, 0j, equation).ends[closing.key]
    letter = letters[len(drawn) - 1] if drawn else "O"
    return Polygon(place=place, tip=start, letter=letter, least=_least(bench, place, laid, whole))


def _least(bench: Bench, place: Pane, laid: Sequence[Laid], whole: float | None = None) -> float:
    """A part of all that was laid off; by an unsteady hand what it cannot help."""
    board = bench.board
    size = sum(abs(float(nominal(one.size))) for one in laid) if whole is None else whole
    return max(CLOSES * float(nominal(board.to_paper(place, size))), board.hand.slack)


def summed(bench: Bench, place: Pane, laid: Sequence[Laid], total: Named | None, *, known: bool = True) -> Polygon:
    """Draw the products head to tail and their sum `total`, from the pole to the last tip; known: somebody may err."""
    board = bench.board
    board.plot(place, 0j, "O", Dot.POLE)
    tip: Points = 0j
    letter = "O"
    for one in laid:
        if abs(float(nominal(board.to_paper(place, one.size)))) <= NO_LENGTH:
            continue
        term = _term(bench, place, one, "")
        assert term.along is not None and term.mm is not None
        letter = free_letters(bench, place)[0]
        end = board.locate(place, letter, board.lay_off(tip, term.along, term.mm, key=one.named.key if known else ""))
        board.arrow(place, tip, end, Role.GIVEN, key=one.named.key, label=one.named.symbol)
        board.plot(place, end, letter)
        tip = end
    if total is not None:
        board.arrow(place, 0j, tip, Role.RESULT, key=total.key, label=total.symbol)
    return Polygon(place=place, tip=tip, letter=letter, least=_least(bench, place, laid))


def _term(bench: Bench, place: Pane, one: Laid, tip: str) -> Term:
    sign = -1.0 if float(nominal(one.size)) < 0 else 1.0
    turn = (one.degrees + (0.0 if sign > 0 else 180.0)) % 360.0
    return Term(
        rel=one.named,
        symbol=one.named.symbol,
        direction=Words.same(f"{number(float(nominal(turn)), 5)}°"),
        magnitude=KNOWN.zh,
        along=heading(turn),
        mm=bench.board.to_paper(place, sign * one.size),
        tip=tip,
    )


def read_closing(bench: Bench, polygon: Polygon, closing: Named, turned: Named) -> Quantity:
    """Measure the closing side, and its direction where it is longer than what counts as none."""
    found = bench.measured(closing, polygon.place, polygon.tip, 0j * polygon.tip, f"{polygon.letter} O")
    stated_bearing(bench, turned, -polygon.tip, polygon.least)
    return found


def stated_bearing(bench: Bench, named: Named, vector: Points, least: float) -> None:
    """The direction of a vector by protractor, 0 to 360°; none where the vector is not longer than `least` (mm)."""
    size = float(nominal(np.abs(vector)))
    if size <= max(least, NO_LENGTH):
        bench.board.remark(
            Words(
                f"（${named.symbol}$ 无意义：封闭边为零。）",
                f" (The closing side vanishes; ${named.symbol}$ has no meaning.)",
            )
        )
        bench.stated(named, np.nan * np.abs(vector), row_of(sym(named.symbol), " —"))
        return
    turn = np.degrees(bench.board.gauge(0j * vector, vector)) % 360.0
    bench.stated(named, turn, row_of(sym(named.symbol), f" = {number(float(nominal(turn)), 5)}°"))


def in_plane(end: str, words: Words) -> Words:
    """A sentence about one of two planes: “In plane I, ...”; of a single plane as it stands."""
    if not end:
        return words
    return Words(f"平面 ${end}$ 内，{words.zh}", f"In plane ${end}$, {words.en[:1].lower()}{words.en[1:]}")
