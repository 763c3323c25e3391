"""What a blank frame shows of a figure: pivots and guides, a pole, axes with their numbers; nothing that is found."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from itertools import count, takewhile
from math import pi

from ....algebra.quantity import number
from ....algebra.rounding import braced
from ....board.construction import Figure, Scale, View
from ....board.paper.extent import bounds
from ....board.paper.marks import Arc, Dot, FixedGuide, Ground, Mark, Note, Point, RackMark, Role, Segment, Vector
from ....board.paper.scales import round_up
from ....figures.balancing import END_VIEW, HODOGRAPH
from ....figures.energy import INDICATOR
from ....foundation.slotted import replace
from ....words import Words
from ...picture import to_scale
from .known import NEAR, begins_at, begun
from .room import outline
from .through import EDGE, Box, centred, crossed, reach, through

PAST, _PARTS = 2.0, 360  # mm between a circle and the frame; parts of a circle that is cut off there
_WHITE = 4.0  # mm between a polygon and its frame
_PLACES = (1 / 2, 1 / 3, 2 / 3, 1 / 4, 3 / 4, 1 / 5, 4 / 5, 1 / 8, 7 / 8)  # of a frame, for a pole; the first that does
_FLOORS = (0.0, 1 / 4, 1 / 2, 3 / 4)  # likewise for the axis of a diagram
_HATCHED = 16.0  # mm of a guide
_TICK, _APART = 1.5, 10.0  # mm: half a tick, from tick to tick at least
_WIDE = 15.0  # mm: from tick to tick, where each has its number
_METRE, _MILLIMETRE, MILLI = "m", "mm", 1e3
_ROUND = (1.0, 2.0, 5.0, 10.0)
_BELOW = -10.0  # mm: no lower stand the numbers of an axis
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
    if (axes := _axes(figure)) is not None:
        box, marks = _diagram(figure, axes, size)
        return box, (*marks, *known)
    if figure.view is INDICATOR:
        return _levels(figure, size)
    start = begins_at(figure)
    if start is None:
        return _about(figure, size), tuple(known)
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
    return (box if inside >= _WHITE else _round(figure, pole.at, size)), (pole,)


def _about(figure: Figure, size: tuple[float, float]) -> Box:
    """The frame with the figure in its middle."""
    low, high = outline(figure)
    start = (low + high - complex(*size)) / 2
    return start, start + complex(*size)


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
    needed = before + _WHITE if before > NEAR else 0.0
    return next((one for one in of if one * room >= needed and (1 - one) * room >= behind + _WHITE), None)


def _given(figure: Figure, known: Sequence[Mark], box: Box) -> Iterator[Mark]:
    """Fixed pivots with their letters, fixed racks, guides right through the frame, not where their blocks stand."""
    pivots = [mark.at for mark in known if isinstance(mark, Ground)]
    yield from (mark for mark in figure.marks if isinstance(mark, RackMark) and mark.fixed)
    for mark in figure.marks:
        if isinstance(mark, Point) and mark.dot is not Dot.NONE and mark.at in pivots:
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


def _axes(figure: Figure) -> tuple[Vector, Vector] | None:
    """The axis to the right and the one upwards, where a figure has them."""
    arrows = [mark for mark in figure.marks if isinstance(mark, Vector) and mark.role is Role.DIRECTION]
    right = next((one for one in arrows if abs(one.b.imag - one.a.imag) < NEAR), None)
    up = next((one for one in arrows if abs(one.b.real - one.a.real) < NEAR), None)
    return None if right is None or up is None else (right, up)


def _diagram(figure: Figure, axes: tuple[Vector, Vector], size: tuple[float, float]) -> tuple[Box, tuple[Mark, ...]]:
    """The axes with names, units and numbers, from edge to edge."""
    right, up = axes
    low, high = bounds(figure.marks)
    start = _about(figure, size)[0]
    below = -low.imag if low.imag < -EDGE or up.a.imag < -NEAR else 0.0  # numbers stand in the edge
    floor = _share(below, high.imag, size[1] - 2 * EDGE, _FLOORS)
    y = start.imag if floor is None else -EDGE - floor * (size[1] - 2 * EDGE)
    box = complex(start.real, y), complex(start.real, y) + complex(*size)
    return box, (*_across(figure, right, box), *_upwards(figure, up, box))


def _across(figure: Figure, right: Vector, box: Box) -> Iterator[Mark]:
    """The axis to the right with the numbers that the drawing has."""
    end = complex(box[1].real - EDGE, right.b.imag)
    start = complex(box[0].real + EDGE, right.a.imag) if right.a.real < -NEAR else right.a
    yield Vector(a=start, b=end, role=Role.DIRECTION, step=1)
    name = next((mark.label for mark in figure.marks if isinstance(mark, Point) and mark.at == right.b), "")
    numbers, scale = dict(_written(figure, right.step)), figure.scale.right.told
    if name:
        timed = any(not text[-1].isdigit() for text in numbers.values())
        yield _named(end, name, "" if timed else scale.unit)
    for x, text in numbers.items():
        yield from _tick(x + 0j, -1j, text)
    if not numbers:
        yield from _numbered(scale, complex(max(right.a.real, 0.0), right.a.imag), end - 4.0)
        if start != right.a:
            yield from _numbered(scale, complex(0.0, right.a.imag), start)


def _written(figure: Figure, step: int) -> Iterator[tuple[float, str]]:
    """The numbers that stand below an axis since this step, each with its place on it."""
    for mark in figure.marks:
        if isinstance(mark, (Point, Note)) and mark.step == step and _BELOW < mark.at.imag < -NEAR:
            text = mark.words.en if isinstance(mark, Note) else mark.label if mark.label.endswith("°") else ""
            if text[:1].isdigit():
                yield mark.at.real, text


def _tick(at: complex, side: complex, text: str) -> Iterator[Mark]:
    """A tick across an axis, with what is written on this side of it, if anything."""
    yield Segment(a=at - _TICK * side, b=at + _TICK * side, role=Role.CONSTRUCTION, step=1)
    if text:
        yield Note(at=at + _TICK * side, words=Words.same(text), side=side, step=1)


def _upwards(figure: Figure, up: Vector, box: Box) -> Iterator[Mark]:
    """The axis upwards, right through the frame where something lies below the other axis."""
    name = next((mark.label for mark in figure.marks if isinstance(mark, Point) and mark.at == up.b), "")
    foot = complex(up.a.real, box[0].imag + EDGE if up.a.imag < -NEAR else 0.0)
    name = name.removesuffix(f"/{braced(figure.scale.unit)}")
    yield from _scaled(figure, name, foot, complex(up.a.real, box[1].imag - EDGE))


def _scaled(figure: Figure, name: str, foot: complex, end: complex) -> Iterator[Mark]:
    """An axis from foot to end with its name and its numbers; zero is at the height 0."""
    yield Vector(a=foot, b=end, role=Role.DIRECTION, step=1)
    if name:
        yield _named(end, name, figure.scale.told.unit)
    zero = complex(foot.real, 0.0)
    yield from _numbered(figure.scale, zero, end - 4.0j)
    if foot.imag < -NEAR:
        yield from _numbered(figure.scale, zero, foot)


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
    return box, (base, *_scaled(figure, "E", foot, end))


def _numbered(scale: Scale, zero: complex, end: complex) -> Iterator[Mark]:
    """A tick every round number from zero to the end, some 10 mm apart, a number at every other, at each where
    they are wide apart; negative to the left and below."""
    per_mm = scale.told.value * (MILLI if scale.unit == _METRE else 1.0)
    apart = round_up(_APART * per_mm, _ROUND) / per_mm
    way = (end - zero) / abs(end - zero)
    side, sign = (-1j if way.imag == 0 else -1 + 0j), (1.0 if way.real + way.imag > 0 else -1.0)
    for n in range(1, int(abs(end - zero) / apart) + 1):
        text = number(sign * n * apart * per_mm, 3) if n % 2 == 0 or apart >= _WIDE else ""
        yield from _tick(zero + n * apart * way, side, text)


def _named(at: complex, letter: str, unit: str) -> Mark:
    """The letter of an axis, with its unit; a derivative in brackets, its d upright. Lengths are told in mm."""
    unit = _MILLIMETRE if unit == _METRE else unit
    told = braced(unit)
    name = "/".join(f"d${part[1:]}$" for part in letter.split("/")) if "/" in letter else f"${letter}$"
    return Note(at=at, words=Words.same(f"{f'({name})' if '/' in letter else name}/{told}" if unit else name), step=1)
