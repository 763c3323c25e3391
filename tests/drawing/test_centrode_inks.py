"""A centrode may lie on a link: it has an ink of its own, in the legend too, and is black where all is black."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.paper.marks import Curve, Role
from vecpoly.drawing.hues import CENTRODES
from vecpoly.drawing.legend.legend import entries
from vecpoly.drawing.scene import Stroke
from vecpoly.drawing.style import Hue


@pytest.mark.parametrize(("plain", "inks"), [(False, set(CENTRODES.values())), (True, {Hue.BLACK})])
def test_the_legend_shows_centrodes_in_their_inks(plain: bool, inks: set[Hue]) -> None:
    construction = drawn("curv-5").construction
    construction = construction.toned({}) if plain else construction
    figures = [one for one in construction.figures if any(isinstance(mark, Curve) for mark in one.marks)]
    assert {mark.role for one in figures for mark in one.marks if isinstance(mark, Curve)} >= {Role.LOCUS, Role.CARRIED}
    shown = [one for one in entries(figures, "en") if "centrode" in one.words.en]
    assert len(shown) == 2
    assert {item.hue for one in shown for item in one.sample if isinstance(item, Stroke)} == inks
