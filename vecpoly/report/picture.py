"""Pictures for the text: the mechanism alone, reduced to fit, and the blank frames of a question sheet."""

from __future__ import annotations

from dataclasses import fields, replace
from math import ceil
from typing import Any

from ..board.construction import Construction, Figure, View
from ..board.extent import bounds, extent
from ..board.marks import Dot, FixedGuide, Ground, Mark, Point, RackMark, Role, Segment
from ..words import Words

SKETCH = Words("机构简图（示意）", "The mechanism (sketch)")
_HELP = {Role.CONSTRUCTION, Role.DIRECTION, Role.HIDDEN}


def sketch(construction: Construction, width: float, height: float) -> Figure:
    """The mechanism without construction lines, reduced so that it fits width × height mm; symbols keep their size."""
    figure = construction.figure(View.MECHANISM)
    assert figure is not None
    drawn = max(s.number for s in construction.steps if s.section == construction.steps[0].section)
    marks = [m for m in figure.marks if getattr(m, "role", None) not in _HELP and m.step <= drawn]
    size = extent(marks)
    factor = min(1.0, width / max(size[0], 1.0), height / max(size[1], 1.0))
    return replace(figure, title=SKETCH, marks=tuple(scaled(m, factor) for m in marks),
                   scale=replace(figure.scale, value=figure.scale.value / factor))


def scaled(mark: Mark, factor: float) -> Any:
    """The mark with all its places multiplied by the factor; radii of arrows and angle marks stay."""
    changed: dict[str, Any] = {}
    for f in fields(mark):
        value = getattr(mark, f.name)
        if isinstance(value, complex) and f.name in ("a", "b", "at", "centre"):
            changed[f.name] = value * factor
        elif f.name == "points":
            changed[f.name] = tuple(p * factor for p in value)
        elif f.name == "radius" and hasattr(mark, "centre"):
            changed[f.name] = value * factor
    return replace(mark, **changed)


def frames(construction: Construction) -> Construction:
    """The blank sheet: for each figure a frame of its size with what is given in it: pivots, guides, poles."""
    return replace(construction, figures=tuple(_frame(f) for f in construction.figures))


def _frame(figure: Figure) -> Figure:
    low, high = (corner + margin for corner, margin in zip(bounds(figure.marks), (-10 - 10j, 10 + 10j), strict=True))
    high = low + complex(ceil(high.real - low.real), ceil(high.imag - low.imag))
    box = (low, complex(high.real, low.imag), high, complex(low.real, high.imag))
    border = tuple(Segment(a=a, b=b, role=Role.DIRECTION, step=1) for a, b in zip(box, box[1:] + box[:1], strict=True))
    pivots = {m.at for m in figure.marks if isinstance(m, Ground)}
    given = tuple(m for m in figure.marks if _given(m, figure.view, pivots))
    return replace(figure, marks=border + given)


def _given(mark: Mark, view: View, pivots: set[complex]) -> bool:
    """What the question sheet shows: fixed pivots, guides and racks; the poles."""
    if view is not View.MECHANISM:
        return isinstance(mark, Point) and mark.dot is Dot.POLE
    return isinstance(mark, (Ground, FixedGuide, RackMark)) or (isinstance(mark, Point) and mark.at in pivots)
