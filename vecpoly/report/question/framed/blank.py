"""What a blank frame shows of a figure: pivots and guides, a pole, axes with their numbers; nothing that is found."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from itertools import count, takewhile
from math import pi

from ....board.construction import Figure, View
from ....board.paper.extent import bounds
from ....board.paper.marks import Arc, Dot, FixedGuide, Ground, Mark, Note, Point, RackMark, Role, Segment, Vector
from ....figures.balancing import END_VIEW, HODOGRAPH
from ....figures.energy import INDICATOR
from ....foundation.slotted import replace
from ....words import Words
from ...picture import to_scale
from .axes import across, axes, scaled, upwards
from .known import NEAR, begins_at, begun
from .room import outline
from .through import EDGE, Box, centred, crossed, reach, through

PAST, _PARTS = 2.0, 360  # mm between a circle and the frame; parts of a circle that is cut off there
WHITE = 4.0  # mm between a polygon and its frame
_PLACES = (
    1 / 2,
    1 / 3,
    2 / 3,
    1 / 4,
    3 / 4,
    1 / 5,
    4 / 5,
    1 / 6,
    5 / 6,
    1 / 8,
    7 / 8,
)  # of a frame, for a pole; the first that does
_FLOORS = (0.0, 1 / 4, 1 / 2, 3 / 4)  # likewise for the axis of a diagram
_HATCHED = 16.0  # mm of a guide
_GUIDE = Words("导路", "guide")


def framed(figure: Figure, size: tuple[float, float], known: Sequence[Mark]) -> tuple[Box, tuple[Mark, ...]]:
    """The frame of this size about a figure, on the figure, and what stands in it; known: what is given of it."""
    if figure.view is View.MECHANISM:
        box = _about(figure, size)
        if not to_scale(figure):
            return box, begun(figure)
        fixed = any(isinstance(mark, (Ground, FixedGuide)) for mark in known)
        return box, (*(() if fixed else centred(figure, box)), *_given(figure, known, box))
    if figure.view is END_VIEW:
        return _about(figure, size), begun(figure)
    if (both := axes(figure)) is not None:
        box, marks = _diagram(figure, both, size)
        return box, (*marks, *known)
    if figure.view is INDICATOR:
        return _levels(figure, size)
    start = begins_at(figure)
    if start is None or (known and figure.view is View.BODY):
        return _middled(figure, known, size), tuple(known)
    if start.dot is Dot.POLE and figure.view is not HODOGRAPH:
        return _in_the_middle(figure, start, size)
    box = _round(figure, start.at, size)
    return box, (start, *(crossed(start.at, box) if figure.view is HODOGRAPH else ()))


def _in_the_middle(figure: Figure, pole: Point, size: tuple[float, float]) -> tuple[Box, tuple[Mark, ...]]:
    """The frame with the pole in its middle, which tells nothing of a polygon; where it would not fit, at the round
    place nearest to it."""
    low, high = bounds(figure.marks)
    box = pole.at - complex(*size) / 2, pole.at + complex(*size) / 2
    inside = min(low.real - box[0].real, low.imag - box[0].imag, box[1].real - high.real, box[1].imag - high.imag)
    return (box if inside >= WHITE else _round(figure, pole.at, size)), (pole,)


def _about(figure: Figure, size: tuple[float, float]) -> Box:
    """The frame with the figure in its middle."""
    low, high = outline(figure)
    start = (low + high - complex(*size)) / 2
    return start, start + complex(*size)


def _middled(figure: Figure, known: Sequence[Mark], size: tuple[float, float]) -> Box:
    """The frame with what is printed of a figure as near to its middle as the whole of it allows."""
    start, half = _about(figure, size)[0], complex(*size) / 2
    if not known:
        return start, start + complex(*size)
    (low, high), (left, right) = bounds(figure.marks), bounds(known)
    wanted = (left + right) / 2 - half
    x, y = (
        min(max(want, end + WHITE - side), first - WHITE) if end - first + 2 * WHITE <= side else middle
        for want, first, end, side, middle in (
            (wanted.real, low.real, high.real, size[0], start.real),
            (wanted.imag, low.imag, high.imag, size[1], start.imag),
        )
    )
    return complex(x, y), complex(x, y) + complex(*size)


def _round(figure: Figure, pole: complex, size: tuple[float, float]) -> Box:
    """The frame in which a first point has a round place, in the middle if the figure allows."""
    low, high = bounds(figure.marks)
    middle = _about(figure, size)[0]
    x = _share(pole.real - low.real, high.real - pole.real, size[0], _PLACES)
    y = _share(pole.imag - low.imag, high.imag - pole.imag, size[1], _PLACES)
    start = complex(
        middle.real if x is None else pole.real - x * size[0], middle.imag if y is None else pole.imag - y * size[1]
    )
    return start, start + complex(*size)


def _share(before: float, behind: float, room: float, of: Sequence[float]) -> float | None:
    """The first of these shares of the room that leaves enough before a place, and behind it."""
    needed = before + WHITE if before > NEAR else 0.0
    return next((one for one in of if one * room >= needed and (1 - one) * room >= behind + WHITE), None)


def _given(figure: Figure, known: Sequence[Mark], box: Box) -> Iterator[Mark]:
    """Fixed pivots with their letters, fixed racks, guides right through the frame, not where their blocks stand."""
    pivots = [mark.at for mark in known if isinstance(mark, Ground)]
    yield from (mark for mark in figure.marks if isinstance(mark, RackMark) and mark.fixed)
    for mark in figure.marks:
        if isinstance(mark, Point) and mark.dot is not Dot.NONE and mark.at in pivots and mark not in known:
            yield replace(mark, label=_own(mark.label))
    for mark in known:
        if isinstance(mark, FixedGuide) and mark.about is not None:
            yield from _guide(mark, mark.about, box, pivots)
        elif isinstance(mark, Arc):
            yield from _inside(mark, box)
        else:
            yield mark


def _own(label: str) -> str:
    """The letter of a pivot without that of the centre that lies there."""
    return ", ".join(part for part in label.split(", ") if "P_" not in part)


def _inside(circle: Arc, box: Box) -> Iterator[Arc]:
    """The longest part of a circle that lies in the frame."""
    low, high = box[0] + complex(PAST, PAST), box[1] - complex(PAST, PAST)
    steps = [circle.centre + cmath.rect(circle.radius, 2 * pi * n / _PARTS) for n in range(_PARTS)]
    there = [low.real <= z.real <= high.real and low.imag <= z.imag <= high.imag for z in steps]
    if all(there):
        yield circle
        return
    runs = [(n, sum(1 for _ in takewhile(lambda k: there[k % _PARTS], count(n)))) for n in range(_PARTS)]
    start, length = max(runs, key=lambda run: run[1])
    if length > 1:
        yield replace(circle, start=2 * pi * start / _PARTS, sweep=2 * pi * (length - 1) / _PARTS)


def _guide(guide: FixedGuide, about: complex, box: Box, pivots: Sequence[complex]) -> Iterator[Mark]:
    """The line on which the block's pin moves, from edge to edge, hatched at both ends, at one where a pivot is in the
    way of the other."""
    way = (guide.b - guide.a) / abs(guide.b - guide.a)
    back, on = reach(about, -way, box), reach(about, way, box)
    yield through(about, way, box)
    shift = ((guide.a - about) / way).imag * 1j * way
    start, end = about - back * way + shift, about + on * way + shift
    yield FixedGuide(a=end - _HATCHED * way, b=end, step=1)
    crowded = any(abs(pivot - start - _HATCHED * way / 2) < 1.5 * _HATCHED for pivot in pivots)
    if back + on > 3 * _HATCHED and not crowded:
        yield FixedGuide(a=start, b=start + _HATCHED * way, step=1)
    yield Note(at=about + (on - _HATCHED / 2) * way, words=_GUIDE, step=1)


def _diagram(figure: Figure, both: tuple[Vector, Vector], size: tuple[float, float]) -> tuple[Box, tuple[Mark, ...]]:
    """The axes with names, units and numbers, from edge to edge."""
    right, up = both
    low, high = bounds(figure.marks)
    start = _about(figure, size)[0]
    below = -low.imag if low.imag < -EDGE or up.a.imag < -NEAR else 0.0  # numbers stand in the edge
    floor = _share(below, high.imag, size[1] - 2 * EDGE, _FLOORS)
    y = start.imag if floor is None else -EDGE - floor * (size[1] - 2 * EDGE)
    box = complex(start.real, y), complex(start.real, y) + complex(*size)
    return box, (*across(figure, right, box), *upwards(figure, up, box))


def _levels(figure: Figure, size: tuple[float, float]) -> tuple[Box, tuple[Mark, ...]]:
    """The base line of works that are set out up and down, and a scale beside it."""
    low, high = bounds(figure.marks)
    middle = _about(figure, size)[0]
    floor = _share(-low.imag, high.imag, size[1], _PLACES)
    start = complex(middle.real, middle.imag if floor is None else -floor * size[1])
    box = start, start + complex(*size)
    left, right = start.real + 2 * EDGE, box[1].real - EDGE
    base = Segment(a=left + 0j, b=right + 0j, role=Role.CENTRE, step=1)
    foot, end = complex(left, box[0].imag + EDGE), complex(left, box[1].imag - EDGE)
    return box, (base, *scaled(figure, "E", foot, end))
