"""Where in a problem's values the quantities stand, and the names by which each may be varied: AB, phi, x_D, F ..."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import chain

from ...units.reading import Dim
from ..links.draft import ONE, PLACED
from ..schema.faults import Path
from ..text.source import Value
from .in_data import in_data
from .of_loads import of_load
from .slot import Slot, angle_span, keyed, there

_JOINT = (
    (re.compile(r"(?P<link>\d+[a-z']?) .*?\b(?P<name>[xy]) = (?P<it>.+?)(?= with | turned | at [A-Z]|$)"), Dim.LENGTH),
    (re.compile(r"(?P<link>\d+[a-z']?) .*?line through \S+ at (?P<it>.+?)(?= with | turned |$)"), Dim.ANGLE),
    (re.compile(r"(?P<link>\d+[a-z']?) .*? with \S+ (?P<it>.+?) (?:left|right)\b"), Dim.LENGTH),
    (re.compile(r"(?P<link>\d+[a-z']?) .*? turned (?P<it>.+)"), Dim.ANGLE),
    (re.compile(r".*?circle about (?P<link>\S+) of (?P<it>.+?)(?= at [A-Z]|$)"), Dim.LENGTH),
)
_NAMED = ("", "direction", "e", "turn", "r")  # of the quantities of a joint; x or y is told by the sentence
_INPUT = {
    "phi": Dim.ANGLE,
    "omega": Dim.OMEGA,
    "alpha": Dim.ALPHA,
    "s": Dim.LENGTH,
    "v": Dim.SPEED,
    "a": Dim.ACCEL,
    "length": Dim.LENGTH,
}
_RUBBING = {"rho": Dim.LENGTH, "f": None, "f_v": None, "r": Dim.LENGTH, "phi": Dim.ANGLE, "V": Dim.ANGLE}
_MASS = {"mass": ("m", Dim.MASS), "inertia": ("J", Dim.INERTIA)}
_ROD = {"diameter": ("d", Dim.LENGTH), "density": ("density", Dim.DENSITY)}
_SCALES = {"mu_l": Dim.MU_L, "mu_v": Dim.MU_V, "mu_a": Dim.MU_A, "mu_F": Dim.MU_F}
_OFFSETS = {"at": Dim.LENGTH, "left": Dim.LENGTH, "right": Dim.LENGTH, "angle": Dim.ANGLE}
_LINK = {
    "radius": ("r", Dim.LENGTH),
    "alpha": ("alpha_t", Dim.ANGLE),
    "phi": ("phi", Dim.ANGLE),
    "s": ("s", Dim.LENGTH),
}


def slots(data: Mapping[str, Value]) -> Iterator[Slot]:
    """Every quantity that is written in these values."""
    yield from _points(data, "frame", "x_{}", "y_{}")
    yield from _points(data, "guesses")
    for name, link in _entries(data, "links"):
        yield from _of_link(("links", name), name, link)
    yield from _of_joints(data.get("joints"))
    yield from _of_inputs(data.get("input"))
    for name, load in _entries(data, "loads"):
        yield from of_load(("loads", name), name, load)
    for name, rubs in _entries(data, "friction"):
        for key in there(rubs, _RUBBING):
            yield Slot(
                ("friction", name, key),
                _RUBBING[key],
                (f"{key}_{name}", *((key,) if key in ("f", "f_v", "rho") else ())),
            )
    for name, mass in _entries(data, "masses"):
        yield from _of_mass(("masses", name), name, mass)
    yield from keyed(("scales",), data.get("scales"), {key: (key, dim) for key, dim in _SCALES.items()})
    yield from in_data(("data",), data.get("data"))


def _entries(data: Mapping[str, Value], key: str) -> Iterator[tuple[str, Mapping[str, Value]]]:
    entries = data.get(key)
    for name, item in entries.items() if isinstance(entries, Mapping) else ():
        if isinstance(item, Mapping):
            yield name, item


def _points(data: Mapping[str, Value], key: str, *axes: str) -> Iterator[Slot]:
    """Fixed points: each as a pair, and each coordinate of it."""
    places = data.get(key)
    for letter, pair in places.items() if isinstance(places, Mapping) else ():
        yield Slot((key, letter), Dim.LENGTH, (letter,) if axes else (), pair=True)
        if isinstance(pair, list) and len(pair) == 2:
            yield from (Slot((key, letter, i), Dim.LENGTH, (axis.format(letter),)) for i, axis in enumerate(axes))


def _of_link(path: Path, name: str, link: Mapping[str, Value]) -> Iterator[Slot]:
    yield from keyed(path, link, {key: (f"{stem}_{name}", dim) for key, (stem, dim) in _LINK.items()})
    for key, item in link.items():
        if isinstance(item, Mapping):
            yield from _of_place((*path, key), key if ONE.fullmatch(key) else name, item)
        elif item is not None and PLACED.fullmatch(key):
            yield Slot((*path, key), Dim.LENGTH, (key,))


def _of_place(path: Path, letter: str, place: Mapping[str, Value]) -> Iterator[Slot]:
    """A point that is set out on its link, or the link's own line."""
    yield from keyed(path, place, {key: (f"{key}_{letter}", dim) for key, dim in _OFFSETS.items()})
    yield from (Slot((*path, key), Dim.LENGTH, (key,)) for key in there(place, place) if PLACED.fullmatch(key))


def _of_joints(joints: Value) -> Iterator[Slot]:
    for i, text in enumerate(joints if isinstance(joints, list) else ()):
        for (pattern, dim), stem in zip(_JOINT, _NAMED, strict=True):
            if isinstance(text, str) and (m := pattern.match(text)):
                yield Slot(("joints", i), dim, (f"{stem or m['name']}_{m['link']}",), m.span("it"), several=True)


def _of_inputs(inputs: Value) -> Iterator[Slot]:
    several = isinstance(inputs, list)
    for i, one in enumerate(inputs if isinstance(inputs, list) else [inputs]):
        for key in there(one, _INPUT):
            whose = str(one.get("link") or one.get("cylinder") or "")
            span = angle_span(one[key]) if key == "phi" else None
            yield Slot(("input", i, key) if several else ("input", key), _INPUT[key], (key, f"{key}_{whose}"), span)


def _of_mass(path: Path, name: str, mass: Mapping[str, Value]) -> Iterator[Slot]:
    yield from keyed(path, mass, {key: (f"{stem}_{name}", dim) for key, (stem, dim) in _MASS.items()})
    if isinstance(mass.get("centre"), Mapping):
        yield from _of_place((*path, "centre"), f"S{name}", mass["centre"])
    yield from keyed(
        (*path, "rod"), mass.get("rod"), {key: (f"{stem}_{name}", dim) for key, (stem, dim) in _ROD.items()}
    )


def named(data: Mapping[str, Value]) -> dict[str, tuple[Slot, ...]]:
    """Every name, short or full, with the quantities that it means."""
    found: dict[str, tuple[Slot, ...]] = {}
    for slot in slots(data):
        for name in dict.fromkeys(chain(slot.names, (slot.full,))):
            found[name] = (*found.get(name, ()), slot)
    return found


def other_way(name: str) -> str:
    """BA of AB; the name itself where it is no length's."""
    m = PLACED.fullmatch(name)
    return f"{m[2]}{m[1]}" if m else name
