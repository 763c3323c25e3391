"""The finished figures all through the cycle, as small data: what stays is written once, what moves once for every place of the drive."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from math import sqrt

import numpy as np

from ..board.construction import Figure, View
from ..board.extent import bounds
from ..board.marks import Cell, Note
from ..drawing.paging import reading_order
from ..drawing.scene import Item, Layer, Rect, Scene, TextBox
from ..drawing.style import LETTER, Hue
from ..words import Lang
from .figures import LANGS, MARGIN, box, caption, key_of
from .ink import Ink
from .lettering import Follower
from .turned import Cycle

AROUND = 12.0  # mm that lettering and title take round a figure
LEGIBLE = 0.022  # letters that are this part of the sheet's width can be read
POLYGONS = (View.VELOCITY, View.ACCELERATION, View.FORCE)

Data = dict[str, object]


@dataclass(frozen=True, slots=True)
class Frames:
    """A figure at every place in one language: its items there, none where it is not drawn; and those that never change."""

    items: tuple[tuple[Item, ...], ...]
    still: frozenset[Item]
    lang: Lang | None  # none: alike in both


def moving(cycle: Cycle, ink: Ink) -> list[Data]:
    """Per figure of the given place: its box, its caption, its standing lines, and its lines for every place, layer by layer."""
    given = cycle.turns[cycle.start].solution.construction.figures
    by_key = [{key_of(f): f for f in turn.solution.construction.figures} for turn in cycle.turns]
    order = reading_order(given)
    places = [[found.get(key_of(figure)) for found in by_key] for figure in order]
    size = _magnified(places, cycle.start)
    return [_figure(figure, there, cycle.start, size, ink) for figure, there in zip(order, places, strict=True)]


def _figure(figure: Figure, places: Sequence[Figure | None], start: int, size: float, ink: Ink) -> Data:
    worded = any(isinstance(mark, (Note, Cell)) for one in places if one is not None for mark in one.marks)
    frames = [_frames(places, start, size, lang) for lang in (LANGS if worded else (None,))]
    given = Scene.of(frames[0].items[start]).extents
    seen = [Scene.of(items).extents for one in frames for items in one.items if items]
    room = _room(given, seen, figure.view in POLYGONS)
    under, extents = caption(figure, ink, room, size)
    return {"key": key_of(figure), "box": box(extents.grown(MARGIN)), "clip": box(room.grown(MARGIN)), "caption": under, "size": round(size, 2), "cut": any((room | one) != room for one in seen),
            "sets": [{"lang": one.lang or "", "still": _layers(tuple(i for i in one.items[start] if i in one.still), ink),
                      "moving": [_layers(tuple(i for i in items if i not in one.still), ink) if items else None for items in one.items]} for one in frames]}


def _frames(places: Sequence[Figure | None], start: int, size: float, lang: Lang | None) -> Frames:
    """The letters follow from the given place on to the end, then from there back to the beginning."""
    there = Follower(lang or "zh", size)
    given = _stepless(there, places[start])
    back = Follower(there.lang, size, dict(there.choice))
    later = [_stepless(there, one) for one in places[start + 1 :]]
    sooner = [_stepless(back, one) for one in reversed(places[:start])]
    items = (*reversed(sooner), given, *later)
    return Frames(items, frozenset.intersection(*(frozenset(one) for one in items if one)), lang)


def _stepless(follower: Follower, figure: Figure | None) -> tuple[Item, ...]:
    """The items without their steps, which do not matter here; none where the figure is not drawn."""
    return () if figure is None else tuple(replace(item, step=0) for item in follower.lettered(figure))


def _room(given: Rect, seen: Sequence[Rect], polygon: bool) -> Rect:
    """What nearly all places need, within bounds: polygons may grow much, a mechanism grows only by far points of its construction."""
    share, beyond = (5, 1.6) if polygon else (10, 1.0)
    most = given.grown(beyond * max(given.width, given.height))
    low_x, low_y = (float(np.percentile([getattr(r, side) for r in seen], share)) for side in ("x0", "y0"))
    high_x, high_y = (float(np.percentile([getattr(r, side) for r in seen], 100 - share)) for side in ("x1", "y1"))
    return Rect(max(most.x0, low_x), max(most.y0, low_y), min(most.x1, high_x), min(most.y1, high_y)) | given


def _magnified(places: Sequence[Sequence[Figure | None]], start: int) -> float:
    """How much larger letters must be so that they can be read where all figures are seen at once."""
    area = 0.0
    for figures in places:
        seen = [Rect(low.real, low.imag, high.real, high.imag) for low, high in (bounds(one.marks) for one in figures if one is not None)]
        given = figures[start]
        if given is not None:
            room = _room(seen[sum(one is not None for one in figures[:start])], seen, given.view in POLYGONS).grown(AROUND)
            area += room.width * room.height
    return min(max(LEGIBLE * sqrt(area) / LETTER, 1.0), 1.6)


def _layers(items: tuple[Item, ...], ink: Ink) -> Mapping[int, str]:
    """Layer → its lines: ``s3:M..|f4:M..|t12:1234 -567``, look and path, or piece of type and place."""
    ordered = sorted(items, key=lambda item: item.layer)
    return {int(layer): "|".join(_merged(tuple(inside), ink)) for layer, inside in groupby(ordered, key=lambda item: item.layer)}


def _merged(items: tuple[Item, ...], ink: Ink) -> list[str]:
    """Neighbours of one look in one path; on layers where nothing hides anything, all of one look."""
    pieces = [_coded(item, ink) for item in items]
    if items[0].layer in (Layer.THIN, Layer.LINE, Layer.HEAD, Layer.TEXT):
        pieces.sort(key=lambda piece: piece[0])
    out = []
    for name, inside in groupby(pieces, key=lambda piece: piece[0]):
        bodies = [body for _, body in inside]
        out += [f"{name}:{body}" for body in bodies] if name.startswith("t") else [f"{name}:{''.join(bodies)}"]
    return out


def _coded(item: Item, ink: Ink) -> tuple[str, str]:
    if isinstance(item, TextBox):
        hue = "" if item.hue is Hue.BLACK else f".{item.hue.name.lower()}"
        return f"{ink.type(item.box)}{hue}", f"{round(100 * item.x)} {round(-100 * item.y)}"
    return ink.piece(item)
