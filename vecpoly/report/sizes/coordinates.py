"""What is given by coordinates, on the sketch of what is given: the axes, and the lines on which a pin is to lie."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ...board.construction import Figure
from ...board.paper.extent import bounds
from ...board.paper.marks import Mark, Role, Segment, Vector
from ...designs.base import Design
from ...designs.crank_rocker import CrankRocker
from ...designs.inversion.positions import Positions
from ...errors import VecpolyError
from ...units.reading import Dim, read
from .lines import NEAR, letter, span

_LINE = re.compile(r"([xy])_\{?([AD])\}?")  # of data: y_A; that of a moving pin lies on its body
_PAST = 0.12  # of the extent: by which axes and lines run past what is given
_WAYS = {"x": (1 + 0j, 1j), "y": (1j, 1 + 0j)}  # across a line x = ..., along it


def coordinates(subject: Design, figure: Figure, marks: Sequence[Mark]) -> tuple[Mark, ...]:
    """The axes of positions that are given by coordinates, or of the line of a crank's pivot, and each line x = ... or
    y = ... that the data name, with the letters of the pins that lie on it; at the size of the figure."""
    if not isinstance(subject, Positions) and not (isinstance(subject, CrankRocker) and subject.A is not None):
        return ()
    low, high = bounds(marks)
    lines = dict[tuple[str, float], list[str]]()
    for symbol, text in subject.given():
        if (found := _LINE.fullmatch(symbol)) and (size := _metres(text)) is not None:
            lines.setdefault((found[1], size / figure.scale.value), []).append(found[2])
    places = [0j, low, high, *(at * _WAYS[axis][0] for axis, at in lines)]
    low = complex(min(at.real for at in places), min(at.imag for at in places))
    high = complex(max(at.real for at in places), max(at.imag for at in places))
    past = _PAST * max((high - low).real, (high - low).imag)
    axes = _axes(high, past)
    return (*axes, *(mark for line, pins in lines.items() for mark in _line(*line, pins, (low, high), past)))


def _metres(text: str) -> float | None:
    try:
        return read(text, Dim.LENGTH).si
    except VecpolyError:
        return None


def _axes(high: complex, past: float) -> Iterator[Mark]:
    """x and y from the origin, thin, with arrowheads."""
    for way, name, size in ((1 + 0j, "x", high.real), (1j, "y", high.imag)):
        end = way * (size + past)
        yield Vector(a=0j, b=end, role=Role.CONSTRUCTION, step=1)
        yield letter(end, name)


def _line(axis: str, at: float, pins: Sequence[str], box: tuple[complex, complex], past: float) -> Iterator[Mark]:
    """A line of pins right through what is given, and how far it is from the axis."""
    across, along = _WAYS[axis]
    ends = [(end * along.conjugate()).real for end in box]
    start, end = (at * across + along * size for size in (min(ends) - past, max(ends) + past))
    yield Segment(a=start, b=end, role=Role.CENTRE, step=1)
    yield letter(start, ", ".join(pins))
    if abs(at) > NEAR:
        yield from span(0j, at * across, f"{axis}_{pins[0]}", along * (min(ends) - past / 2))
