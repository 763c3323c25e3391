"""The vectors of one equation among all that stand on its figure: from where both sides begin to where both end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from ...board.construction import EquationTable, Figure, Step
from ...board.paper.marks import Vector
from ...board.paper.tones import key_of, known_as
from ...foundation.slotted import dataclass

ONE = 0.01  # mm: nearer than this is one place
Drawn = tuple[Vector, ...]


@dataclass(frozen=True, slots=True)
class Chain:
    """The vectors of each side of an equation, tail to head; all sides lead from `start` to `end`."""

    sides: tuple[Drawn, ...]
    start: complex
    end: complex

    @property
    def vectors(self) -> Drawn:
        """All of them, side by side."""
        return tuple(one for side in self.sides for one in side)

    @property
    def corners(self) -> tuple[complex, ...]:
        """Where they begin and end, each place once."""
        found: list[complex] = []
        for end in (end for one in self.vectors for end in (one.a, one.b)):
            if not any(is_one(end, other) for other in found):
                found.append(end)
        return tuple(found)


def chain_of(figure: Figure, step: Step) -> Chain | None:
    """The chain that a step's equation draws on its figure; None where what stands there is no polygon of it.

    A term without length has no vector; the sum in front, where it is no vector of its own, has none either.
    """
    if step.equation is None:
        return None
    sides = [_drawn(side, figure, step.number) for side in _sides(step.equation)]
    inked = [side for side in sides if side]
    for start in _starts(inked):
        for end in dict.fromkeys(path[-1].b for path in _paths(start, inked[0])):
            found = [next((p for p in _paths(start, side) if is_one(p[-1].b, end)), ()) for side in inked]
            if all(found) and (len(found) > 1 or is_one(start, end)):
                return Chain(tuple(found), start, end)
    return None


def is_one(a: complex, b: complex) -> bool:
    """Whether two places are one."""
    return abs(a - b) < ONE


def _sides(equation: EquationTable) -> list[list[str]]:
    """The keys of the terms between the signs of equality."""
    count = 0
    numbered: list[tuple[int, str]] = []
    for symbol, sign in zip(equation.symbols, equation.signs, strict=True):
        count += sign == "="
        numbered.append((count, known_as("", symbol)))
    return [[key for _, key in some] for _, some in groupby(numbered, key=lambda one: one[0])]


def _drawn(keys: Sequence[str], figure: Figure, step: int) -> list[Drawn]:
    """Of each term that is drawn by then the places at which it stands, those of this step first."""
    standing = [mark for mark in figure.marks if isinstance(mark, Vector) and mark.step <= step]
    found = (tuple(one for one in standing if key in (one.key, key_of(one))) for key in keys)
    return [tuple(sorted(some, key=lambda one: -one.step)) for some in found if some]


def _starts(sides: Sequence[Sequence[Drawn]]) -> Iterator[complex]:
    """Where the first side may begin, its first terms first."""
    yield from dict.fromkeys(mark.a for side in sides[:1] for some in side for mark in some)


def _paths(here: complex, terms: Sequence[Drawn]) -> Iterator[Drawn]:
    """The ways through all terms of a side, in any order: known ones are laid off first."""
    for n, some in enumerate(terms):
        for mark in some:
            if is_one(mark.a, here):
                rest = (*terms[:n], *terms[n + 1 :])
                yield from ((mark, *path) for path in _paths(mark.b, rest)) if rest else ((mark,),)
