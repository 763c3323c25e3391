"""Where the lines of a figure stand: whether it closes, where its letters are, what lies along a vector."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..expected import NOTHING, Shape
from ..segment import Segment
from .assign import Match

APART = 1.0  # mm: ends of vectors that should meet, and do not
ALONG = 0.5  # mm: a helping line lies along its vector


def gap(shape: Shape, match: Match, scale: float) -> float:
    """The widest gap (mm on the sheet) at an end where another vector should end too."""
    lines = [*match.lines.values(), *(one for _, one in match.optional)]
    widest = 0.0
    for edge in shape.edges:
        line = match.lines.get(edge.key)
        if line is not None:
            for at, own in ((edge.a, line.start), (edge.b, line.end)):
                if _meets(shape, match, edge.key, at):
                    widest = max(widest, _nearest(own, line, lines))
    return widest * scale


def _meets(shape: Shape, match: Match, key: str, at: complex) -> bool:
    """Whether another drawn vector should begin or end here."""
    others = [edge for edge in shape.edges if edge.key != key and edge.key in match.lines]
    return any(min(abs(edge.a - at), abs(edge.b - at)) < NOTHING for edge in others)


def _nearest(own: complex, line: Segment, lines: Sequence[Segment]) -> float:
    ends = [z for one in lines if one is not line for z in (one.start, one.end)]
    return min((abs(own - z) for z in ends), default=0.0)


def drawn_places(shape: Shape, match: Match) -> Mapping[str, complex]:
    """Letter → where it is on the sheet, of the points at which all drawn vectors agree."""
    found: dict[str, list[complex]] = {}
    for edge in shape.edges:
        line = match.lines.get(edge.key)
        for letters, at in ((edge.tail, line.start), (edge.tip, line.end)) if line else ():
            for letter in letters:
                found.setdefault(letter, []).append(at)
    return {letter: at[0] for letter, at in found.items() if max(abs(z - at[0]) for z in at) < APART}


def beside(one: Segment, match: Match) -> bool:
    """Whether a line without a head runs along a drawn vector: the direction line that it was found by."""
    return any(_along(one, line) or _along(line, one) for line in match.lines.values())


def _along(one: Segment, other: Segment) -> bool:
    """Whether one lies on the straight line of the other."""
    way = other.along / abs(other.along)
    return max(abs(((z - other.start) / way).imag) for z in (one.start, one.end)) < ALONG
