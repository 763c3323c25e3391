"""What runs right through a blank frame: an axis, the lines that cross in a pole."""

from __future__ import annotations

from collections.abc import Iterator

from ....board.construction import Figure
from ....board.paper.marks import Dot, Mark, Point, Role, Segment
from .known import NEAR

EDGE = 9.0  # mm that stay free beside what runs through a frame
Box = tuple[complex, complex]


def centred(figure: Figure, box: Box) -> Iterator[Mark]:
    """What a figure about a centre begins with: that, and the axis through it, right through the frame."""
    first = min((mark.step for mark in figure.marks), default=0)
    for mark in figure.marks:
        if isinstance(mark, Point) and mark.step == first and abs(mark.at) < NEAR and mark.dot is Dot.JOINT:
            yield mark
    lines = (mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.CENTRE)
    line = next((one for one in lines if _is_axis(one.a, one.b)), None)
    if line is not None:
        yield through(0j, (line.b - line.a) / abs(line.b - line.a), box)


def _is_axis(a: complex, b: complex) -> bool:
    """Whether a line lies on one of the axes."""
    return abs(b - a) > NEAR and (max(abs(a.real), abs(b.real)) < NEAR or max(abs(a.imag), abs(b.imag)) < NEAR)


def through(at: complex, way: complex, box: Box) -> Segment:
    """A centre line from edge to edge."""
    return Segment(a=at - reach(at, -way, box) * way, b=at + reach(at, way, box) * way, role=Role.CENTRE, step=1)


def crossed(at: complex, box: Box) -> Iterator[Mark]:
    """The axes through a pole, with their letters."""
    for way, letter in ((1 + 0j, "x"), (1j, "y")):
        line = through(at, way, box)
        yield line
        yield Point(at=line.b, label=letter, dot=Dot.NONE, step=1)


def reach(at: complex, way: complex, box: Box) -> float:
    """How far it is this way to the edge of what may be drawn on."""
    low, high = box[0] + complex(EDGE, EDGE), box[1] - complex(EDGE, EDGE)
    ways = []
    for start, step, lowest, highest in (
        (at.real, way.real, low.real, high.real),
        (at.imag, way.imag, low.imag, high.imag),
    ):
        if abs(step) > NEAR:
            ways.append(((highest if step > 0 else lowest) - start) / step)
    return max(0.0, min(ways))
