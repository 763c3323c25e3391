"""A linkage that is given by its lengths beside what is sought: its pins stand on the sketch of what is given."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import chain

from ...board.construction import Figure
from ...board.paper.marks import Dot, Mark, Point, Role, Segment
from ...designs.base import Design
from ...errors import VecpolyError
from ...units.reading import Dim, read

_BAR = re.compile(r"l_\{?([A-Z])([A-Z])\}?")
_LIKE = 2e-3  # part of a length by which it may be drawn otherwise


def assembled(subject: Design, figure: Figure, marks: Sequence[Mark]) -> tuple[Mark, ...]:
    """Each pin that two given bars join to what is shown, with these bars, in the first position."""
    shown = {m.label: m.at for m in marks if isinstance(m, Point) and m.dot is not Dot.NONE}
    drawn = {m.label: m for m in figure.marks if isinstance(m, Point) and m.dot is Dot.JOINT}
    bars = dict(_bars(subject))
    letters = dict.fromkeys(chain.from_iterable(bars))
    found: list[Mark] = []
    for letter in (one for one in letters if _at(one, shown) is None):
        pin = drawn.get(f"{letter}_1") or drawn.get(letter)
        ends = [(_at(_other(bar, letter), shown), size) for bar, size in bars.items() if letter in bar]
        if pin is None or len(ends) < 2:
            continue
        true = [at for at, size in ends if at is not None and _is(abs(pin.at - at) * figure.scale.value, size)]
        if len(true) == len(ends):
            found += [Segment(a=at, b=pin.at, role=Role.GIVEN, step=1) for at in true]
            found.append(Point(at=pin.at, label=pin.label, dot=Dot.JOINT, step=1))
    return tuple(found)


def _bars(subject: Design) -> Iterator[tuple[tuple[str, str], float]]:
    """The given lengths (m) between two letters."""
    for symbol, text in subject.given():
        if (bar := _BAR.fullmatch(symbol)) is not None:
            try:
                yield (bar[1], bar[2]), read(text, Dim.LENGTH).si
            except VecpolyError:
                continue


def _at(letter: str, shown: dict[str, complex]) -> complex | None:
    return shown.get(letter, shown.get(f"{letter}_1"))


def _other(bar: tuple[str, str], letter: str) -> str:
    return bar[1] if bar[0] == letter else bar[0]


def _is(size: float, told: float) -> bool:
    return abs(size - told) < _LIKE * told
