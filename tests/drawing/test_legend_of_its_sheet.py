"""A legend has only words of its own sheet: no forces on a rotor, no pitch curve under a knife edge or a face."""

from __future__ import annotations

from functools import cache

import pytest

from vecpoly.board.paper.marks import Dot, Mark, Passing, Point, Role, Segment
from vecpoly.board.paper.tones import whose
from vecpoly.drawing.legend import on_sheet
from vecpoly.drawing.legend.kinds import kinds_met
from vecpoly.drawing.legend.legend import cells, entries
from vecpoly.drawing.legend.on_sheet import with_legend
from vecpoly.drawing.scene import Stroke, TextBox
from vecpoly.drawing.sheets.sheet import Sheet, sheets
from vecpoly.foundation.slotted import replace
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


def legend_of(*marks: Mark) -> list[str]:
    """What a legend tells of a diagram with these."""
    (figure, *_) = solve(load("3-9"), repeats=0, precise=False).construction.figures
    return [one.words.en for one in kinds_met([replace(figure, marks=marks)], "en")]


def test_what_lies_under_something_thicker_is_in_no_legend() -> None:
    """2-8full told of a bar that runs on past a multiple joint, 2-7 of a centre line under a bar: nobody saw either."""
    past, pin = Passing(at=5 + 5j, along=1 + 0j), Point(at=5 + 5j, label="A", dot=Dot.MULTIPLE)
    axis, bar = (Segment(a=low, b=high, role=role) for low, high, role in ((2j, 9j, Role.CENTRE), (0j, 9j, Role.LINK)))
    assert "bar runs on past the pin" in legend_of(past, replace(pin, dot=Dot.JOINT))
    assert "bar runs on past the pin" not in legend_of(past, pin)
    assert "centre or reference line" in legend_of(axis, replace(bar, b=8j))
    assert "centre or reference line" not in legend_of(axis, bar)


def test_each_sheet_of_a_structure_tells_of_no_line_that_is_covered() -> None:
    assert "bar runs on past the pin" not in told("2-8full") and "centre or reference line" not in told("2-7")


def test_a_legend_on_several_blocks_has_one_title_and_says_that_it_goes_on() -> None:
    """A course report had three boxes on one sheet, each of which was called the legend."""
    made = sheets(solve(load("3-9"), repeats=0, precise=False).construction, lang="en")
    (sheet, *_) = made
    some = cells(entries([one.figure for one in sheet.figures if one.figure is not None], "en"), "en")
    parted = on_sheet._parted(sheet, some, len(some) // 2, 2)
    assert parted is not None
    titles = [item.box.text for item in parted.results if isinstance(item, TextBox) and "Legend" in item.box.text]
    assert titles == ["Legend", "Legend (continued)"] and len(titles) == _frames(parted)


def _frames(sheet: Sheet) -> int:
    """The blocks of a sheet that has a frame about each."""
    return sum(isinstance(item, Stroke) and item.closed and len(item.points) == 4 for item in sheet.results)
