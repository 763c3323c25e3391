"""A diagram of few lines stands beside what it belongs to: no sheet is left for the circle diagram of centres alone."""

from __future__ import annotations

from tests.drawn_sheets import laid
from tests.each import each

CENTRES = ("3-1a", "3-1b", "3-1c", "3-1d", "3-1e", "3-1f", "3-2", "3-3", "D-1", "D-2", "D-3", "D-3-knife", "class-iii")


@each(CENTRES)
def test_no_circle_diagram_of_centres_has_a_sheet_of_its_own(name: str) -> None:
    for sheet in laid(name):
        names = [one.name for one in sheet.figures]
        assert names != ["centre polygon"]
