"""Links as written (``BC: 350 mm``, ``block: F``, ``slot: G``): their first points, guide lines and gears."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from functools import partial

from ..errors import FaultError
from ..mechanism.model import Circle
from ..units import Dim, positive, read
from .draft import ANGLE_FROM, ONE, TWO, Draft, Line, letters_of, ray
from .faults import meant
from .places import place
from .problem import Shape
from .source import Value

_SINGLE = {"block": Shape.BLOCK, "slot": Shape.SLOT, "rod": Shape.ROD, "gear": Shape.GEAR}
LINK_KEYS = (*_SINGLE, "radius")


def read_link(name: str, data: Value) -> Draft:
    """One entry of `links`."""
    if not isinstance(data, dict) or not data:
        raise FaultError(f"link {name} needs a mapping such as {{BC: 350 mm}} or {{block: C}}")
    draft = Draft(name)
    for key in data:
        _known(key)
    _base(draft, data)
    for key, value in data.items():
        if ONE.fullmatch(key):
            _within(key, partial(place, draft, key, value))
    if isinstance(data.get("slot"), dict):
        _within("slot", lambda: _line(draft, data["slot"]))
    if "gear" in data:
        _gear(draft, data)
    elif "radius" in data:
        raise FaultError("a radius belongs to a gear; write gear: C, radius: 60 mm", "radius")
    return draft


def _within(key: str, act: Callable[[], None]) -> None:
    try:
        act()
    except FaultError as fault:
        raise FaultError(fault.text, key, *fault.path) from None


def _known(key: str) -> None:
    if not (key in LINK_KEYS or ONE.fullmatch(key) or TWO.fullmatch(key)):
        raise FaultError(
            f"'{key}' is no key of a link (two letters with a length, a letter with its place, or "
            f"{', '.join(LINK_KEYS)}){meant(key, LINK_KEYS) if len(key) > 2 else ''}",
            key,
        )


def _base(draft: Draft, data: Mapping[str, Value]) -> None:
    """The first points: a length such as BC, or the one pin of a block, slot, rod or gear."""
    bases = [key for key in data if TWO.fullmatch(key)]
    singles = [key for key in _SINGLE if isinstance(data.get(key), str)]
    if len(bases) > 1:
        raise FaultError(
            f"{bases[1]}: link {draft.name} already has the length {bases[0]}; set further points out, e.g. "
            f"E: {{BE: 60 mm, CE: 70 mm, side: left of BC}}",
            bases[1],
        )
    if bases:
        first, second = letters_of(bases[0])
        _within(bases[0], lambda: _bar(draft, first, second, data[bases[0]]))
    for key in singles:
        letter = str(data[key])
        if not ONE.fullmatch(letter):
            raise FaultError(f"'{letter}' is no letter of a point, such as C", key)
        if not bases and not draft.points:
            draft.shape, draft.points[letter] = _SINGLE[key], 0j
        elif letter not in draft.points and key != "gear":
            raise FaultError(f"point '{letter}' is not on link {draft.name}", key)
        if key in ("slot", "rod"):
            draft.line = Line(draft.points[letter], 0.0, letter)
    slot = data.get("slot")
    if not draft.points and isinstance(slot, dict) and ONE.fullmatch(str(slot.get("through"))):
        draft.shape, draft.points[str(slot["through"])] = Shape.SLOT, 0j
    if not draft.points:
        raise FaultError(
            f"link {draft.name} has no length: write two letters and a length, e.g. {{BC: 350 mm}}, "
            "or the one pin of a block, slot, rod or gear, e.g. {block: C}"
        )


def _bar(draft: Draft, first: str, second: str, value: Value) -> None:
    if first == second:
        raise FaultError(f"a length from {first} to itself")
    length = positive(value)
    draft.points |= {first: 0j, second: complex(length.si)}
    draft.note(f"l_{first}{second}", length.si, length.text)


def _line(draft: Draft, data: Mapping[str, Value]) -> None:
    """slot: {through: D, angle: 60 deg from CD, left: 10 mm}: no plain line through the one pin."""
    for key in data:
        if key not in ("through", "angle", "left", "right"):
            raise FaultError(
                f"'{key}' is no key of a slot{meant(key, ('through', 'angle', 'left', 'right'))}", key
            )
    letter = str(data.get("through", ""))
    if not ONE.fullmatch(letter):
        raise FaultError(
            "through which point does the slot pass? write e.g. slot: {through: D, angle: 60 deg from CD}"
        )
    if letter not in draft.points:
        raise FaultError(
            f"point '{letter}' is not on link {draft.name}{meant(letter, draft.points)}", "through"
        )
    turn = 0j + 1
    if "angle" in data:
        m = ANGLE_FROM.fullmatch(str(data["angle"]))
        if m is None:
            raise FaultError("write the angle from a ray of the link, e.g. 60 deg from CD", "angle")
        turn = ray(draft, m[2])[2] * cmath.exp(1j * read(m[1], Dim.ANGLE).si)
    left = (
        read(data["left"], Dim.LENGTH).si if "left" in data else -read(data.get("right", "0"), Dim.LENGTH).si
    )
    draft.line = Line(draft.points[letter] + 1j * left * turn, cmath.phase(turn), letter)


def _gear(draft: Draft, data: Mapping[str, Value]) -> None:
    centre = str(data["gear"])
    if centre not in draft.points:
        raise FaultError(
            f"the centre '{centre}' is not on link {draft.name}{meant(centre, draft.points)}", "gear"
        )
    if "radius" not in data:
        raise FaultError("a gear needs its pitch radius; write gear: C, radius: 60 mm")
    radius = positive(data["radius"])
    draft.gear = Circle(link=draft.name, centre=centre, radius=radius.si)
    draft.note(f"r_{draft.name}", radius.si, radius.text)
