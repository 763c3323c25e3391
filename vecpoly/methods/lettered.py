"""The letters of a length on a polygon: those that stand at its ends on the figure.

Which letter an end has depends on what was drawn before: n′_3 where two normals are laid off, none where a^n vanishes.
"""

from __future__ import annotations

from ..board.construction import View
from ..board.strokes import NO_ARROW, spot
from ..plane import Points
from .desk import POLE, Desk


def lettered(desk: Desk, view: View, ends: tuple[Points, Points], expected: str) -> str:
    """The letters at both ends, `n_3^′ c^′`; as expected where those stand there, or where none does."""
    first, last = expected.split()
    return f"{_letter(desk, view, ends[0], first)} {_letter(desk, view, ends[1], last)}"


def _letter(desk: Desk, view: View, end: Points, expected: str) -> str:
    """Of several letters at one place the expected one, else one of its kind: n′_3 for n′."""
    at = spot(end)
    there = ((POLE[view],) if abs(at) < NO_ARROW else ()) + desk.board.letters_at(view, at)  # the pole has its own
    if expected in there:
        return expected
    return next((letter for letter in there if letter[0] == expected[0]), there[0] if there else expected)
