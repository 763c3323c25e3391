"""Which figures get a frame on a student's sheet: those whose scales were chosen for it, others where they fit."""

from __future__ import annotations

import pytest

from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Role, Vector
from vecpoly.figures import view_named
from vecpoly.variants.frames import FRAMED, HEIGHT, on_sheet
from vecpoly.words import Words

OTHERS = ("torque", "energy", "hodograph", "turns")


def figure(view: View, tall: float) -> Figure:
    """A figure with one upright vector, so many mm long."""
    marks = (Vector(a=0j, b=complex(0.0, tall), label="v", role=Role.RESULT),)
    return Figure(view=view, title=Words.same("t"), scale=Scale(symbol="μ", value=0.01, unit="m/s"), marks=marks)


@pytest.mark.parametrize("view", FRAMED)
def test_a_figure_whose_scale_was_chosen_for_its_frame_has_one_whatever_it_measures(view: View) -> None:
    full = figure(view, HEIGHT)
    assert on_sheet([full]) == (full,)


@pytest.mark.parametrize("name", OTHERS)
def test_any_other_has_a_frame_where_it_fits(name: str) -> None:
    small, tall = (figure(view_named(name), share * HEIGHT) for share in (0.5, 1.5))
    assert on_sheet([small, tall]) == (small,)
