"""The lines for what is read off a figure: one with its name for each quantity that is asked, l_AB = ___ mm × μ_l =
___ mm, in the unit of the data and of the table of results; of what is computed and then laid off, as a Coriolis
acceleration, the other way round, a^k = ___ m/s² = ___ mm × μ_a; where there is no room for that the length on paper
alone, then none: the results have a table. What is read on the way has its place there, or in the squares."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from enum import IntEnum
from math import ceil
from typing import NamedTuple

from ....board.acts import Act, Answer, Area, Compute, Gauge, LayOff, Measure
from ....board.construction import Construction, Figure, Reading
from ....board.paper.marks import Mark, Note, Role, Segment
from ....board.place import Pane, called
from ....drawing.style import NOTE
from ....printed.units import printed_unit
from ....typeset.words import layout_words
from ....words import Words
from ...statement.further import doubtful, further

READ = "readings"  # of what is written there
LINE, DROP, GAP = 7.0, 1.6, 2.5  # mm: height of a line; of its rule below the middle of the words; behind these
NAMED = 10  # quantities that have a line each; more have the table of results
_ROOM, _LONGEST, _BEHIND = 16.0, 40.0, 0.5  # mm for a number to be written: at least, at most; behind it
_MOST = 4  # lines in full
_APART = 5.0  # mm between two quantities on a line
_DEGREE = "°"
_SYMBOL = re.compile(r"\$([^$]+?)(?:/μ[^$]*)?\$")  # before a line, with the scale by which its value is divided
_UNITS = {"deg": _DEGREE}  # where not as printed
AWAY = "^{∞}"  # of a centre, which tells where it lies


class Form(IntEnum):
    """How much a line tells: length on paper and value; what is read alone; there is no line."""

    WHOLE = 0
    SHORT = 1
    NONE = 2


class Blank(NamedTuple):
    """A quantity to be read: its symbol, the unit in which it is read off the paper; μ and unit of its value, of a
    length that is brought to its value by a scale alone; placed: a place, of which both coordinates are read; laid:
    whether its value is computed and its length laid off."""

    symbol: str
    paper: str
    scale: str = ""
    unit: str = ""
    placed: bool = False
    laid: bool = False

    def texts(self, form: Form) -> tuple[str, ...]:
        """What stands before each room for a number, and behind the last."""
        if self.placed:
            return f"${self.symbol}$: $x$ =", "$y$ =", self.paper
        if form is Form.WHOLE and self.scale and self.laid:
            return f"${self.symbol}$ =", f"{self.unit} =", f"{self.paper} × ${self.scale}$"
        if form is Form.WHOLE and self.scale:
            return f"${self.symbol}$ =", f"{self.paper} × ${self.scale}$ =", self.unit
        if self.paper == _DEGREE:
            return f"${self.symbol}$ =", self.paper
        return f"${self.symbol}/{self.scale}$ =" if self.scale else f"${self.symbol}$ =", self.paper


class Readings(NamedTuple):
    """What is read off a figure that is asked, and in which form it is written, in so many columns."""

    blanks: tuple[Blank, ...]
    form: Form = Form.WHOLE
    columns: int = 1

    @property
    def lines(self) -> int:
        """How many lines there are."""
        return ceil(len(self.blanks) / self.columns)

    @property
    def wide(self) -> float:
        """How wide a frame should be for them (mm)."""
        return self.columns * (_cell(self.blanks, self.form) + _APART) + _APART

    def formed(self, form: Form, width: float) -> Readings | None:
        """In this form, in as many columns as a frame of this width has."""
        if form is Form.NONE:
            return None
        there = int((width - _APART) / (_cell(self.blanks, form) + _APART))
        lines = ceil(len(self.blanks) / max(1, min(there, len(self.blanks))))
        if form is Form.WHOLE and lines > _MOST:
            return self.formed(Form.SHORT, width)
        return Readings(self.blanks, form, ceil(len(self.blanks) / lines))

    def written(self, left: complex, right: float) -> Iterator[Mark]:
        """From the first line down, between the middle of its left end and this edge."""
        step = (right - left.real + _APART) / self.columns
        slots = _slots(self.blanks, self.form)
        rule = min(_LONGEST, *((step - _APART - _words(one)) / (len(one) - 1) for one in slots.values()))
        for n, one in enumerate(self.blanks):
            at, texts = left + n % self.columns * step - 1j * (n // self.columns) * LINE, one.texts(self.form)
            yield from _rooms(texts, slots[len(texts)], at, rule)


def readings(construction: Construction, figure: Figure) -> Readings | None:
    """What is read off this figure; None if nothing is that is asked, or more than have a line each."""
    if not is_measured(construction, figure):
        return None
    blanks = tuple(dict.fromkeys(_asked(construction, figure)))
    return Readings(blanks) if 0 < len(blanks) <= NAMED else None


def lined(sheets: Construction) -> frozenset[str]:
    """The symbols of what has a line of its own in one of these frames."""
    notes = (mark for figure in sheets.figures for mark in figure.marks if isinstance(mark, Note) and mark.key == READ)
    found = (_SYMBOL.match(mark.words.en) for mark in notes)
    return frozenset(match[1] for match in found if match is not None)


def valued(sheets: Construction) -> frozenset[str]:
    """The symbols of what has its value too in one of these frames: brought there by the scale, an angle, a place."""
    notes = (mark for figure in sheets.figures for mark in figure.marks if isinstance(mark, Note) and mark.key == READ)
    told = [mark.words.en for mark in notes]
    found = ((_SYMBOL.match(one), told[n + 1 : n + 3]) for n, one in enumerate(told) if "/μ" not in one)
    return frozenset(match[1] for match, behind in found if match is not None and _has_value(behind))


def _has_value(behind: Sequence[str]) -> bool:
    """Whether rooms that are followed by these have the value: with the scale between two, in degrees, or for y."""
    return behind[0] in (_DEGREE, "$y$ =") or any("×" in one for one in behind)


def is_measured(construction: Construction, figure: Figure) -> bool:
    """Whether anything is read off it."""
    place = _place(figure)
    return any(isinstance(act, Area | Gauge | Measure) and act.figure == place for act in construction.acts)


def _place(figure: Figure) -> str:
    """The figure as acts tell it."""
    return called(figure.view if not figure.name else Pane(figure.view, figure.name))


def _asked(construction: Construction, figure: Figure) -> Iterator[Blank]:
    """The lengths, angles and places that are asked and read off here; what belongs to a further solution only where
    the figure is its own."""
    written = {act.key: act for act in construction.acts if isinstance(act, Answer)}
    place, like = _place(figure), [one for one in construction.figures if one.scale.symbol == figure.scale.symbol]
    laid = {act.key for act in construction.acts if isinstance(act, LayOff) and act.figure == place}
    plainly = {one.line for one in construction.readings.values() if not one.factor}  # F_I2 = m_2 a_S2 is no length
    more = further(construction.readings) if doubtful(figure.title) == figure.title else ()
    for key, one in ((key, one) for key, one in construction.readings.items() if key not in more):
        kind = Gauge if one.mm is None else Measure
        here = place == _read_on(written.get(key), construction.acts, kind)
        if _is_place(one):
            if place in {_read_on(written.get(key), construction.acts, sort) for sort in (Measure, Gauge)}:
                yield Blank(one.symbol.removesuffix(AWAY), "mm", placed=True)
        elif one.mm is not None and _is_told(one, figure, here or len(like) == 1, here):
            if not one.factor or one.line not in plainly:
                yield _length(one, laid=key in laid)
        elif one.mm is None and one.unit == "deg" and here:
            yield Blank(one.symbol, _DEGREE)


def _is_told(one: Reading, figure: Figure, likely: bool, here: bool) -> bool:
    """Whether a length has a scale of this figure: that upwards, of one that is likely read here; that to the right."""
    return (likely and one.scale == figure.scale.symbol) or (here and one.scale == figure.scale.right.symbol)


def _is_place(one: Reading) -> bool:
    """Whether it has two coordinates, or lies at infinity, which nothing tells."""
    return one.mm is None and ((one.unit == "m" and one.vector is not None) or one.symbol.endswith(AWAY))


def _length(one: Reading, *, laid: bool) -> Blank:
    """A length times more than a scale, v_C = ω_2 μ_l P_24C, is asked by its own letters."""
    if one.factor:
        return Blank(one.line, "mm")
    unit = printed_unit(one.unit)[1]
    return Blank(one.symbol, "mm", one.scale, _UNITS.get(unit, unit), laid=laid and bool(one.scale))


def _read_on(answer: Answer | None, acts: Sequence[Act], with_: type[Gauge | Measure]) -> str:
    """The figure off which this was read first, with the rule or with the protractor."""
    todo, found = [*answer.inputs] if answer is not None else [], dict[int, str]()
    while todo:
        one = acts[todo.pop()]
        if isinstance(one, with_):
            found[one.number] = one.figure
        elif isinstance(one, Compute):
            todo += one.inputs
    return found[min(found)] if found else ""


def _cell(blanks: Sequence[Blank], form: Form) -> float:
    """The room (mm) of the longest line of these, the rules of all of them one under the other."""
    return max(_words(one) + _ROOM * (len(one) - 1) for one in _slots(blanks, form).values())


def _slots(blanks: Sequence[Blank], form: Form) -> dict[int, tuple[float, ...]]:
    """Of lines of so many texts, how wide the widest of each place is (mm); that before the first rule of all lines."""
    lines = [[*map(_wide, one.texts(form))] for one in blanks]
    first = max(line[0] for line in lines)
    alike = {count: [line[1:] for line in lines if len(line) == count] for count in map(len, lines)}
    return {count: (first, *map(max, *some, some[0])) for count, some in alike.items()}


def _words(slots: Sequence[float]) -> float:
    """How wide a line is without its rules (mm)."""
    return sum(slots) + (GAP + _BEHIND) * (len(slots) - 1)


def _wide(text: str) -> float:
    return layout_words(text, NOTE).width if text else 0.0


def _rooms(texts: Sequence[str], slots: Sequence[float], at: complex, rule: float) -> Iterator[Mark]:
    """The texts of a line, each in its place, with a rule of this length between each two of them."""
    for n, (text, slot) in enumerate(zip(texts, slots, strict=True)):
        yield Note(at=at, words=Words.same(text), side=1 + 0j, step=1, key=READ)
        at += slot + GAP
        if n < len(texts) - 1:
            start = at - 1j * DROP
            yield Segment(a=start, b=start + rule, role=Role.CONSTRUCTION, step=1, key=READ)
            at += rule + _BEHIND
