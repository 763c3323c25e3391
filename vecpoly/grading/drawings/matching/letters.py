"""Lines that have no name of their own, named by the letters that stand at their ends: the line from p to c₂ is pc₂."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ....foundation.slotted import replace
from ..expected import Shape
from ..segment import TOUCH, Label, Segment
from .naming import letters_in, named, plain

ROOM, CLEARLY = 7.0, 1.5  # mm: a letter stands no farther from its point, and so many times nearer than from any other


def by_letters(lines: Sequence[Segment], labels: Sequence[Label], shapes: Sequence[Shape]) -> tuple[Segment, ...]:
    """The lines, those without a name with that of the vector whose letters stand at their ends, where they stand there
    beyond doubt."""
    known = {plain(letter) for shape in shapes if not shape.diagram for v in shape.vertices for letter in v.letters}
    places = _places(lines)
    at = _lettered(places, labels, known)
    return tuple(one if one.name else _named(one, places, at, shapes) for one in lines)


def _named(one: Segment, places: list[complex], at: Mapping[int, set[str]], shapes: Sequence[Shape]) -> Segment:
    tails, tips = (at.get(_place(places, end), set()) for end in (one.start, one.end))
    meant = (named(tail + tip, one.layer, shapes) for tail in tails for tip in tips)
    found = {":".join(each) for each in meant if each is not None}
    return replace(one, name=found.pop()) if len(found) == 1 else one


def _places(lines: Sequence[Segment]) -> list[complex]:
    """Where lines end, each place once."""
    found: list[complex] = []
    for end in (z for one in lines for z in (one.start, one.end)):
        if not any(abs(end - other) < TOUCH for other in found):
            found.append(end)
    return found


def _place(places: Sequence[complex], end: complex) -> int:
    return int(np.argmin(np.abs(np.array(places) - end)))


def _lettered(places: Sequence[complex], labels: Sequence[Label], known: set[str]) -> dict[int, set[str]]:
    """Place, by its number, → the letters that stand there and nowhere else; of a letter that stands twice none."""
    found: dict[str, list[int]] = {}
    for label in labels if len(places) > 1 else ():
        letters = [letter for letter in letters_in(label.text) if letter in known]
        off = np.minimum(*(np.abs(np.array(places) - z) for z in (label.at, label.middle)))
        first, second, *_ = np.argsort(off)
        if letters and off[first] <= ROOM and off[second] >= CLEARLY * off[first]:
            for letter in letters:
                found.setdefault(letter, []).append(int(first))
    at: dict[int, set[str]] = {}
    for letter, where in found.items():
        if len(where) == 1:
            at.setdefault(where[0], set()).add(letter)
    return at
