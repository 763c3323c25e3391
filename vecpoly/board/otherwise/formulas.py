"""What somebody makes of a formula who mistakes one thing in it: a term left out, a ratio upside down."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import isclose, isfinite
from typing import assert_never

from ...algebra.formula import Over, Txt, plain
from ...algebra.quantity import Expr, Of, Powered, Product, Quantity, Quotient, Rooted, Sum, Times
from ...plane import Reals, nominal
from .slip import Chance, Mistake, Slip

HALF_OF = 2.0
SAME = 1e-9  # of a value: so near to the right one it is no mistake
_COFUNCTION = {"sin": "cos", "cos": "sin"}
Wrong = tuple[Mistake, str, Expr]  # the mistake, of what, and the formula that it makes


def wrongly(
    expr: Expr, slipped: Iterable[tuple[int | None, Slip]]
) -> tuple[tuple[Chance, ...], list[tuple[int | None, Reals]]]:
    """What may be mistaken in a formula so that it gives another value, and the values of the hands that do."""
    made = {Chance(mistake, of): one for mistake, of, one in mistaken(expr) if _is_other(one, expr)}
    made_by = ((hand, made.get(Chance(slip.mistake, slip.instead))) for hand, slip in slipped)
    return tuple(made), [(hand, one.value) for hand, one in made_by if one is not None]


def upside_down(ratio: Expr) -> Chance | None:
    """That a ratio of two lengths is turned over; None where they are alike."""
    alike = isclose(abs(nominal(ratio.value)), 1.0, rel_tol=SAME)
    return None if alike else Chance(Mistake.INVERTED, _name(ratio))


def _is_other(wrong: Expr, right: Expr) -> bool:
    """Whether a formula gives another value, and any."""
    try:
        value = nominal(wrong.value)
    except ZeroDivisionError:
        return False
    return isfinite(value) and not isclose(value, nominal(right.value), rel_tol=SAME)


def mistaken(expr: Expr) -> Iterator[Wrong]:
    """Every formula with one mistake; of what is read on paper, whose lines have mistakes of their own, that a half is
    forgotten."""
    if (whole := _not_halved(expr)) is not None:
        yield Mistake.DOUBLED, "", whole
    if not any(isinstance(one.node, Over) for one in _leaves(expr)):
        yield from _of(expr)


def _not_halved(expr: Expr) -> Expr | None:
    """The formula of one who forgets that it is half of something: of a difference, or a sum; None where it is not."""
    match expr:
        case Quotient(num=num, den=Quantity(node=Txt(), value=float(two))) if two == HALF_OF:
            return num
        case Product(factors=(*before, last)) if (whole := _not_halved(last)) is not None:
            return Product((*before, whole))
        case _:
            return None


def _leaves(expr: Expr) -> Iterator[Quantity]:
    """The quantities and numbers of which a formula is made."""
    match expr:
        case Quantity():
            yield expr
        case Product(factors=parts) | Sum(terms=parts):
            for part in parts:
                yield from _leaves(part)
        case Quotient(num=num, den=den):
            yield from _leaves(num)
            yield from _leaves(den)
        case Powered(base=body) | Times(body=body) | Of(angle=body) | Rooted(body=body):
            yield from _leaves(body)
        case _:
            assert_never(expr)


def _of(expr: Expr) -> Iterator[Wrong]:
    match expr:
        case Quantity():
            return
        case Product(factors=factors):
            for i, factor in enumerate(factors):
                yield from ((m, of, Product((*factors[:i], one, *factors[i + 1 :]))) for m, of, one in _of(factor))
        case Quotient(num=num, den=den):
            yield from _of_fraction(num, den)
        case Sum():
            yield from _of_sum(expr)
        case Powered(base=base, exponent=2):
            yield Mistake.UNSQUARED, _name(base), base
        case Powered():
            return
        case Times(factor=factor, body=body):
            yield from ((m, of, Times(factor, one)) for m, of, one in _of(body))
        case Of(name=name, angle=angle):
            if name in _COFUNCTION:
                yield Mistake.COFUNCTION, _name(expr), Of(_COFUNCTION[name], angle)
            yield from ((m, of, Of(name, one)) for m, of, one in _of(angle))
        case Rooted(body=body):
            yield from ((m, of, Rooted(one)) for m, of, one in _of(body))
        case _:
            assert_never(expr)


def _of_fraction(num: Expr, den: Expr) -> Iterator[Wrong]:
    """A ratio of two of a kind is turned upside down, a pure number multiplied by in place of divided by."""
    if _units(num) == _units(den):
        yield Mistake.INVERTED, _name(Quotient(num, den)), Quotient(den, num)
    elif not any(_units(den)) and not isinstance(den, Sum) and not all(isinstance(q.node, Txt) for q in _leaves(den)):
        yield Mistake.INVERTED, _name(den), Product((num, den))
    yield from ((m, of, Quotient(one, den)) for m, of, one in _of(num))
    yield from ((m, of, Quotient(num, one)) for m, of, one in _of(den))


def _of_sum(expr: Sum) -> Iterator[Wrong]:
    """A term is left out, or has the other sign; a mistake within a term.

    Of many terms that are all added none has the other sign, nor has one of a count, of which 3n and 2p_L are never
    forgotten.
    """
    terms, signs = expr.terms, expr.signs
    is_count = not any(map(_units, terms))
    may_turn = not is_count and (len(terms) == 2 or min(signs) < 0)
    for i, (term, sign) in enumerate(zip(terms, signs, strict=True)):
        before, after = slice(None, i), slice(i + 1, None)
        if not (is_count and isinstance(term, Times)):
            yield Mistake.OMITTED, _name(term), Sum((*terms[before], *terms[after]), (*signs[before], *signs[after]))
        if i and may_turn:
            yield Mistake.SIGN, _name(term), Sum(terms, (*signs[before], -sign, *signs[after]))
        yield from ((m, of, Sum((*terms[before], one, *terms[after]), signs)) for m, of, one in _of(term))


def _units(expr: Expr) -> tuple[str, ...]:
    """The units of the quantities of which an expression is made, those without one left out."""
    match expr:
        case Quantity(unit=unit):
            return (unit,) if unit else ()
        case Product(factors=factors):
            return tuple(sorted(unit for factor in factors for unit in _units(factor)))
        case Sum(terms=terms):
            return _units(terms[0])
        case Quotient(num=num, den=den):
            return (*_units(num), *(f"/{unit}" for unit in _units(den)))
        case Powered(base=base, exponent=exponent):
            return _units(base) * exponent
        case Times(body=body):
            return _units(body)
        case Of():
            return ()
        case Rooted(body=body):
            return tuple(f"√{unit}" for unit in _units(body))
        case _:
            assert_never(expr)


def _name(expr: Expr) -> str:
    """What a mistake is about, as it is typed: ``J_2 i_21^2``."""
    return plain(expr.symbol()).replace("\u2009", " ")
