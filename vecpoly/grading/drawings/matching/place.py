"""Where the lines of a figure stand: whether it closes, where its letters are, what lies along a vector."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..expected import NOTHING, Edge, Shape
from ..segment import Segment
from .assign import Match

SIDE = 3.0  # mm: so far a vector is drawn beside another that lies on its line
APART = 1.0  # mm: ends of vectors that should meet, and do not
ALONG = 0.5  # mm: a helping line lies along its vector


def gap(shape: Shape, match: Match, scale: float) -> float:
    """The widest gap (mm on the sheet) at an end where another vector should end too; that of two vectors on one line
    one is drawn beside the other is none."""
    lines = [*match.lines.values(), *(one for _, one in match.optional)]
    doubled = [
        match.lines[edge.key] for edge in shape.edges if edge.key in match.lines and _doubled(shape, match, edge)
    ]
    widest = 0.0
    for edge in shape.edges:
        line = match.lines.get(edge.key)
        if line is not None:
            for at, own in ((edge.a, line.start), (edge.b, line.end)):
                if _meets(shape, match, edge.key, at):
                    widest = max(widest, _nearest(own, line, lines, doubled, SIDE / scale))
    return widest * scale


def _doubled(shape: Shape, match: Match, edge: Edge) -> bool:
    """Whether another drawn vector lies on the line of this one, and partly over it."""
    way = (edge.b - edge.a) / (abs(edge.b - edge.a) or 1.0)
    for other in shape.edges:
        if other.key != edge.key and other.key in match.lines:
            ends = [(z - edge.a) / way for z in (other.a, other.b)]
            low, high = sorted(z.real for z in ends)
            if max(abs(z.imag) for z in ends) < NOTHING and min(high, abs(edge.b - edge.a)) - max(low, 0.0) > NOTHING:
                return True
    return False


def _meets(shape: Shape, match: Match, key: str, at: complex) -> bool:
    """Whether another drawn vector should begin or end here."""
    others = [edge for edge in shape.edges if edge.key != key and edge.key in match.lines]
    return any(min(abs(edge.a - at), abs(edge.b - at)) < NOTHING for edge in others)


def _nearest(own: complex, line: Segment, lines: Sequence[Segment], doubled: Sequence[Segment], side: float) -> float:
    """How far the nearest end of another line is."""
    return min(
        (
            _apart(own - z, [both for both in (line, one) if both in doubled], side)
            for one in lines
            if one is not line
            for z in (one.start, one.end)
        ),
        default=0.0,
    )


def _apart(off: complex, moved: Sequence[Segment], side: float) -> float:
    """The distance of two ends; along lines that may be drawn a little to the side, what is left lengthwise."""
    least = abs(off)
    for line in moved:
        within = off * abs(line.along) / line.along
        if abs(within.imag) < side:
            least = min(least, abs(within.real))
    return least


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
