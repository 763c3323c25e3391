"""Which lines tell a length that was read on paper: l = μ_l AB, l = μ_l (AC_2 − AC_1)/2, v = μ_v pb."""

from __future__ import annotations

from collections.abc import Iterator

from ..algebra.formula import Frac, Node, Over, Row, Sym

_FORMULA, _PARTS = 2, 4  # of a line symbol = formula = numbers = result


def is_length(line: Row) -> bool:
    """Whether it has nothing but one scale and lengths on paper, and is no ratio of those."""
    if len(line.items) <= _PARTS:
        return False
    above = list(_leaves(line.items[_FORMULA], below=False))
    scales, lengths = (sum(isinstance(one, kind) for one in above) for kind in (Sym, Over))
    return scales == 1 and lengths > 0 and not any(_leaves(line.items[_FORMULA], below=True))


def _leaves(node: Node, *, below: bool) -> Iterator[Node]:
    """The symbols and lengths of a formula above, or below, its fraction bars; powers and roots are no lengths."""
    match node:
        case Row(items):
            for one in items:
                yield from _leaves(one, below=below)
        case Frac(num, den):
            if below:
                yield from _leaves(den, below=False)
            yield from _leaves(num, below=below)
        case Sym() | Over() if not below:
            yield node
        case _:
            pass
