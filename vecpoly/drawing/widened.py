"""An angle whose letter finds no place beside its arc is marked farther out, or nearer to its vertex, where the letter
has room between its sides: no leader need cross them."""

from __future__ import annotations

import cmath
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import shapely

from ..board.construction import Figure
from ..board.paper.marks import AngleMark, Mark
from ..foundation.slotted import replace
from .labels.ground import is_ground
from .labels.numbers import FRACTIONS
from .labels.points import piece
from .labels.want import Thing
from .rect import Rect
from .scene import Item, Stroke
from .style import LINK, Hue
from .symbols.angles import NARROW
from .symbols.shapes import NEAR
from .weighing.placed import Placed

FACTORS = (1.3, 1.6, 0.75, 2.0, 2.5)  # times its radius, the nearest to it first
LEAST, MOST = 6.0, 30.0  # mm: of a radius
BESIDE, WHITE = 1.0, 0.4  # mm from the arc to its letter; about the letter
CLEAR = 0.8  # mm from the arc to a letter, and to a link
OWN = 0.2  # mm by which a stroke of the arc itself is off its radius
FINE = 12  # chords of an arc

Widths = tuple[tuple[str, int, float], ...]  # of each such angle: its letter, which of several, times its radius


def widths(figure: Figure, labels: Sequence[Placed], items: Iterable[Item]) -> Widths:
    """The angles whose letters stand on leaders as they are drawn, and would have room with another radius."""
    led = [label for label in labels if label.want.thing is Thing.ARC and label.foot is not None]
    if not led:
        return ()
    strokes = [one for one in items if isinstance(one, Stroke) and not is_ground(one)]
    found = list[tuple[str, int, float]]()
    for name, number, mark in _named(figure.marks):
        label = next((one for one in led if _names(one, mark)), None)
        if label is not None and mark.radius * abs(mark.sweep) >= NARROW:
            others = [one.rect for one in labels if one is not label]
            factor = next(iter(_free(mark, label, strokes, others)), None)
            found += [(name, number, factor)] if factor is not None else []
    return tuple(found)


def widened(figure: Figure, by: Widths) -> Figure:
    """The figure with these angles marked with other radii."""
    if not by:
        return figure
    factors = {(name, number): factor for name, number, factor in by}
    made = {
        mark: replace(mark, radius=mark.radius * factors[name, number])
        for name, number, mark in _named(figure.marks)
        if (name, number) in factors
    }
    return replace(
        figure, marks=tuple(made.get(mark, mark) if isinstance(mark, AngleMark) else mark for mark in figure.marks)
    )


def _named(marks: Iterable[Mark]) -> Iterator[tuple[str, int, AngleMark]]:
    """The angles that have a letter, each with its symbol, which stays when it turns, and which of several it is."""
    seen = Counter[str]()
    for mark in marks:
        if isinstance(mark, AngleMark) and mark.label:
            symbol = mark.label.partition(" = ")[0]
            seen[symbol] += 1
            yield symbol, seen[symbol], mark


def _names(label: Placed, mark: AngleMark) -> bool:
    """Whether a label is that of an angle, in full or in brief."""
    if abs(label.want.own[0] - mark.at) > NEAR:
        return False
    texts = {piece(text, Hue.BLACK, mark.step).box for text in (mark.label, mark.label.partition(" = ")[0])}
    return label.want.pieces[0].step == mark.step and label.want.pieces[0].box in texts


def _free(mark: AngleMark, label: Placed, strokes: Sequence[Stroke], others: Sequence[Rect]) -> Iterator[float]:
    """The factors with which the arc crosses no letter and no link, and its letter stands on nothing."""
    lines = shapely.STRtree([_line(one.points) for one in strokes if not _is_arc(one, label, mark.at)])
    thick = shapely.STRtree([_line(one.points) for one in strokes if one.width >= LINK - NEAR])
    letters = shapely.STRtree([shapely.box(one.x0, one.y0, one.x1, one.y1) for one in others])
    for factor in FACTORS:
        radius = factor * mark.radius
        if not LEAST <= radius <= MOST:
            continue
        bow = _bow(mark, radius)
        if len(thick.query(bow, "dwithin", CLEAR)) or len(letters.query(bow, "dwithin", CLEAR)):
            continue
        boxes = list(_spots(mark, radius, label))
        taken = {*lines.query(boxes, "intersects")[0], *letters.query(boxes, "intersects")[0]}
        if len(taken) < len(boxes):
            yield factor


def _spots(mark: AngleMark, radius: float, label: Placed) -> Iterator[shapely.Polygon]:
    """The boxes of its letter outside and inside the arc."""
    wide, high = label.want.width / 2 + WHITE, label.want.height / 2 + WHITE
    for share in FRACTIONS:
        u = cmath.exp(1j * (mark.start + share * mark.sweep))
        off = BESIDE + wide * abs(u.real) + high * abs(u.imag)
        for side in (1.0, -1.0):
            at = mark.at + (radius + side * off) * u
            if radius + side * off > off:
                yield shapely.box(at.real - wide, at.imag - high, at.real + wide, at.imag + high)


def _bow(mark: AngleMark, radius: float) -> shapely.LineString:
    """The arc of this radius without its ends, which lie on its rays."""
    ways = mark.start + mark.sweep * np.linspace(0.08, 0.92, FINE)
    return _line(tuple(mark.at + radius * np.exp(1j * ways)))


def _is_arc(one: Stroke, label: Placed, at: complex) -> bool:
    """Whether a stroke is the arc of the label."""
    radius = abs(label.want.bow[0] - at) if label.want.bow else 0.0
    return len(one.points) > 2 and all(abs(abs(z - at) - radius) < OWN for z in one.points)


def _line(points: Sequence[complex]) -> shapely.LineString:
    return shapely.LineString([(z.real, z.imag) for z in points])
