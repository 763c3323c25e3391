"""The closed loops of a linkage that is found: four hinges, or three and a slide."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Hinged:
    """A loop of four hinges, driven at its first letter: A, B, C, D with A and D pivots of the frame."""

    a: str
    b: str
    c: str
    d: str

    @property
    def letters(self) -> tuple[str, ...]:
        """Of its hinges, in order."""
        return self.a, self.b, self.c, self.d


@dataclass(frozen=True, slots=True, kw_only=True)
class Sliding:
    """A loop of three hinges and a slide, driven at its first letter; along: its guide."""

    a: str
    b: str
    c: str
    along: complex

    @property
    def letters(self) -> tuple[str, ...]:
        """Of its hinges, in order."""
        return self.a, self.b, self.c


Loop = Hinged | Sliding


def chains(loops: Iterable[Loop]) -> Iterator[tuple[Loop, ...]]:
    """Each loop that hangs on the rocker of another, behind those that lead from the driver to it."""
    every = tuple(loops)
    for loop in every:
        trail: tuple[Loop, ...] = (loop,)
        while (before := _carrier(trail[0], every)) is not None and before not in trail:
            trail = (before, *trail)
        if len(trail) > 1:
            yield trail


def _carrier(loop: Loop, every: Iterable[Loop]) -> Hinged | None:
    """The loop whose rocker drives this one."""
    return next((one for one in every if isinstance(one, Hinged) and one.d == loop.a), None)


def sides(loop: Loop) -> tuple[tuple[str, str], ...]:
    """The letters of its links, from the driver on."""
    match loop:
        case Hinged():
            return (loop.a, loop.b), (loop.b, loop.c), (loop.c, loop.d), (loop.a, loop.d)
        case Sliding():
            return (loop.a, loop.b), (loop.b, loop.c)
