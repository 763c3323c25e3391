"""I among II and III is a number, upright; alone it is a point, italic as all points are."""

from __future__ import annotations

import pytest

from tests.texts import CRANK
from vecpoly import load, loads, solve
from vecpoly.drawing.figure import drawing
from vecpoly.typeset import Glyphs
from vecpoly.typeset.fonts import Face

POINT = CRANK.replace("BC: 100 mm", "BC: 100 mm, I: {along: BC, at: 40 mm, left: 20 mm}")


@pytest.mark.parametrize(("name", "face"), [("a point I", Face.ITALIC), ("6-2", Face.STIX)])
def test_a_point_i_is_italic_on_a_figure_and_a_plane_i_beside_others_is_upright(name: str, face: Face) -> None:
    figures = solve(load(name) if name == "6-2" else loads(POINT), repeats=0).construction.figures
    labels = [label for figure in figures for label in drawing(figure, lang="zh").labels]
    items = [item for label in labels for piece in label.want.pieces for item in piece.box.items]
    assert {item.font for item in items if isinstance(item, Glyphs) and item.text == "I" and item.size > 9} == {face}
