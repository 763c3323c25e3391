"""A student's vectors over the exact polygon, with the circle of what is allowed at each tip."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import radians, tau

from ...board.acts import Arrow
from ...board.construction import Construction, Figure
from ...board.paper.marks import Arc, Dot, Mark, Point, Role, Segment
from ...board.place import View
from ...drawing.figure import caption_items, draw_figure
from ...drawing.scene import Item, Layer, Rect, Scene, Stroke, TextBox
from ...drawing.style import RESULT, Dash, Hue
from ...foundation.frozen import FrozenMap
from ...foundation.slotted import replace
from ...grading.compare.outcome import Finding
from ...grading.key import AnswerKey, Graded, Kind
from ...grading.marking.marked import Marked
from ...words import Lang

_HEAD, _HALF = 3.0, radians(9.5)  # mm, half the angle of an arrowhead
ROOM = (164.0, 130.0)  # mm that a figure may take with what the student drew; its caption stands below
_LAID = -1  # the step of lines that stand on a figure while its letters find their places
BEYOND = 20.0  # mm: how far beyond the figure a line is drawn that has no room on the page
_LEFT_OUT = (Role.DIRECTION, Role.CONSTRUCTION, Role.IDEAL)
POLYGONS = (View.VELOCITY, View.ACCELERATION, View.FORCE)


@dataclass(frozen=True, slots=True, kw_only=True)
class Overlay:
    """A polygon with what the student drew over it; cut: symbols of vectors that go off the page, drawn as far as it
    goes and without a head."""

    figure: Figure
    scene: Scene
    cut: tuple[str, ...] = ()


def overlays(construction: Construction, marked: Marked, lang: Lang) -> Iterator[Overlay]:
    """Each polygon on which something of this student can be drawn."""
    for figure in construction.figures:
        if figure.view not in POLYGONS:
            continue
        arrows = _arrows(construction, figure)
        own = [one for one in marked.findings if _drawable(one, marked.key) and one.key in arrows]
        if own:
            allowed = tuple(_allowed(marked.key[one.key], arrows[one.key][1]) for one in own)
            cleared = _cleared(figure)
            whole = replace(cleared, tones=FrozenMap({}), marks=(*cleared.marks, *allowed))
            exact = draw_figure(whole, lang=lang, caption=False)
            found = (_line(one, marked.key[one.key], arrows[one.key], exact.extents) for one in own)
            lines = [line for line in found if line is not None]
            clear = _clear_of(lines, whole, exact, lang)
            both = clear + Scene.of(tuple(item for line in lines for item in line.items()))
            cut = tuple(one.symbol for one in lines if one.cut)
            scene = both + Scene.of(caption_items(whole, both.extents, lang))  # below what the student drew, too
            yield Overlay(figure=whole, scene=scene, cut=cut)


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


@dataclass(frozen=True, slots=True, kw_only=True)
class _Line:
    """A vector as the student has it, as far as the page goes."""

    symbol: str
    start: complex
    tip: complex
    hue: Hue
    cut: bool

    def items(self) -> Iterator[Item]:
        """The shaft, and the head where it is reached."""
        yield Stroke(points=(self.start, self.tip), width=RESULT, dash=Dash.DASHED, hue=self.hue, layer=Layer.OVER)
        along = (self.tip - self.start) / abs(self.tip - self.start)
        for side in () if self.cut else (-_HALF, _HALF):
            back = self.tip - _HEAD * along * cmath.exp(1j * side)
            yield Stroke(points=(self.tip, back), width=RESULT, hue=self.hue, layer=Layer.HEAD)


def _line(one: Finding, graded: Graded, ends: tuple[complex, complex], exact: Rect) -> _Line | None:
    """exact: what the figure takes without it."""
    start, end = ends
    if end == start or not graded.exact or not one.value or graded.mm is None:
        return None
    size = abs(one.value / graded.exact) * graded.mm
    along, told = (end - start) / abs(end - start), one.written.direction
    if told is not None:  # an arrow or a word tells it roughly
        turned = cmath.exp(1j * radians(told.degrees)) / along
        along *= 1.0 if abs(cmath.phase(turned)) <= radians(told.reach) else turned
    wide, high = (max(room - taken, 0.0) / 2 for room, taken in zip(ROOM, (exact.width, exact.height), strict=True))
    reached = size
    if size > _free(start, along, exact, (wide, high)):
        reached = _free(start, along, exact, (min(wide, BEYOND), min(high, BEYOND)))
    hue = Hue.BLACK if one.is_right else Hue.ALARM
    return _Line(symbol=graded.symbol, start=start, tip=start + reached * along, hue=hue, cut=reached < size)


def _clear_of(lines: Sequence[_Line], figure: Figure, exact: Scene, lang: Lang) -> Scene:
    """The exact polygon; where a line of the student runs through a letter of it, with its letters clear of the lines,
    which are on it while these find their places."""
    letters = [item.rect for item in exact.items if isinstance(item, TextBox)]
    if not any(_runs_through(line, rect) for line in lines for rect in letters):
        return exact
    laid = tuple(Segment(step=_LAID, a=line.start, b=line.tip, role=Role.DIRECTION) for line in lines)
    scene = draw_figure(replace(figure, marks=(*figure.marks, *laid)), lang=lang, caption=False)
    return Scene.of(tuple(item for item in scene.items if item.step != _LAID))


def _runs_through(line: _Line, rect: Rect) -> bool:
    """Whether no line parts them: neither an upright or a level one, nor one along the line."""
    a, b = line.start, line.tip
    level = min(a.imag, b.imag) > rect.y1 or max(a.imag, b.imag) < rect.y0
    upright = min(a.real, b.real) > rect.x1 or max(a.real, b.real) < rect.x0
    sides = [((corner - a) * (b - a).conjugate()).imag for corner in rect.corners]
    return not (level or upright or min(sides) > 0 or max(sides) < 0)


def _free(start: complex, along: complex, exact: Rect, beyond: tuple[float, float]) -> float:
    """How far a line may go that ends so far beyond the figure."""
    borders = (
        (along.real, start.real, exact.x0 - beyond[0], exact.x1 + beyond[0]),
        (along.imag, start.imag, exact.y0 - beyond[1], exact.y1 + beyond[1]),
    )
    return min(((high if way > 0 else low) - at) / way for way, at, low, high in borders if way)


def _allowed(graded: Graded, end: complex) -> Arc:
    """The circle of what is allowed, on the figure itself, so that its letters keep clear of it."""
    return Arc(centre=end, radius=graded.allowed_mm or 0.0, start=0.0, sweep=tau, role=Role.DIRECTION)
