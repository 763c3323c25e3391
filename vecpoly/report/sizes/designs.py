"""The given lengths of a mechanism to be found, between the points they name, on the sketch of what is given."""

from __future__ import annotations

import cmath
import re
from collections.abc import Iterator, Mapping, Sequence
from math import pi, radians

from ...board.construction import Figure
from ...board.paper.marks import AngleMark, Dot, Ground, Mark, Point, Role, Segment
from ...designs.base import Design
from ...errors import VecpolyError
from ...units.reading import Dim, read
from .lines import AXIS, angle, letter, ray, span

_BAR = re.compile(r"l_\{?([A-Z])([A-Z])\}?")  # as data name it, and as statements do
_ANGLE = re.compile(r"(-?[\d.]+) deg")
_RANGE = " … "  # between the ends of the range through which a link is turned
_ENDS = (("E_1", "E_2"), ("F_1", "F_2"), ("C_1", "C_2"))  # of a stroke
_LIKE = 2e-3  # part of a length by which it may be drawn differently
_UNDER, _OVER = 11.0, 7.0  # mm: a dimension under two pivots, over two places
_SWING, _STROKE = "ψ", "H"
_TURNED = (("φ", "A", "B"), ("φ_1", "A", "B_1"), ("ψ_1", "D", "C_1"))  # angles, pivots and pins


def design(subject: Design, told: str, figure: Figure, *, true: bool = True) -> Iterator[Mark]:
    """Each length that the statement or the data name and whose ends are given; the stroke of a slider; the swing of a
    rocker. told: the statement; true: whether what is given is drawn as long as it is."""
    spots = {m.label: m.at for m in figure.marks if isinstance(m, Point) and m.dot is not Dot.NONE}
    data = dict(subject.given())
    bars: dict[frozenset[str], str] = {}
    for found in _BAR.finditer(" ".join((told, *data))):
        bars.setdefault(frozenset(found.groups()), found[0])
    stroke = (_STROKE,) if _STROKE in data or f"${_STROKE}$" in told else ()
    for symbol in (*bars.values(), *stroke):
        named = _BAR.fullmatch(symbol)
        ends = _stroke(spots) if named is None else _between(named[1], named[2], spots)
        for a, b in ends:
            if not true or (text := data.get(symbol)) is None or _is_drawn(text, abs(b - a) * figure.scale.value):
                yield from _length(figure, a, b, symbol)
                break
    yield from _offset(data.get("e", ""), figure, spots)
    yield from _turned(data, figure, spots)
    if any(symbol == _SWING for symbol, _ in subject.given()):
        yield from _swing(figure, spots)


def _between(one: str, other: str, spots: dict[str, complex]) -> Iterator[tuple[complex, complex]]:
    """Where these two letters stand, with the number of the first position where there are several."""
    for first in (one, f"{one}_1"):
        for second in (other, f"{other}_1"):
            if first in spots and second in spots:
                yield spots[first], spots[second]


def _stroke(spots: dict[str, complex]) -> Iterator[tuple[complex, complex]]:
    return ((spots[a], spots[b]) for a, b in _ENDS if a in spots and b in spots)


def _offset(text: str, figure: Figure, spots: dict[str, complex]) -> Iterator[Mark]:
    """The line of the crank's pivot beside that of a slider's stroke, and how far they are apart."""
    if not text or {"A", "D"} & set(spots) or not (ends := next(_stroke(spots), None)):
        return
    a, b = sorted(ends, key=lambda at: at.real)
    along, off = (b - a) / abs(b - a), 1j * read(text, Dim.LENGTH).si / figure.scale.value
    yield Segment(a=a + off * along, b=b + off * along, role=Role.CENTRE, step=1)
    yield from span(b, b + off * along, "e", _OVER * along)


def _is_drawn(text: str, metres: float) -> bool:
    try:
        return abs(read(text, Dim.LENGTH).si - metres) < _LIKE * metres
    except VecpolyError:
        return False


def _length(figure: Figure, a: complex, b: complex, symbol: str) -> Iterator[Mark]:
    """Beside the line that joins them; where none does, on a line of its own, under the pivots."""
    joined = any(isinstance(m, Segment) and _same(m, a, b) for m in figure.marks)
    if joined:
        taken = any(isinstance(m, Point) and abs(m.at - (a + b) / 2) < AXIS / 4 for m in figure.marks)
        yield letter((a + 3 * b) / 4 if taken else (a + b) / 2, symbol)
        return
    a, b = sorted((a, b), key=lambda at: (at.real, at.imag))
    grounded = [m.at for m in figure.marks if isinstance(m, Ground)]
    normal = -1j * (b - a) / abs(b - a)
    off = _UNDER if any(abs(at - end) < 1e-6 for at in grounded for end in (a, b)) else _OVER
    yield from span(a, b, symbol, off * normal)


def _same(line: Segment, a: complex, b: complex) -> bool:
    return min(abs(line.a - a) + abs(line.b - b), abs(line.a - b) + abs(line.b - a)) < 1e-6


def _turned(data: Mapping[str, str], figure: Figure, spots: dict[str, complex]) -> Iterator[Mark]:
    """Each angle of a link on the frame, from the horizontal through its pivot: of a range to its pin wherever that
    stands, a single one to its pin where that stands so, else to a thin line of that direction."""
    for symbol, pivot, pin in _TURNED:
        if _RANGE in data.get(symbol, "") and {pivot, pin} <= spots.keys() and not _marked(figure.marks, symbol):
            yield from angle(spots[pivot], cmath.phase(spots[pin] - spots[pivot]) % (2 * pi), symbol, AXIS)
        found = _ANGLE.fullmatch(data.get(symbol, ""))
        if found is None or pivot not in spots or _marked(figure.marks, symbol):
            continue
        told, at = radians(float(found[1])) % (2 * pi), spots[pivot]
        if pin not in spots:
            yield from ray(at, told, 1.5 * AXIS)
        if pin not in spots or abs(cmath.phase(spots[pin] - at) % (2 * pi) - told) < _LIKE:
            yield from angle(at, told, symbol, AXIS)


def _swing(figure: Figure, spots: dict[str, complex]) -> Iterator[Mark]:
    """ψ between the two positions of a rocker, where it isn't marked yet."""
    if {"D", "C_1", "C_2"} <= set(spots) and not _marked(figure.marks, _SWING):
        pivot, first, second = (spots[name] for name in ("D", "C_1", "C_2"))
        start, sweep = cmath.phase(second - pivot), cmath.phase((first - pivot) / (second - pivot))
        yield AngleMark(at=pivot, radius=AXIS, start=start, sweep=sweep, label=_SWING, step=1)


def _marked(marks: Sequence[Mark], name: str) -> bool:
    return any(isinstance(mark, AngleMark) and mark.label.startswith(name) for mark in marks)
