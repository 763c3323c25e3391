"""Links as written (``BC: 350 mm``, ``F: {along: BC, at: 175 mm, left: 220 mm}``) to links of the model."""

from __future__ import annotations

import cmath
import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from ..mechanism.model import ByAngle, ByLengths, ByOffsets, Circle, Link, Placement, Side
from .faults import FaultError, meant
from .problem import Datum, Shape
from .source import Value
from .units import Dim, positive, read

LETTER = r"[A-Z][a-z'′]?"
_ONE = re.compile(LETTER)
_TWO = re.compile(rf"({LETTER})({LETTER})")
_ANGLE = re.compile(rf"(.+?) from (line|{LETTER}{LETTER})")
_SIDE = re.compile(rf"(left|right) of ({LETTER})({LETTER})")
_SINGLE = {"block": Shape.BLOCK, "slot": Shape.SLOT, "rod": Shape.ROD, "gear": Shape.GEAR}
LINK_KEYS = (*_SINGLE, "radius")


@dataclass(frozen=True, slots=True)
class Line:
    """A guide line on a link, in its coordinates; `through` is the letter from which it is set out."""

    origin: complex
    direction: float
    through: str


@dataclass(slots=True)
class Draft:
    """A link while it is being read."""

    name: str
    shape: Shape = Shape.BAR
    points: dict[str, complex] = field(default_factory=dict)
    placements: list[Placement] = field(default_factory=list)
    line: Line | None = None
    gear: Circle | None = None
    lengths: list[Datum] = field(default_factory=list)

    def link(self) -> Link:
        """The link of the model."""
        return Link(name=self.name, points=self.points, placements=tuple(self.placements))

    def note(self, symbol: str, si: float, text: str) -> None:
        """Remember a length for 已知."""
        self.lengths.append(Datum(symbol=symbol, si=si, text=text))


def letters_of(word: str) -> tuple[str, str]:
    """'BC' to ('B', 'C'); raises FaultError otherwise."""
    m = _TWO.fullmatch(word)
    if m is None:
        raise FaultError(f"'{word}' is not two letters such as BC")
    return m[1], m[2]


def read_link(name: str, data: Value) -> Draft:
    """One entry of `links`."""
    if not isinstance(data, dict) or not data:
        raise FaultError(f"link {name} needs a mapping such as {{BC: 350 mm}} or {{block: C}}")
    draft = Draft(name)
    for key in data:
        _known(key)
    _base(draft, data)
    for key, value in data.items():
        if _ONE.fullmatch(key):
            _within(key, lambda key=key, value=value: _place(draft, key, value))
    if isinstance(data.get("slot"), dict):
        _within("slot", lambda: _line(draft, data["slot"]))
    if "gear" in data:
        _gear(draft, data)
    elif "radius" in data:
        raise FaultError("a radius belongs to a gear; write gear: C, radius: 60 mm", "radius")
    return draft


def _within(key: str, act: object) -> None:
    try:
        act()  # type: ignore[operator]
    except FaultError as fault:
        raise FaultError(fault.text, key, *fault.path) from None


def _known(key: str) -> None:
    if not (key in LINK_KEYS or _ONE.fullmatch(key) or _TWO.fullmatch(key)):
        raise FaultError(f"'{key}' is no key of a link (two letters with a length, a letter with its place, or "
                         f"{', '.join(LINK_KEYS)}){meant(key, LINK_KEYS) if len(key) > 2 else ''}", key)


def _base(draft: Draft, data: Mapping[str, Value]) -> None:
    """The first points: a length such as BC, or the one pin of a block, slot, rod or gear."""
    bases = [key for key in data if _TWO.fullmatch(key)]
    singles = [key for key in _SINGLE if isinstance(data.get(key), str)]
    if len(bases) > 1:
        raise FaultError(f"{bases[1]}: link {draft.name} already has the length {bases[0]}; set further points out, e.g. "
                         f"E: {{BE: 60 mm, CE: 70 mm, side: left of BC}}", bases[1])
    if bases:
        first, second = letters_of(bases[0])
        _within(bases[0], lambda: _bar(draft, first, second, data[bases[0]]))
    for key in singles:
        letter = str(data[key])
        if not _ONE.fullmatch(letter):
            raise FaultError(f"'{letter}' is no letter of a point, such as C", key)
        if not bases and not draft.points:
            draft.shape, draft.points[letter] = _SINGLE[key], 0j
        elif letter not in draft.points and key != "gear":
            raise FaultError(f"point '{letter}' is not on link {draft.name}", key)
        if key in ("slot", "rod"):
            draft.line = Line(draft.points[letter], 0.0, letter)
    if not draft.points:
        raise FaultError(f"link {draft.name} has no length: write two letters and a length, e.g. {{BC: 350 mm}}, "
                         "or the one pin of a block, slot, rod or gear, e.g. {block: C}")


