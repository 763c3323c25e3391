"""What is wrong with the lettering of a figure."""

from __future__ import annotations

import shapely

from vecpoly.drawing.figure import Drawing
from vecpoly.drawing.labels.placing import Placed
from vecpoly.drawing.labels.wants import Thing
from vecpoly.drawing.scene import Fill, Stroke, TextBox
from vecpoly.typeset import Glyphs


def faults(drawn: Drawing) -> list[str]:
    """Every label that stands on a line, an arrowhead, a dot or another label."""
    found: list[str] = []
    boxes = [shapely.box(r.x0, r.y0, r.x1, r.y1) for r in drawn.label_boxes]
    for i, box in enumerate(boxes):
        found += [f"label {i} on label {j}" for j in range(i) if box.intersects(boxes[j])]
        for item in drawn.obstacles:
            shape: shapely.Geometry
            match item:
                case Stroke(points=points, width=width):
                    shape = shapely.LineString([(z.real, z.imag) for z in points]).buffer(width / 2, cap_style="flat")
                case Fill(points=points, hue=hue) if not hue.is_tint:
                    shape = shapely.Polygon([(z.real, z.imag) for z in points])
                case TextBox(rect=r):
                    shape = shapely.box(r.x0, r.y0, r.x1, r.y1)
                case _:
                    continue
            if box.intersection(shape).area > 1e-6:
                found.append(f"label {i} on {item}")
    return found


def astray(drawn: Drawing) -> list[str]:
    """Every label without a leader that stands nearer to another point, link or vector than to its own."""
    found: list[str] = []
    for label in drawn.labels:
        if label.foot is not None or label.want.thing is Thing.OTHER:
            continue
        box = shapely.box(label.rect.x0, label.rect.y0, label.rect.x1, label.rect.y1)
        own = _apart(box, label)
        for other in drawn.labels:
            if (
                other.want.thing is label.want.thing
                and other.want.own != label.want.own
                and _apart(box, other) < own - 1e-6
            ):
                found.append(
                    f"{_text(label)} stands nearer to what {_text(other)} names ({_apart(box, other):.1f} mm) "
                    f"than to its own ({own:.1f} mm)"
                )
    return found


def _apart(box: shapely.Polygon, label: Placed) -> float:
    """From a box to the outline of what a label names."""
    return float(box.distance(_line(label))) - label.want.radius


def _line(label: Placed) -> shapely.LineString:
    a, b = label.want.own
    return shapely.LineString([(a.real, a.imag), (b.real, b.imag)])


def _text(label: Placed) -> str:
    return "".join(
        glyphs.text for piece in label.want.pieces for glyphs in piece.box.items if isinstance(glyphs, Glyphs)
    )
