"""I among II and III is a number, upright; alone it is a point, italic as all points are."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.drawing.figure import drawing
from vecpoly.typeset import Glyphs
from vecpoly.typeset.fonts import Face


@pytest.mark.parametrize(("name", "face"), [("2-13", Face.ITALIC), ("class-iii", Face.ITALIC), ("6-2", Face.STIX)])
def test_a_point_i_is_italic_on_a_figure_and_a_plane_i_beside_others_is_upright(name: str, face: Face) -> None:
    figures = drawn(name).construction.figures
    labels = [label for figure in figures for label in drawing(figure, lang="zh").labels]
    items = [item for label in labels for piece in label.want.pieces for item in piece.box.items]
    assert {item.font for item in items if isinstance(item, Glyphs) and item.text == "I" and item.size > 9} == {face}
