"""The vectors on a figure, found by their ends without looking at all of them: trials pile them up by the thousand."""

from __future__ import annotations

from itertools import product

SAME = 1e-6  # mm: vectors whose ends lie nearer than this, both together, are one
CELLS = 1e3  # a mm, into which the paper is divided


class Ends:
    """Tail and head of each vector, in the cell of its head."""

    __slots__ = ("_by_cell",)

    def __init__(self) -> None:
        self._by_cell: dict[tuple[int, int], list[tuple[complex, complex]]] = {}

    def add(self, start: complex, end: complex) -> None:
        """One more; of numbers that know how they were derived the values."""
        start, end = complex(start), complex(end)
        self._by_cell.setdefault(_cell(end), []).append((start, end))

    def has(self, start: complex, end: complex) -> bool:
        """Whether a vector stands there already."""
        start, end = complex(start), complex(end)
        about = {_cell(end + complex(x, y)) for x, y in product((-SAME, SAME), repeat=2)}
        return any(abs(a - start) + abs(b - end) < SAME for cell in about for a, b in self._by_cell.get(cell, ()))


def _cell(at: complex) -> tuple[int, int]:
    return round(CELLS * at.real), round(CELLS * at.imag)
