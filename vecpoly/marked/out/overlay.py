"""A student's vectors over the exact polygon, with the circle of what is allowed at each tip."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import radians, tau

from ...board.acts import Arrow
from ...board.construction import Construction, Figure
from ...board.paper.marks import Arc, Dot, Mark, Point, Role
from ...board.place import View
from ...drawing.figure import caption_items, draw_figure
from ...drawing.scene import Item, Layer, Scene, Stroke
from ...drawing.style import RESULT, Dash, Hue
from ...foundation.slotted import replace
from ...grading.compare.outcome import Finding
from ...grading.key import AnswerKey, Graded, Kind
from ...grading.marking.marked import Marked
from ...words import Lang

_HEAD, _HALF = 3.0, radians(9.5)  # mm, half the angle of an arrowhead
_LEFT_OUT = (Role.DIRECTION, Role.CONSTRUCTION, Role.IDEAL)
POLYGONS = (View.VELOCITY, View.ACCELERATION, View.FORCE)


def overlays(construction: Construction, marked: Marked, lang: Lang) -> Iterator[tuple[Figure, Scene]]:
    """Each polygon on which something of this student can be drawn."""
    for figure in construction.figures:
        if figure.view not in POLYGONS:
            continue
        arrows = _arrows(construction, figure)
        own = [one for one in marked.findings if _drawable(one, marked.key) and one.key in arrows]
        if own:
            items = tuple(item for one in own for item in _items(one, marked.key[one.key], arrows[one.key]))
            allowed = tuple(_allowed(marked.key[one.key], arrows[one.key][1]) for one in own)
            cleared = _cleared(figure)
            whole = replace(cleared, tones=None, marks=(*cleared.marks, *allowed))
            both = draw_figure(whole, lang=lang, caption=False) + Scene.of(items)
            yield whole, both + Scene.of(caption_items(whole, both.extents, lang))  # below what the student drew, too


def _drawable(one: Finding, key: AnswerKey) -> bool:
    return key[one.key].kind is Kind.VECTOR and one.value is not None and bool(key[one.key].mm)


def _arrows(construction: Construction, figure: Figure) -> dict[str, tuple[complex, complex]]:
    """Key → from where to where the exact vector runs on this figure."""
    here = f"{figure.view.name} {figure.name}".strip()
    acts = [act for act in construction.acts if isinstance(act, Arrow) and act.key and act.figure == here]
    return {act.key: (act.a, act.b) for act in acts}


def _cleared(figure: Figure) -> Figure:
    """The polygon without the lines that only helped to draw it."""
    kept = (mark for mark in figure.marks if getattr(mark, "role", None) not in _LEFT_OUT and not _direction(mark))
    return replace(figure, marks=tuple(kept))


def _direction(mark: Mark) -> bool:
    """The letters at the end of a direction line: ⊥BC."""
    return isinstance(mark, Point) and mark.dot is Dot.NONE


def _items(one: Finding, graded: Graded, ends: tuple[complex, complex]) -> Iterator[Item]:
    start, end = ends
    exact = end - start
    if not abs(exact) or not graded.exact or one.value is None or graded.mm is None:
        return
    size = abs(one.value / graded.exact) * graded.mm
    along, told = exact / abs(exact), one.written.direction
    if told is not None:  # an arrow or a word tells it roughly
        turned = cmath.exp(1j * radians(told.degrees)) / along
        along *= 1.0 if abs(cmath.phase(turned)) <= radians(told.reach) else turned
    tip, hue = start + size * along, Hue.BLACK if one.is_right else Hue.ALARM
    yield Stroke(points=(start, tip), width=RESULT, dash=Dash.DASHED, hue=hue, layer=Layer.OVER)
    for side in (-_HALF, _HALF):
        yield Stroke(points=(tip, tip - _HEAD * along * cmath.exp(1j * side)), width=RESULT, hue=hue, layer=Layer.HEAD)


def _allowed(graded: Graded, end: complex) -> Arc:
    """The circle of what is allowed, on the figure itself, so that its letters keep clear of it."""
    return Arc(centre=end, radius=graded.allowed_mm or 0.0, start=0.0, sweep=tau, role=Role.DIRECTION)
