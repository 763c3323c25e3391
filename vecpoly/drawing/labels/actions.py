"""The name of a force along its line of action: nearer to that than to the line of any other, its own without friction
included."""

from __future__ import annotations

from collections.abc import Iterable

from ...board.paper.marks import Mark, Point, Role, Segment
from ..style import THIN
from ..symbols.shapes import NEAR
from .dimensions import fan
from .want import Piece, Thing, Want

_LINES = (Role.DIRECTION, Role.IDEAL)
_APART = 4.0  # mm between two places along the line


def line_of_action(point: Point, lines: Iterable[Segment]) -> Segment | None:
    """The line of the force that is named at its end."""
    own = (line for line in lines if line.role in _LINES and line.key and line.key == point.key)
    return next((line for line in own if min(abs(line.a - point.at), abs(line.b - point.at)) < NEAR), None)


def is_line_of_action(mark: Mark) -> bool:
    """Whether it shows where a reaction acts, not which way."""
    return isinstance(mark, Segment) and mark.role in _LINES and mark.key.startswith("R_")


def along_action(pieces: tuple[Piece, ...], at: complex, line: Segment) -> Want:
    """First of all at the end where it was put, beyond it or beside it; then at the other end, then farther in."""
    far = line.b if abs(line.a - at) < NEAR else line.a
    length, u = abs(far - at), (far - at) / abs(far - at)
    beyond = [(end, way) for end, ahead in ((at, -u), (far, u)) for way in fan(ahead, 60)]
    inward = [_APART * k for k in range(1 + int(length / 2 / _APART))]
    beside = [(end + way * by, side * u) for by in inward for end, way in ((at, u), (far, -u)) for side in (1j, -1j)]
    half = len(beyond) // 2
    feet, normals = zip(*beyond[:half], *beside[:2], *beyond[half:], *beside[2:], strict=True)
    return Want(pieces, feet, normals, THIN / 2, (line.a, line.b), one_sided=True, thing=Thing.ACTION)
