"""A student's polygon over the exact one: full lines over dashed ones, with T as circles about where tips should be."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...algebra.formula import row
from ...drawing.labels.notes import lines
from ...drawing.scene import Fill, Item, Layer, Scene, Stroke, TextBox
from ...drawing.style import GIVEN, HEAD_LENGTH, HEAD_WIDTH, LETTER, LINK, NOTE, RESULT, THIN, Dash, Hue
from ...typeset import layout
from ...words import Lang, Words
from .expected import Shape
from .judging.mark import DrawingMark, FigureMark, VectorMark
from .judging.reason import FAIR
from .model import DrawingKey

SEEN, LARGER = 0.8, (1, 2, 5, 10)  # mm: a circle that is seen; how much larger circles are drawn, if need be
CORNERS = 36
ASIDE, UNDER = 1.2, 9.0  # mm: from a line to its letters; from the lowest line to the note
EXACT = Hue.GREY


def overlay(mark: DrawingMark, key: DrawingKey, lang: Lang = "zh") -> tuple[Scene, ...]:
    """One scene for each polygon that is drawn, in mm of the reference drawing; for any backend of `drawing`."""
    found = []
    for one in mark.figures:
        shape = key.exact.shape(one.figure)
        if one.drawn and shape is not None:
            found.append(overlaid(one, shape, lang))
    return tuple(found)


def overlaid(mark: FigureMark, shape: Shape, lang: Lang = "zh") -> Scene:
    """One polygon over the exact one."""
    times = _times(mark)
    items = [item for edge in shape.edges for item in _arrow(edge.a, edge.b, GIVEN, Dash.DASHED, EXACT)]
    for one in mark.vectors:
        if one.own is not None:
            items += _own(one, times)
    scene = Scene.of(tuple(items))
    return scene + Scene.of((_note(scene, mark, times, lang),))


def _times(mark: FigureMark) -> int:
    """How much larger than T the circles are drawn, so that they are seen."""
    widest = max((one.allowed for one in mark.vectors), default=SEEN)
    return next((times for times in LARGER if widest * times >= SEEN), LARGER[-1])


def _own(one: VectorMark, times: int) -> Iterator[Item]:
    own = one.own or 0j
    fair = one.verdict in FAIR
    hue, width = (Hue.BLACK, RESULT) if fair else (Hue.ALARM, LINK)
    yield from _arrow(one.tail, one.tail + own, width, Dash.FULL, hue)
    yield _circle(one.tail + one.should, one.allowed * times, hue)
    if not fair and own:
        box = layout(row(one.symbol), LETTER)
        aside = 1j * own / abs(own)
        room = ASIDE + (abs(aside.real) * box.width + abs(aside.imag) * box.height) / 2
        at = one.tail + own / 2 + aside * room
        yield TextBox(box=box, x=at.real - box.width / 2, y=at.imag - (box.ascent - box.descent) / 2, hue=hue)


def _arrow(a: complex, b: complex, width: float, dash: Dash, hue: Hue) -> Iterator[Item]:
    along = b - a
    if not along:
        return
    way = along / abs(along)
    back = b - way * min(HEAD_LENGTH, abs(along) / 2)
    yield Stroke(points=(a, back), width=width, dash=dash, hue=hue, layer=Layer.THIN if hue is EXACT else Layer.LINE)
    side = 1j * way * HEAD_WIDTH / 2
    yield Fill(points=(b, back + side, back - side), hue=hue, layer=Layer.THIN if hue is EXACT else Layer.HEAD)


def _circle(at: complex, radius: float, hue: Hue) -> Item:
    turns = np.exp(2j * np.pi * np.arange(CORNERS) / CORNERS)
    return Stroke(points=tuple(complex(z) for z in at + radius * turns), width=THIN, hue=hue, closed=True)


def _note(scene: Scene, mark: FigureMark, times: int, lang: Lang) -> TextBox:
    """What the lines are."""
    larger = Words("", "") if times == 1 else Words(f"（放大 {times} 倍）", f" (drawn {times} times as large)")
    title = mark.title + Words("：实线为你的图，虚线为精确图，", ": full lines are yours, dashed ones exact,")
    text = title + Words("\n圆为允许误差", "\nand circles the allowed error") + larger
    box = lines(text.of(lang), NOTE)
    return TextBox(box=box, x=scene.extents.centre.real - box.width / 2, y=scene.extents.y0 - UNDER)
