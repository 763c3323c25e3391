"""What is on a figure and not seen, for something thicker lies over it: no legend tells of it."""

from __future__ import annotations

from ...board.construction import Figure
from ...board.paper.marks import Dot, Mark, Passing, Point, Role, Segment

AT = 0.1  # mm: what is so near lies there


def is_passing(figure: Figure, mark: Mark) -> bool:
    """Whether it is the joining half of a bar past its pin, which the outer circle of a multiple joint would cover."""
    covers = (one.at for one in figure.marks if isinstance(one, Point) and one.dot is Dot.MULTIPLE)
    return isinstance(mark, Passing) and not any(abs(at - mark.at) < AT for at in covers)


def is_centre_line(figure: Figure, mark: Mark) -> bool:
    """Whether it is a centre line that no bar lies on, all along."""
    if not isinstance(mark, Segment) or mark.role is not Role.CENTRE:
        return False
    bars = (one for one in figure.marks if isinstance(one, Segment) and one.role is Role.LINK)
    return not any(_lies_on(bar, mark.a) and _lies_on(bar, mark.b) for bar in bars)


def _lies_on(bar: Segment, at: complex) -> bool:
    """Whether a point is on a bar, between its ends."""
    long = abs(bar.b - bar.a)
    if long < AT:
        return False
    along = (at - bar.a) * ((bar.b - bar.a) / long).conjugate()
    return bool(-AT < along.real < long + AT and abs(along.imag) < AT)
