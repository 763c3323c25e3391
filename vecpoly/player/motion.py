"""The finished figures all through the cycle, as small data:
what stays is written once, what moves once for every place of the drive."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import groupby

from ..board.construction import Construction, Figure, Scale, View
from ..board.paper.marks import words_of
from ..drawing.labels.following import Follower
from ..drawing.order import reading_order
from ..drawing.scene import Item, Layer, Rect, Scene, TextBox
from ..drawing.style import Hue
from ..foundation.slotted import replace
from ..words import Lang
from .figures import LANGS, MARGIN, box, caption, key_of
from .panes import magnified, pane
from .setting.ink import Ink
from .traces import traces
from .turned import Cycle

Data = dict[str, object]


@dataclass(frozen=True, slots=True)
class Frames:
    """A figure at every place in one language: its items there, none where it is not drawn;
    and those that never change."""

    items: tuple[tuple[Item, ...], ...]
    still: frozenset[Item]
    lang: Lang | None  # none: alike in both


def moving(cycle: Cycle, given: Construction, ink: Ink) -> list[Data]:
    """Per figure of the given drawing: its box, its captions, its standing lines,
    and its lines for every place, layer by layer."""
    by_key = [{key_of(f): f for f in turn.solution.construction.figures} for turn in cycle.turns]
    order = [figure for figure in reading_order(given.figures) if key_of(figure) in by_key[cycle.start]]
    places = [[found.get(key_of(figure)) for found in by_key] for figure in order]
    size = magnified(places, cycle.start)
    return [
        _figure(figure, there, cycle.start, size, ink)
        | {"points": traces(cycle.turns, key_of(figure), cycle.start, size, ink)}
        for figure, there in zip(order, places, strict=True)
    ]


def _figure(figure: Figure, places: Sequence[Figure | None], start: int, size: float, ink: Ink) -> Data:
    marks = (mark for one in places if one is not None for mark in one.marks)
    worded = any(words.zh != words.en for mark in marks if (words := words_of(mark)) is not None)
    frames = [_frames(places, start, size, lang) for lang in (LANGS if worded else (None,))]
    given = Scene.of(frames[0].items[start]).extents
    seen = [Scene.of(items).extents for one in frames for items in one.items if items]
    room = pane(given, seen, places)
    which, captions, extents = _captions(figure, places, start, room, size, ink)
    return {
        "key": key_of(figure),
        "box": box(extents.grown(MARGIN)),
        "clip": box(room.grown(MARGIN)),
        "captions": captions,
        "scale": which,
        "size": round(size, 2),
        "polygon": figure.view is not View.MECHANISM,
        "cut": any((room | one) != room for one in seen),
        "sets": [
            {
                "lang": one.lang or "",
                "still": _layers(tuple(i for i in one.items[start] if i in one.still), ink),
                "moving": [
                    _layers(tuple(i for i in items if i not in one.still), ink) if items else None
                    for items in one.items
                ],
            }
            for one in frames
        ],
    }


def _captions(
    figure: Figure, places: Sequence[Figure | None], start: int, room: Rect, size: float, ink: Ink
) -> tuple[list[int], list[Data], Rect]:
    """Which caption belongs to each place; the captions, one for each scale, whether it is another than the given one,
    and how many times as large as at the place `start` all is drawn at it; the extents with them."""
    scales = [figure.scale if one is None else one.scale for one in places]
    kinds = list(dict.fromkeys(scales))
    drawn = [caption(replace(figure, scale=scale), ink, room, size) for scale in kinds]
    captions: list[Data] = [
        {"svg": svg, "other": scale != figure.scale, "times": _times(scale, scales[start])}
        for scale, (svg, _) in zip(kinds, drawn, strict=True)
    ]
    return [kinds.index(scale) for scale in scales], captions, reduce(Rect.__or__, (extents for _, extents in drawn))


def _times(scale: Scale, given: Scale) -> float:
    return float(f"{given.value / scale.value:.6g}") if scale.value else 1.0


def _frames(places: Sequence[Figure | None], start: int, size: float, lang: Lang | None) -> Frames:
    """The letters follow from the given place on to the end, then from there back to the beginning."""
    there = Follower(lang or "zh", size)
    given = _stepless(there, places[start])
    back = there.again()
    later = [_stepless(there, one) for one in places[start + 1 :]]
    sooner = [_stepless(back, one) for one in reversed(places[:start])]
    items = (*reversed(sooner), given, *later)
    return Frames(items, frozenset.intersection(*(frozenset(one) for one in items if one)), lang)


def _stepless(follower: Follower, figure: Figure | None) -> tuple[Item, ...]:
    """The items without their steps, which do not matter here; none where the figure is not drawn."""
    return () if figure is None else tuple(replace(item, step=0) for item in follower.lettered(figure))


def _layers(items: tuple[Item, ...], ink: Ink) -> Mapping[int, str]:
    """Layer → its lines: ``s3:M..|f4:M..|t12:1234 -567``, look and path, or piece of type and place."""
    ordered = sorted(items, key=lambda item: item.layer)
    return {
        int(layer): "|".join(_merged(tuple(inside), ink))
        for layer, inside in groupby(ordered, key=lambda item: item.layer)
    }


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
        hue = "" if item.hue == Hue.BLACK else f".{item.hue.name}"
        return f"{ink.type(item.box)}{hue}", f"{round(100 * item.x)} {round(-100 * item.y)}"
    return ink.piece(item)
