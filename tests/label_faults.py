"""What is wrong with the lettering of a figure."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np
import shapely
import shapely.ops
from numpy.typing import NDArray

from vecpoly.drawing.figure import Drawing
from vecpoly.drawing.labels.ground import is_ground
from vecpoly.drawing.labels.want import Spot, Thing
from vecpoly.drawing.scene import Fill, Item, Rect, Stroke, TextBox
from vecpoly.drawing.weighing.placed import Placed
from vecpoly.drawing.weighing.stood import APART, FRACTION
from vecpoly.typeset import Glyphs

LEVEL = 0.3  # mm by which two labels overlap in height, or in width, to be in one line, or over each other
ON = 0.3  # mm: a point so near to a line is on it
NEAR = 1.8  # mm between two labels
BESIDE, OVER = 1.5, 0.8  # mm between two labels in one line, and over each other, that keep them two


def faults(drawn: Drawing) -> list[str]:
    """Every label that stands on a line, an arrowhead, a dot or another label."""
    boxes = np.array([_box(rect) for rect in drawn.label_boxes], dtype=object)
    met = [(shape, item) for item in drawn.obstacles if (shape := _shape(item)) is not None]
    found = [f"label {i} on label {j}" for i, j in _pairs(boxes, boxes) if j < i]
    over = _pairs(boxes, np.array([shape for shape, _ in met], dtype=object))
    return found + [f"label {i} on {met[j][1]}" for i, j in over if boxes[i].intersection(met[j][0]).area > 1e-6]


def _pairs(boxes: NDArray[np.object_], shapes: NDArray[np.object_]) -> list[tuple[int, int]]:
    """Which box meets which shape."""
    return [(int(i), int(j)) for i, j in np.argwhere(shapely.intersects(boxes[:, None], shapes[None, :]))]


def _box(r: Rect) -> shapely.Polygon:
    return shapely.box(r.x0, r.y0, r.x1, r.y1)


def _shape(item: Item) -> shapely.Geometry | None:
    """What a label must not stand on; None where it may."""
    match item:
        case Stroke(points=points, width=width):
            return shapely.LineString([(z.real, z.imag) for z in points]).buffer(width / 2, cap_style="flat")
        case Fill(points=points, hue=hue) if not hue.is_tint:
            return shapely.Polygon([(z.real, z.imag) for z in points])
        case TextBox(rect=r):
            return _box(r)
        case _:
            return None


def astray(drawn: Drawing, unnamed: Sequence[Spot] = ()) -> list[str]:
    """Every label without a leader that stands nearer to another thing of its kind than to its own, or to a point
    that is not on the line that it names."""
    named = [(label.want.thing, _line(label), label.want.radius, text_of(label)) for label in drawn.labels]
    named += [(Thing.POINT, shapely.Point(at.real, at.imag), radius, "a point") for at, radius in unnamed]
    found: list[str] = []
    for label in drawn.labels:
        if label.foot is not None or label.want.thing is Thing.OTHER:
            continue
        box, mine = _box(label.rect), _line(label)
        own = float(box.distance(mine)) - label.want.radius
        for thing, line, radius, text in named:
            away = float(box.distance(line)) - radius
            other = not line.equals(mine) if thing is label.want.thing else not line.dwithin(mine, ON)
            if other and thing in (label.want.thing, Thing.POINT) and away < own - 1e-6:
                found.append(f"{text_of(label)} stands nearer to {text} ({away:.1f} mm) than to its own ({own:.1f} mm)")
    return found


def crammed(drawn: Drawing) -> list[str]:
    """Every two labels that are read as one: side by side (C 3), or one over the other (2 over B)."""
    found: list[str] = []
    for label, other in combinations(drawn.labels, 2):
        r, q = label.rect, other.rect
        dx, dy = max(r.x0, q.x0) - min(r.x1, q.x1), max(r.y0, q.y0) - min(r.y1, q.y1)
        if (dy < -LEVEL and dx < BESIDE) or (dx < -LEVEL and dy < OVER):
            found.append(f"{text_of(label)} and {text_of(other)} stand {max(dx, dy):.1f} mm apart")
    return found


def close(drawn: Drawing) -> int:
    """How many pairs of labels stand so near that it takes a second look to tell what each names."""
    boxes = np.array([_box(rect) for rect in drawn.label_boxes], dtype=object)
    return int(np.triu(shapely.dwithin(boxes[:, None], boxes[None, :], NEAR), 1).sum()) if len(boxes) else 0


def fractions(drawn: Drawing) -> list[str]:
    """Every letter of a point and number of a link that stand over each other, and are read as a fraction."""
    found: list[str] = []
    for label, other in combinations([one for one in drawn.labels if one.foot is None], 2):
        if {label.want.thing, other.want.thing} == {Thing.POINT, Thing.LINK}:
            r, q = label.rect, other.rect
            dx, dy = max(r.x0, q.x0) - min(r.x1, q.x1), max(r.y0, q.y0) - min(r.y1, q.y1)
            if dx < -APART and dy < FRACTION:
                found.append(f"{text_of(label)} and {text_of(other)} stand over each other, {dy:.1f} mm apart")
    return found


def parted(drawn: Drawing) -> list[str]:
    """Every label without a leader that a straight line parts from what it names."""
    lines = [item for item in drawn.obstacles if isinstance(item, Stroke) and len(item.points) == 2 and not item.closed]
    ruled = [shapely.LineString([(z.real, z.imag) for z in item.points]) for item in lines if not is_ground(item)]
    return [text_of(label) for label in drawn.labels if label.foot is None and _is_parted(label, ruled)]


def _is_parted(label: Placed, ruled: Sequence[shapely.LineString]) -> bool:
    mine, keep = _line(label), label.want.radius + ON
    near, end = (complex(p.x, p.y) for p in shapely.ops.nearest_points(mine, _box(label.rect)))
    if abs(end - near) <= keep:
        return False
    start = near + (end - near) / abs(end - near) * keep
    way = shapely.LineString([(start.real, start.imag), (end.real, end.imag)])
    return any(way.intersects(line) and mine.hausdorff_distance(line) > ON for line in ruled)


def leaders(drawn: Drawing) -> list[Stroke]:
    """The lines that lead from labels to what they name."""
    return [item for label in drawn.labels for item in label.items() if isinstance(item, Stroke)]


def _line(label: Placed) -> shapely.Geometry:
    return shapely.LineString([(z.real, z.imag) for z in label.want.course])


def text_of(label: Placed) -> str:
    """What a label says."""
    return "".join(
        glyphs.text for piece in label.want.pieces for glyphs in piece.box.items if isinstance(glyphs, Glyphs)
    )
