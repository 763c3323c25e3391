"""The axes of a blank diagram: their names, units and numbers."""

from __future__ import annotations

from collections.abc import Iterator

from ....algebra.quantity import number
from ....algebra.rounding import braced
from ....board.construction import Figure, Scale
from ....board.paper.marks import Mark, Note, Point, Role, Segment, Vector
from ....board.paper.scales import round_up
from ....words import Words
from .known import NEAR
from .through import EDGE, Box

_TICK, _APART = 1.5, 10.0  # mm: half a tick, from tick to tick at least
_WIDE = 15.0  # mm: from tick to tick, where each has its number
_METRE, _MILLIMETRE, MILLI = "m", "mm", 1e3
_ROUND = (1.0, 2.0, 5.0, 10.0)
_ROOM = 3.0  # mm: left of the axis upwards the other one begins no farther off beside a number
_BELOW = -10.0  # mm: no lower stand the numbers of an axis


def axes(figure: Figure) -> tuple[Vector, Vector] | None:
    """The axis to the right and the one upwards, where a figure has them."""
    arrows = [mark for mark in figure.marks if isinstance(mark, Vector) and mark.role is Role.DIRECTION]
    right = next((one for one in arrows if abs(one.b.imag - one.a.imag) < NEAR), None)
    up = next((one for one in arrows if abs(one.b.real - one.a.real) < NEAR), None)
    return None if right is None or up is None else (right, up)


def across(figure: Figure, right: Vector, box: Box) -> Iterator[Mark]:
    """The axis to the right with the numbers that the drawing has."""
    end = complex(box[1].real - EDGE, right.b.imag)
    start = complex(box[0].real + EDGE, right.a.imag) if right.a.real < -NEAR else right.a
    yield Vector(a=start, b=end, role=Role.DIRECTION, step=1)
    name = next((mark.label for mark in figure.marks if isinstance(mark, Point) and mark.at == right.b), "")
    numbers, scale = dict(_written(figure, right.step)), figure.scale.right.told
    if name:
        name = name.removesuffix(f"/{braced(scale.unit)}")
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


def upwards(figure: Figure, up: Vector, box: Box) -> Iterator[Mark]:
    """The axis upwards, right through the frame where something lies below the other axis."""
    name = next((mark.label for mark in figure.marks if isinstance(mark, Point) and mark.at == up.b), "")
    foot = complex(up.a.real, box[0].imag + EDGE if up.a.imag < -NEAR else 0.0)
    name = name.removesuffix(f"/{braced(figure.scale.unit)}")
    yield from scaled(figure, name, foot, complex(up.a.real, box[1].imag - EDGE))


def scaled(figure: Figure, name: str, foot: complex, end: complex) -> Iterator[Mark]:
    """An axis from foot to end with its name and its numbers; zero is at the height 0."""
    yield Vector(a=foot, b=end, role=Role.DIRECTION, step=1)
    if name:
        yield _named(end, name, figure.scale.told.unit)
    zero = complex(foot.real, 0.0)
    yield from _numbered(figure.scale, zero, end - 4.0j)
    if foot.imag < -NEAR:
        yield from _numbered(figure.scale, zero, foot)
        found = axes(figure)
        if found is None or found[0].a.real > foot.real - _ROOM:  # else the axis to the right begins under it
            yield from _tick(zero, -1 + 0j, "0")


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
