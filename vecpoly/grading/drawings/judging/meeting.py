"""Two vectors that end where their directions meet: one drawn in a wrong direction makes the other longer or shorter,
and is the only mistake of the two."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ....board.acts import Locate, Meet
from ....board.construction import Construction
from ..expected import NOTHING, Edge, Shape, Vertex
from ..matching.assign import Match
from ..segment import Segment
from .mark import VectorMark
from .reason import FAIR

PARALLEL = 0.05  # sine of the angle below which two lines meet nowhere that could be told


def met(
    shape: Shape, construction: Construction, match: Match, edge: Edge, marks: Mapping[str, VectorMark]
) -> complex | None:
    """What a vector of the right direction and another length should be, where it ends on the line of one whose
    direction is wrong; None where there is no such line."""
    mine = marks[edge.key]
    if mine.verdict in FAIR or mine.direction not in FAIR or not mine.sense or edge.key not in match.lines:
        return None
    for other, corner in _partners(shape, construction, edge):
        theirs = marks.get(other.key)
        if theirs is not None and theirs.own is not None and (theirs.direction not in FAIR or theirs.sense is False):
            return _as_far_as(
                match.lines[edge.key], match.lines[other.key], mine.should, abs(edge.b - corner.at) < NOTHING
            )
    return None


def _as_far_as(mine: Segment, other: Segment, should: complex, to_corner: bool) -> complex | None:
    """From the own known end in the right direction to the other line."""
    way, along = should / abs(should), other.along / abs(other.along)
    across = (way.conjugate() * along).imag
    if abs(across) < PARALLEL:
        return None
    known = mine.start if to_corner else mine.end
    towards = way if to_corner else -way
    reach = ((other.start - known).conjugate() * along).imag / (towards.conjugate() * along).imag
    return reach * way if reach > 0 else None


def _partners(shape: Shape, construction: Construction, edge: Edge) -> Iterator[tuple[Edge, Vertex]]:
    """The other vectors that were drawn to the meeting of directions in which this one ends, and that meeting."""
    corner = _last(shape, edge)
    if corner is None or not _meeting(construction, corner):
        return
    for other in shape.edges:
        if other.key != edge.key and not other.given and _last(shape, other) == corner:
            yield other, corner


def _last(shape: Shape, edge: Edge) -> Vertex | None:
    """Of the two ends of a vector that it was drawn to."""
    ends = [found for at in (edge.a, edge.b) if (found := shape.vertex(at)) is not None]
    return max(ends, key=lambda one: one.act, default=None)


def _meeting(construction: Construction, corner: Vertex) -> bool:
    """Whether a place was found by two lines of known direction."""
    if corner.act < 0:
        return False
    found = construction.acts[corner.act]
    return isinstance(found, Locate) and any(isinstance(construction.acts[n], Meet) for n in found.inputs)
