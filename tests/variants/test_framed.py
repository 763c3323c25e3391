"""Which figures get a frame on a student's sheet: those whose scales were chosen for it, others where they fit."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Role, Vector
from vecpoly.figures import view_named
from vecpoly.foundation.slotted import replace
from vecpoly.problem.load import load
from vecpoly.problem.problem import Scales
from vecpoly.variants.frames import CLEAR, FRAMED, HEIGHT, WIDTH, beside_sheet, filled, on_sheet, scaled
from vecpoly.words import Words

CAMS = ("cam-flat-face", "cam-rocker", "cam-roller-offset", "3-9")
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


@each(tuple(dict.fromkeys((*IDS, "cam-rocker"))))
def test_every_figure_fits_its_frame_at_the_scale_that_is_chosen_for_all_of_its_kind(name: str) -> None:
    """Each may have been drawn to a scale of its own: the fullest is not always the largest (`cam-rocker`, whose cam
    had 185 mm in a frame of 138 mm, and whose sheet held it no more)."""
    figures = drawn(name).construction.figures
    found = scaled(replace(load(name), scales=Scales()), drawn(name).construction)
    assert found is not None
    for one in figures:
        mu = found.scales.of(one.view.mu)
        if one.view in FRAMED and not one.aside and one.scale.symbol and filled(one):
            assert mu is not None and filled(one) * one.scale.value <= mu * (1 + 1e-9), (one.view.name, one.name)


@each(CAMS)
def test_a_diagram_to_scale_has_a_frame_or_is_drawn_where_the_work_is_done(name: str) -> None:
    figures = drawn(name).construction.figures
    framed, beside = on_sheet(figures), beside_sheet(figures)
    scaled_ones = [one for one in figures if not one.aside and one.scale.symbol and one.view is not View.BODY]
    assert sorted(map(id, (*framed, *beside))) == sorted(map(id, scaled_ones)) and framed
    assert not {one.view for one in beside} & set(FRAMED)
    assert all(filled(one) * (WIDTH - 2 * CLEAR) < WIDTH for one in framed if one.view not in FRAMED)
