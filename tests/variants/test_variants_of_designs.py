"""Variants of a mechanism that is to be found, of cams and trains: values in lists, gates, frames on the sheet."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.errors import ArgumentError
from vecpoly.variants.frames import on_sheet
from vecpoly.variants.pilot import pilot


@pytest.mark.parametrize(
    ("name", "value", "written", "where"),
    [
        ("three-positions", {"poses_2_3": "34 deg"}, "(49, 12) mm at 34 deg", ("poses", 1)),
        ("three-positions", {"poses_2_1": "40 mm", "poses_2_2": "9 mm"}, "(40, 9) mm at 30 deg", ("poses", 1)),
        ("three-positions", {"x_B": "3 mm"}, "3 mm", ("body", "B", 0)),
        ("8-10", {"x_C_1": "71 mm"}, "(71, -12) mm", ("points", "C", 0)),
        ("8-10", {"CE_2": "170 deg"}, "170 deg", ("rays", "CE", 1)),
        ("8-9", {"pairs_2_1": "70 deg"}, "70 deg -> 62 mm", ("pairs", 1)),
        ("8-9", {"guide": "-8 mm"}, "on y = -8 mm", ("guide",)),
        ("cam-roller-offset", {"motion_1_1": "25 mm"}, "rise 25 mm in 120 deg cosine", ("motion", 0)),
    ],
)
def test_a_value_in_a_list_or_phrase_is_varied_by_its_number(
    name: str, value: dict[str, str], written: str, where: tuple[str | int, ...]
) -> None:
    found = vecpoly.load(name).vary(**value).data["data"]
    for step in where:
        found = found[step]
    assert found == written


def test_a_number_in_brackets_has_the_unit_behind_them() -> None:
    with pytest.raises(ArgumentError, match="with the unit mm behind them; give it in mm, not '7 cm'"):
        vecpoly.load("8-10").vary(x_C_1="7 cm")


def test_a_problem_with_flat_meetings_of_its_own_has_variants_with_meetings_not_much_flatter() -> None:
    problem = vecpoly.problem(
        {**vecpoly.load("8-4").data, "vary": {"AD": "90 mm .. 120 mm by 2 mm", "ADC": "40 deg .. 60 deg by 2 deg"}}
    )
    assert pilot(problem).passed > 0.1


def test_every_diagram_of_a_train_has_a_frame_on_the_question_sheet() -> None:
    drawn = vecpoly.solve(vecpoly.load("train-ring"), repeats=0).construction
    assert [one.view.name for one in on_sheet(drawn.figures)] == ["mechanism", "radii", "turns"]
