"""A legend has only words of its own sheet: no forces on a rotor, no pitch curve under a knife edge or a face."""

from __future__ import annotations

from functools import cache

import pytest

from vecpoly.board.paper.tones import whose
from vecpoly.drawing.legend.legend import entries
from vecpoly.drawing.legend.on_sheet import with_legend
from vecpoly.drawing.scene import TextBox
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.problem.load import load
from vecpoly.solution import solve

ROTORS = ("field-influence", "field-two-runs", "rotor-grade", "rotor-bolt-circle", "6-5")


@cache
def told(name: str) -> frozenset[str]:
    figures = solve(load(name), repeats=0, precise=False).construction.figures
    return frozenset(one.words.en for one in entries(figures, "en"))


@pytest.mark.parametrize("name", ROTORS)
def test_where_nothing_acts_no_legend_speaks_of_forces_or_friction(name: str) -> None:
    assert not [words for words in told(name) if "force" in words or "friction" in words]


@pytest.mark.parametrize("name", ["rotor-grade", "rotor-bolt-circle", "6-5"])
def test_the_arrow_of_a_product_on_a_rotor_is_named_as_its_direction(name: str) -> None:
    assert "direction of a mass–radius product" in told(name)


def test_forces_are_named_where_they_act_with_and_without_friction() -> None:
    assert {"force (length not to scale)", "force without friction", "friction circle"} <= told("4-3a")


@pytest.mark.parametrize("name", ["train-ring", "train-differential", "train-stepped"])
def test_the_circle_of_a_wheel_that_meshes_is_no_base_circle(name: str) -> None:
    assert "pitch circle" in told(name) and "base circle" not in told(name)


@pytest.mark.parametrize(
    ("name", "pitch"), [("cam-heart", False), ("cam-flat-arm", False), ("cam-flat-face", False), ("cam-rocker", True)]
)
def test_a_pitch_curve_is_named_where_a_roller_makes_it_another_than_the_profile(name: str, pitch: bool) -> None:
    assert any("pitch curve" in words for words in told(name)) is pitch
    assert any(words.startswith("part of the") for words in told(name))


def test_vibrations_are_vectors_of_their_own_and_a_force_without_friction_is_its_force() -> None:
    assert len({whose(key) for key in ("V_0", "V_1", "V_t")}) == 3 and whose("F_0") == whose("F")


@pytest.mark.parametrize("name", ["4-3a", "4-3c"])
def test_a_force_that_is_cut_at_the_ring_of_a_detail_is_no_deviation_from_a_curve(name: str) -> None:
    """4-3c: an arc that a detail cuts was the path of a point, and the force beside it a maximum deviation."""
    made = sheets(solve(load(name), repeats=0, precise=False).construction, lang="en")
    cut = [one for sheet in made for one in sheet.figures if one.figure is not None and one.figure.name[-1:].isdigit()]
    told = " ".join(item.box.text for one in made for item in with_legend(one).results if isinstance(item, TextBox))
    assert cut and "friction" in told and "deviation" not in told and "path of a point" not in told
