"""One number by two names: ω_3 = ω_2 of links that slide on each other, R_31 = R_12 through a link."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from math import isclose, isfinite

from ..algebra.formula import Node, Row, Sym, Txt, named
from ..algebra.worked import size_of, sizes_in
from ..answer import Answer
from ..foundation.slotted import replace

_KINDS = ("ω", "α", "R")  # of which one is equal to another by what they are, and not by chance
_OPPOSED = ("F", "M")  # what a spring does to its other link is called F_d′ or M_s′
_PAIR = re.compile(r"(\d)(\d)(?=,|$)")  # of links, by whose numbers the force in their joint is called
_SAME = 1e-9  # share by which a number may differ from itself
_IN_BRACKETS = 3  # parts of what stands between two of them


def of_both(symbol: Node) -> Node:
    """The symbol by which a number is known: R_12 of R_21, F_d of F_d′, which are as large; M/Q of (M/Q)."""
    if isinstance(symbol, Row) and len(symbol.items) == _IN_BRACKETS and symbol.items[0] == Txt("("):
        return of_both(symbol.items[1])
    if isinstance(symbol, Sym) and symbol.base in _OPPOSED and symbol.sub.endswith("′"):
        return replace(symbol, sub=symbol.sub.removesuffix("′"))
    if not isinstance(symbol, Sym) or symbol.base.rstrip("′") != "R" or (pair := _PAIR.match(symbol.sub)) is None:
        return symbol
    first, second = sorted(pair.groups())
    return replace(symbol, sub=first + second + symbol.sub[pair.end() :])


def one_name(answers: Iterable[Answer], lines: Iterable[Row]) -> Mapping[Node, Node]:
    """Of each symbol that is as large as another of its kind wherever it stands, the one by which its number is known:
    that of an answer, or of the line that comes first."""
    sizes = dict[Node, float]()
    for symbol, size in _sizes(answers, lines):
        once = isclose(sizes.setdefault(symbol, size), size, rel_tol=_SAME)
        sizes[symbol] = size if once else float("nan")
    names = dict[Node, Node]()
    known = list[tuple[str, float, Node]]()
    for symbol, size in sizes.items():
        base = symbol.base if isinstance(symbol, Sym) else ""
        if base not in _KINDS or not size or not isfinite(size):
            continue
        equal = (one for kind, other, one in known if kind == base and isclose(size, other, rel_tol=_SAME))
        if (first := next(equal, None)) is not None:
            names[symbol] = first
        else:
            known.append((base, size, symbol))
    return names


def _sizes(answers: Iterable[Answer], lines: Iterable[Row]) -> Iterator[tuple[Node, float]]:
    """Symbols and their sizes: of the answers, of what lines come to, and of what they go on with."""
    for answer in answers:
        if not answer.is_place and isfinite(answer.drawn):
            yield of_both(named(answer.reading.symbol)), abs(answer.drawn)
    worked = [line for line in lines if line.worked is not None]
    for line in worked:
        yield of_both(line.items[0]), size_of(line)
    for line in worked:
        for symbol, size in sizes_in(line):
            yield of_both(symbol), size