def _bar(draft: Draft, first: str, second: str, value: Value) -> None:
    if first == second:
        raise FaultError(f"a length from {first} to itself")
    length = positive(value)
    draft.points |= {first: 0j, second: complex(length.si)}
    draft.note(f"l_{first}{second}", length.si, length.text)


def _place(draft: Draft, point: str, data: Value) -> None:
    """A further point of the link, by offsets, by an angle, or by two lengths."""
    if not isinstance(data, dict):
        raise FaultError(f"the place of {point} is missing; write e.g. {{along: BC, at: 175 mm, left: 220 mm}}")
    if point in draft.points:
        raise FaultError(f"point {point} is already on link {draft.name}")
    lengths = [key for key in data if _TWO.fullmatch(key)]
    for key in data:
        if key not in ("along", "at", "left", "right", "angle", "side", *lengths):
            raise FaultError(f"'{key}' is no key of a place{meant(key, ('along', 'at', 'left', 'right', 'angle', 'side'))}", key)
    if "along" in data:
        placement = _by_offsets(draft, point, data)
    elif "angle" in data:
        placement = _by_angle(draft, point, data, lengths)
    elif len(lengths) == 2:
        placement = _by_lengths(draft, point, data, lengths)
    else:
        raise FaultError(f"the place of {point} is incomplete; write along/at/left, or a length and an angle, "
                         "or two lengths and a side")
    draft.placements.append(placement[0])
    draft.points[point] = placement[1]


def ray(draft: Draft, word: str) -> tuple[tuple[str, ...], complex, complex]:
    """Base letters, start and unit vector of a ray on the link: 'BC', or along its guide line 'B' or 'line'."""
    line = draft.line or (Line(0j, 0.0, next(iter(draft.points))) if len(draft.points) == 1 else None)
    first, second = (word, "") if _ONE.fullmatch(word) or word == "line" else letters_of(word)
    if word == "line":
        first = line.through if line else ""
    if first and first not in draft.points:
        raise FaultError(f"point '{first}' is not on link {draft.name}{meant(first, draft.points)}")
    if second in draft.points and draft.points[second] != draft.points[first]:
        return (first, second), draft.points[first], cmath.exp(1j * cmath.phase(draft.points[second] - draft.points[first]))
    lined = draft.line is not None or draft.shape is Shape.BLOCK
    if line is None or first != line.through or not lined:
        raise FaultError(f"'{word}' is no ray of link {draft.name}, whose points are {', '.join(draft.points)}")
    return (first,), draft.points[first], cmath.exp(1j * line.direction)


def _by_offsets(draft: Draft, point: str, data: Mapping[str, Value]) -> tuple[Placement, complex]:
    for key in data:
        if key not in ("along", "at", "left", "right"):
            raise FaultError("does not go together with 'along'; write along, at and left or right", key)
    base, start, unit = ray(draft, str(data["along"]))
    at = read(data.get("at"), Dim.LENGTH)
    left = read(data["left"], Dim.LENGTH).si if "left" in data else -read(data.get("right", "0"), Dim.LENGTH).si
    draft.note(f"l_{base[0]}{point}" if left == 0 else f"{point}: {data['along']}", at.si, at.text)
    if left:
        side = "left" if "left" in data else "right"
        draft.note(f"{point}: {side}", abs(left), str(data[side]))
    return ByOffsets(point=point, base=base, along=at.si, left=left), start + unit * complex(at.si, left)


def _by_angle(draft: Draft, point: str, data: Mapping[str, Value], lengths: list[str]) -> tuple[Placement, complex]:
    m = _ANGLE.fullmatch(str(data["angle"]))
    if m is None or len(lengths) != 1:
        raise FaultError("write a length and the angle from a ray, e.g. {BE: 200 mm, angle: 50 deg from BC}", "angle")
    ends = letters_of(lengths[0])
    base, start, unit = ray(draft, m[2])
    if set(ends) != {base[0], point}:
        raise FaultError(f"the length must be {base[0]}{point}, from the start of the ray {m[2]}", lengths[0])
    angle, distance = read(m[1], Dim.ANGLE).si, positive(data[lengths[0]])
    draft.note(f"l_{lengths[0]}", distance.si, distance.text)
    draft.note(f"∠{point}{base[0]}{m[2][len(base[0]):] if m[2] != 'line' else ''}", angle, m[1])
    return (ByAngle(point=point, base=base, distance=distance.si, angle=angle),
            start + unit * cmath.rect(distance.si, angle))


