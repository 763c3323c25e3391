"""Terms as GeoGebra writes them; a term that is used again has an object of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from ..terms import Pair, Term

LONG = 400  # characters; a longer term is given an object of its own
_BINARY = frozenset(("+", "-", "*", "/", "^", "<", "<=", ">", ">=", "=="))


class Spelling:
    """How every term is written so far; `named` makes a hidden number of a term and gives its label."""

    def __init__(self, roots: Iterable[Term], named: Callable[[str], str]) -> None:
        self._uses = _uses(roots)
        self._named = named
        self._known: dict[int, str] = {}

    def know(self, term: Term, text: str) -> None:
        """From now on the term is written so; a number stays a number."""
        if term.constant is None:
            self._known.setdefault(id(term), text)

    def knows(self, term: Term) -> bool:
        """Whether an object gives this term, or it is a number."""
        return term.constant is not None or id(term) in self._known

    def pair(self, pair: Pair) -> str:
        """A point by its coordinates."""
        return f"({self.text(pair[0])}, {self.text(pair[1])})"

    def text(self, term: Term) -> str:
        """The term."""
        if id(term) in self._known:
            return self._known[id(term)]
        if term.constant is not None:
            return numeral(term.constant)
        written = _written(term, [self.text(arg) for arg in term.args])
        if self._uses.get(id(term), 0) > 1 or len(written) > LONG:
            self._known[id(term)] = written = self._named(written)
        return written


def numeral(value: float) -> str:
    """A number in full: 1.5E-9, brackets about a negative one."""
    mantissa, _, exponent = repr(value).partition("e")
    text = f"{mantissa}E{int(exponent)}" if exponent else mantissa.removesuffix(".0")
    return f"({text})" if value < 0 or exponent else text


def _written(term: Term, args: list[str]) -> str:
    match term.op:
        case "neg":
            return f"(-{args[0]})"
        case "if":
            return f"If[{', '.join(args)}]"
        case op if op in _BINARY:
            return f"({args[0]} {op} {args[1]})"
        case op:
            return f"{op}({', '.join(args)})"


def _uses(roots: Iterable[Term]) -> dict[int, int]:
    """How often each term is needed."""
    uses: dict[int, int] = {}
    waiting = list(roots)
    while waiting:
        term = waiting.pop()
        uses[id(term)] = uses.get(id(term), 0) + 1
        if uses[id(term)] == 1:
            waiting.extend(term.args)
    return uses
