"""What force drawings add to the machine symbols:
friction circles, discs, solid bodies, the boxes of a block diagram."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

import numpy as np
import shapely

from ...board.paper.marks import Cell, Disc, FrictionCircle, Hatched, Outline
from ...words import Lang
from ..labels.notes import fitted
from ..scene import Fill, Item, Layer, Stroke, TextBox
from ..style import HATCHING, NOTE, RESULT, SYMBOL, Dash, Hue
from .shapes import circle, rectangle

FRICTION = 0.25  # line of a friction circle
PITCH, SLOPE = 2.2, cmath.exp(1j * math.pi / 4)  # hatching of fixed bodies
CELL_MARGIN = 1.2  # box to its words
TOUCH = 0.3  # mm: outlines that come so near touch


def friction_circle(mark: FrictionCircle) -> tuple[Item, ...]:
    """A dashed circle, over the pin that it surrounds."""
    if mark.radius <= 0:
        return ()
    return (
        Stroke(
            points=circle(mark.centre, mark.radius),
            width=FRICTION,
            dash=Dash.SHORT,
            closed=True,
            layer=Layer.JOINT,
            step=mark.step,
        ),
    )


def disc(mark: Disc, others: Sequence[Disc]) -> tuple[Item, ...]:
    """A round body seen from the side, under the lines that are drawn on it; only its outline where it crosses another:
    which of them lies in front is not known."""
    drawn = body(circle(mark.centre, mark.radius), mark.step) if mark.radius > 0 else ()
    crossed = any(_cross(mark, other) for other in others)
    return tuple(item for item in drawn if isinstance(item, Stroke)) if crossed else drawn


def _cross(one: Disc, other: Disc) -> bool:
    """Whether their outlines cross, and do not only touch."""
    away = abs(one.centre - other.centre)
    return abs(one.radius - other.radius) + TOUCH < away < one.radius + other.radius - TOUCH


def outline(mark: Outline) -> tuple[Item, ...]:
    """A body with corners: tinted if it moves, hatched all over if it is fixed."""
    if len(mark.points) < 3:
        return (
            (Stroke(points=mark.points, width=RESULT, layer=Layer.THIN, step=mark.step),)
            if len(mark.points) == 2
            else ()
        )
    if not mark.fixed:
        return body(mark.points, mark.step)
    strokes = (
        Stroke(points=pair, width=HATCHING, hue=Hue.GREY, layer=Layer.THIN, step=mark.step)
        for pair in hatched_area(mark.points)
    )
    return (*strokes, Stroke(points=mark.points, width=RESULT, closed=True, layer=Layer.THIN, step=mark.step))


def body(points: tuple[complex, ...], step: int) -> tuple[Item, ...]:
    """A tinted area with its outline."""
    return (
        Fill(points=points, hue=Hue.PLATE, layer=Layer.TINT, step=step),
        Stroke(points=points, width=RESULT, closed=True, layer=Layer.THIN, step=step),
    )


def hatched(mark: Hatched) -> tuple[Item, ...]:
    """An area between lines: hatched in light ink, on which letters may stand."""
    if len(mark.points) < 3:
        return ()
    slope = SLOPE if mark.rising else SLOPE.conjugate()
    return tuple(
        Stroke(points=pair, width=HATCHING, hue=Hue.HATCH, layer=Layer.TINT, step=mark.step)
        for pair in hatched_area(mark.points, slope)
    )


def hatched_area(points: tuple[complex, ...], slope: complex = SLOPE) -> tuple[tuple[complex, complex], ...]:
    """Lines at 45°, or along another direction, through a polygon, clipped to it."""
    area = shapely.make_valid(shapely.Polygon([(z.real, z.imag) for z in points]))
    turned = np.array(points) * slope.conjugate()  # the lines lie level here
    x0, x1 = turned.real.min() - 1, turned.real.max() + 1
    levels = np.arange(math.ceil(turned.imag.min() / PITCH), math.floor(turned.imag.max() / PITCH) + 1) * PITCH
    found: list[tuple[complex, complex]] = []
    for y in levels:
        ends = [complex(x, y) * slope for x in (x0, x1)]
        cut = shapely.intersection(area, shapely.LineString([(z.real, z.imag) for z in ends]))
        for part in shapely.get_parts(cut):
            if part.geom_type == "LineString" and part.length > 0.3:
                a, b = (complex(*xy) for xy in (part.coords[0], part.coords[-1]))
                found.append((a, b))
    return tuple(found)


def cell(mark: Cell, lang: Lang) -> tuple[Item, ...]:
    """A box that hides the lines under it, with its words in the middle."""
    corners = rectangle(mark.at, 1 + 0j, mark.width, mark.height)
    text = fitted(mark.words.of(lang), NOTE, mark.width - 2 * CELL_MARGIN, mark.height - 2 * CELL_MARGIN)
    y = mark.at.imag - (text.ascent - text.descent) / 2
    return (
        Fill(points=corners, hue=Hue.WHITE, layer=Layer.BODY, step=mark.step),
        Stroke(points=corners, width=SYMBOL, closed=True, layer=Layer.BODY, step=mark.step),
        TextBox(box=text, x=mark.at.real - text.width / 2, y=y, step=mark.step),
    )