def _by_lengths(draft: Draft, point: str, data: Mapping[str, Value], lengths: list[str]) -> tuple[Placement, complex]:
    m = _SIDE.fullmatch(str(data.get("side", "")))
    if m is None:
        raise FaultError(f"on which side is {point}? write e.g. side: left of BC")
    base = (m[2], m[3])
    (_, start, unit) = ray(draft, m[2] + m[3])
    found: dict[str, float] = {}
    for key in lengths:
        other = [letter for letter in letters_of(key) if letter != point]
        if len(other) != 1 or other[0] not in base:
            raise FaultError(f"the length must join {point} with {base[0]} or {base[1]}", key)
        length = positive(data[key])
        found[other[0]] = length.si
        draft.note(f"l_{key}", length.si, length.text)
    if set(found) != set(base):
        raise FaultError(f"two lengths are needed: {base[0]}{point} and {base[1]}{point}")
    apex = _apex(point, base, abs(draft.points[base[1]] - start), found[base[0]], found[base[1]])
    side = Side(m[1])
    local = apex if side is Side.LEFT else apex.conjugate()
    return ByLengths(point=point, base=base, lengths=(found[base[0]], found[base[1]]), side=side), start + unit * local


def _apex(point: str, base: tuple[str, str], c: float, p: float, q: float) -> complex:
    """Apex left of the base of length c at distances p and q from its ends."""
    x = (p * p - q * q + c * c) / (2 * c)
    square = p * p - x * x
    if square < -1e-12 * c * c:
        a, b = base
        raise FaultError(f"no triangle: {a}{point} = {p * 1e3:g} mm, {b}{point} = {q * 1e3:g} mm and {a}{b} = {c * 1e3:g} mm; "
                         f"the longest must be less than the sum of the other two ({max(c, p, q) * 1e3:g} > "
                         f"{(c + p + q - max(c, p, q)) * 1e3:g}); check the lengths")
    return complex(x, max(square, 0.0) ** 0.5)


def _line(draft: Draft, data: Mapping[str, Value]) -> None:
    """slot: {through: D, angle: 60 deg from CD, left: 10 mm}: a slot that is no plain line through the one pin."""
    for key in data:
        if key not in ("through", "angle", "left", "right"):
            raise FaultError(f"'{key}' is no key of a slot{meant(key, ('through', 'angle', 'left', 'right'))}", key)
    letter = str(data.get("through", ""))
    if not _ONE.fullmatch(letter):
        raise FaultError("through which point does the slot pass? write e.g. slot: {through: D, angle: 60 deg from CD}")
    if not draft.points:
        draft.shape, draft.points[letter] = Shape.SLOT, 0j
    if letter not in draft.points:
        raise FaultError(f"point '{letter}' is not on link {draft.name}{meant(letter, draft.points)}", "through")
    turn = 0j + 1
    if "angle" in data:
        m = _ANGLE.fullmatch(str(data["angle"]))
        if m is None:
            raise FaultError("write the angle from a ray of the link, e.g. 60 deg from CD", "angle")
        turn = ray(draft, m[2])[2] * cmath.exp(1j * read(m[1], Dim.ANGLE).si)
    left = read(data["left"], Dim.LENGTH).si if "left" in data else -read(data.get("right", "0"), Dim.LENGTH).si
    draft.line = Line(draft.points[letter] + 1j * left * turn, cmath.phase(turn), letter)


def _gear(draft: Draft, data: Mapping[str, Value]) -> None:
    centre = str(data["gear"])
    if centre not in draft.points:
        raise FaultError(f"the centre '{centre}' is not on link {draft.name}{meant(centre, draft.points)}", "gear")
    if "radius" not in data:
        raise FaultError("a gear needs its pitch radius; write gear: C, radius: 60 mm")
    radius = positive(data["radius"])
    draft.gear = Circle(link=draft.name, centre=centre, radius=radius.si)
    draft.note(f"r_{draft.name}", radius.si, radius.text)
