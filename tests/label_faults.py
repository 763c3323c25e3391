"""What is wrong with the lettering of a figure."""

from __future__ import annotations

import shapely

from vecpoly.drawing.figure import Drawing
from vecpoly.drawing.scene import Fill, Stroke, TextBox


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
