"""Lines of action on which several forces lie, as both reactions of a two-force link: they have the ink of none."""

from __future__ import annotations

from ...board.construction import View
from ...board.paper.marks import Mark, Role, Segment
from ...board.paper.tones import whose
from .shapes import NEAR

ON_LINE = 0.15  # mm beside a line that is still the line


def shared(view: View, marks: tuple[Mark, ...]) -> frozenset[Segment]:
    """Those of a mechanism on whose line another force lies, too."""
    if view is not View.MECHANISM:
        return frozenset()
    lines = [m for m in marks if isinstance(m, Segment) and m.role is Role.DIRECTION and m.key.startswith("R_")]
    return frozenset(
        line for line in lines if any(whose(one.key) != whose(line.key) and _on_one_line(line, one) for one in lines)
    )


def _on_one_line(line: Segment, other: Segment) -> bool:
    """Whether both ends of another line lie on this one, or beyond it."""
    if abs(line.b - line.a) < NEAR:
        return False
    u = ((line.b - line.a) / abs(line.b - line.a)).conjugate()
    return all(abs(((end - line.a) * u).imag) < ON_LINE for end in (other.a, other.b))
