"""ΣF = 0 of a body: its forces with friction, without, and on the return stroke; its polygon, lettered and measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ...algebra.formula import Row, Txt, sym
from ...algebra.quantity import Quantity, number
from ...algebra.worked import keyed_in
from ...board.board import NO_LENGTH
from ...board.construction import Pane, Place
from ...board.paper.marks import Point
from ...errors import EquilibriumError, LockedError
from ...names import Named
from ...plane import Points, Reals, dot, nominal
from ...vector.close import Closed, close
from ...vector.equation import KNOWN, Equation, Term
from ...words import Words
from .bench import Bench

OFF_N, ALONG_N = Words("与 $n$ 成 $φ$", "$φ$ from $n$"), Words("沿 $n$", "along $n$")


def given(bench: Bench, place: Place, named: Named, newtons: Reals, along: Points, tip: str = "") -> Term:
    """A force known wholly, laid off to scale."""
    return Term(
        rel=named,
        symbol=named.symbol,
        direction=KNOWN,
        magnitude="✓",
        along=along,
        mm=bench.board.to_paper(place, newtons),
        tip=tip,
    )


def frictionless(named: Named) -> Named:
    """The same force without friction: R_{21,0}, F_{0}."""
    return _marked(named, "_0", lambda symbol: f"{symbol[:-1]},0}}" if symbol.endswith("}") else f"{symbol}_{{0}}")


def reversed_way(named: Named) -> Named:
    """The same force on the return stroke: R'_{21}."""
    return _marked(named, "_r", lambda symbol: symbol.replace("_", "'_", 1) if "_" in symbol else f"{symbol}'")


def _marked(named: Named, ending: str, symbol: Callable[[str], str]) -> Named:
    return Named(named.key + ending, symbol(named.symbol), named.unit, named.is_vector)


def drawn(named: Named, vector: Points) -> Term:
    """A force that stands on the polygon already."""
    return Term(rel=named, symbol=named.symbol, direction=KNOWN, magnitude="✓", vector=vector, drawn=True)


def sought(named: Named, along: Points, direction: Words) -> Term:
    """A force whose line is known and whose size is not."""
    return Term(rel=named, symbol=named.symbol, direction=direction, magnitude="?", along=along)


def balance(bench: Bench, place: Place, start: Points, *terms: Term) -> Closed:
    """Write ΣF = 0 of a body into the step and close its polygon."""
    equation = Equation(left=terms)
    bench.board.equate(equation.table())
    return close(bench.board, place, start, equation)


def driven(
    bench: Bench,
    place: Place,
    start: Points,
    terms: tuple[Term, ...],
    locked: Callable[[], LockedError],
    *,
    must_press: bool = True,
) -> Closed:
    """The same for a body that is driven:
    a force that comes out against its assumed direction, or at no finite size, means self-locking."""
    try:
        closed = balance(bench, place, start, *terms)
    except EquilibriumError:
        raise locked() from None
    if must_press and not all(points_along(closed, term) for term in terms if term.unknowns):
        raise locked()
    return closed


def letter(bench: Bench, place: Place, points: Mapping[str, Points]) -> None:
    """Letter the corners of a polygon, once each."""
    there = {mark.label for mark in bench.board.marks(place) if isinstance(mark, Point)}
    for label, at in points.items():
        if label not in there:
            bench.board.plot(place, at, label)


def points_along(closed: Closed, term: Term) -> bool:
    """Whether a force came out in the sense that its direction assumed."""
    start, end = closed.ends[term.rel.key]
    assert term.along is not None
    return float(nominal(dot(end - start, term.along))) > 0


def signed(
    bench: Bench, named: Named, place: Pane, ends: tuple[Points, Points], along: Points, letters: str
) -> Quantity:
    """A force measured on a polygon, positive along a direction:
    of a self-locking device the force that holds comes out negative."""
    start, end = ends
    if float(nominal(dot(end - start, along))) > -NO_LENGTH:
        return bench.measured(named, place, start, end, letters)
    sign = np.where(dot(end - start, along) < 0, -1.0, 1.0)
    board = bench.board
    size = board.mu(place) * board.measure(start, end, letters)
    value = size.value * sign[()]
    minus = Row(
        (
            sym(named.symbol),
            Txt(" = −"),
            size.symbol(),
            Txt(" = −"),
            keyed_in(size),
            Txt(f" = {number(float(nominal(value)))} {named.unit}"),
        )
    )
    return bench.stated(named, value, minus)
