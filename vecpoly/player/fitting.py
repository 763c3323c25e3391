"""Scales all through the cycle: one for all places if their polygons can share it;
where a polygon would outgrow its pane, a coarser one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from math import inf

from ..board.construction import Construction, View
from ..board.paper.extent import bounds
from ..board.paper.scales import SERIES, round_up
from ..drawing.scene import Rect
from ..figures import views
from ..figures.mu import LENGTH
from ..problem.problem import Scales
from ..solution import scales_of

SIDE = 150.0  # mm: a pane is no wider and no higher, unless the given polygon needs more
AMPLE = 1.3  # of the given polygon: a pane may always be so large
MOST = 0.85  # of the places share one scale
COARSE = (1.0, 2.0, 5.0, 10.0)  # steps of the scales of those that do not: few jumps
POLE = Rect(0.0, 0.0, 0.0, 0.0)

Panes = Mapping[str, Rect]


def fitted(places: Sequence[Construction], start: int) -> list[Scales]:
    """For each place the scales with which its polygons fit panes that do not change;
    all are drawn at the scales of the place `start`."""
    if not places:
        return []
    scales = [scales_of(places[start])] * len(places)
    for view in (view for view in views() if view.mu != LENGTH):
        given = scales[start].of(view.mu)
        boxes = [_boxes(one, view) for one in places]
        if given is not None and any(boxes):
            values = coarsened(boxes, boxes[start], given)
            scales = [one.changed(view.mu, value) for one, value in zip(scales, values, strict=True)]
    return scales


def coarsened(boxes: Sequence[Panes], own: Panes, given: float) -> list[float]:
    """The scale of each place whose polygons take these boxes (mm round their poles) at the given scale."""
    side = max([SIDE, *(AMPLE * max(box.width, box.height) for box in own.values())])
    order = sorted(range(len(boxes)), key=lambda i: _reach(boxes[i]))
    many = order[: max(1, round(MOST * len(order)))]
    base = next(
        value
        for value in _coarser(given, SERIES)
        if _fits(_hull([_shrunk(boxes[i], given / value) for i in many]), side)
    )
    panes = _hull([_shrunk(boxes[i], given / base) for i in many])
    values = [base] * len(boxes)
    for i in order[len(many) :]:
        values[i] = next(
            value
            for value in (base, *_coarser(base, COARSE))
            if _fits(_hull([panes, _shrunk(boxes[i], given / value)]), side)
        )
        panes = _hull([panes, _shrunk(boxes[i], given / values[i])])
    return values


def _coarser(given: float, steps: Sequence[float]) -> list[float]:
    """The given scale and the round ones beyond it, up to a million times as coarse."""
    first = round_up(given)
    power = 10.0 ** int(f"{first:e}".split("e")[1])
    return [
        given,
        *(
            float(f"{step * power * 10.0**k:.6g}")
            for k in range(7)
            for step in steps[:-1]
            if step * power * 10.0**k > given * (1 + 1e-9)
        ),
    ]


def _boxes(construction: Construction, view: View) -> dict[str, Rect]:
    """What the polygons of a view take on paper (mm), with their poles."""
    corners = {f.name: bounds(f.marks) for f in construction.figures if f.view is view and not f.aside}
    return {name: POLE | Rect(low.real, low.imag, high.real, high.imag) for name, (low, high) in corners.items()}


def _reach(boxes: Panes) -> float:
    return max((abs(edge) for box in boxes.values() for edge in (box.x0, box.y0, box.x1, box.y1)), default=0.0)


def _shrunk(boxes: Panes, by: float) -> dict[str, Rect]:
    return {name: Rect(by * box.x0, by * box.y0, by * box.x1, by * box.y1) for name, box in boxes.items()}


def _hull(many: Sequence[Panes]) -> dict[str, Rect]:
    """Per polygon the box round all its boxes."""
    return {
        name: reduce(Rect.__or__, (boxes[name] for boxes in many if name in boxes))
        for name in {name for boxes in many for name in boxes}
    }


def _fits(panes: Panes, side: float) -> bool:
    return max((max(box.width, box.height) for box in panes.values()), default=-inf) <= side
