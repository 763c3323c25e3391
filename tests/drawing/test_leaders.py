"""A leader runs through no letter, and ends short of its own."""

from __future__ import annotations

import pytest
import shapely

from tests.laws import few
from tests.studies import solved
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.labels.spots import SHORT
from vecpoly.drawing.scene import Stroke
from vecpoly.drawing.weighing.placed import Placed

CLOSE = 0.3  # mm within which a line is read as one through the letter


def leader(label: Placed) -> shapely.LineString:
    """As it is drawn."""
    (line,) = (item for item in label.items() if isinstance(item, Stroke))
    return shapely.LineString([(z.real, z.imag) for z in line.points])


def box(label: Placed) -> shapely.Geometry:
    """What its type covers."""
    r = label.rect
    return shapely.box(r.x0, r.y0, r.x1, r.y1)


@pytest.mark.parametrize("name", few(["8-4", "8-9", "8-12", "A-27", "class-iii-slides", "curv-1"], 2))
def test_a_leader_runs_through_no_letter_and_ends_short_of_its_own(name: str) -> None:
    for figure in solved(name).construction.figures:
        labels = drawing(figure).labels
        for one in (label for label in labels if label.foot is not None):
            assert leader(one).distance(box(one)) > SHORT - 1e-6
            assert all(leader(one).distance(box(other)) > CLOSE for other in labels if other is not one)
