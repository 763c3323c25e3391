"""Linkages through positions: cases with all their solutions, and the exercises of chapter 8."""

from __future__ import annotations

import json
from math import asin, cos, degrees, radians, sin
from pathlib import Path
from typing import Any

import pytest

import vecpoly
from tests.synthesis.inversion import posed, solved
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.designs.base import Design
from vecpoly.errors import ProblemFileError
from vecpoly.oracle.synthesis.registry import linkages

CASES: list[dict[str, Any]] = json.loads(
    (Path(__file__).resolve().parents[1] / "data" / "synthesis-inversion.json").read_text("utf-8")
)
CHAPTER_8 = {
    "8-6": {"AB": 95.835776, "CD": 264.309050, "AD": 308.040800},
    "8-6-2": {"AB": 95.562923, "BC": 127.198796, "CD": 264.726705},
    "8-7": {"AB": 50.372749, "BC": 183.070139},
    "8-8": {"BC": 55.554331, "CD": 22.223793, "delta_C": 9.28037},
    "8-9": {"AB": 28.340524, "BC": 50.463361, "delta_B": -32.34846},
    "8-10": {"AB": 43.705522, "BC": 35.212157},
    "8-11": {"AB": 44.721360, "BC": 22.311215, "CD": 62.243234, "AD": 50.0},
    "8-13": {"DC": 37.260211, "CE": 42.739789, "AB": 10.262580, "BC": 58.597657},
}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["id"])
def test_every_listed_linkage_is_drawn_and_no_other(case: dict[str, Any]) -> None:
    problem = posed(case["synthesis"], **case["data"])
    found = solved(problem).construction.candidates
    assert len(found) == len(case["values"])
    for one, true in zip(found, case["values"], strict=True):
        assert one.verdict == "VALID"
        assert {key: one.values[key] for key in true} == pytest.approx(true, rel=case["digits"])


@pytest.mark.parametrize("name", CHAPTER_8)
def test_an_exercise_of_chapter_8_is_solved(name: str) -> None:
    solution = solved(vecpoly.load(name))
    found = {key: answer.drawn for key, answer in solution.answers.items()}
    assert found == pytest.approx(CHAPTER_8[name], abs=2e-6)


@pytest.mark.parametrize("name", [*CHAPTER_8, "8-12", "8-14", "four-positions", "three-positions", "two-pairs"])
def test_drawing_and_closed_form_agree_to_the_last_digits_and_in_every_verdict(name: str) -> None:
    problem = vecpoly.load(name)
    drawn = solved(problem)
    for answer in drawn.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9)
    assert isinstance(problem.subject, Design)
    exact = linkages(problem.subject)
    assert [one.verdict for one in drawn.construction.candidates] == [one.verdict.name for one in exact]


def test_the_printed_crank_of_8_13_is_found_wrong_and_the_other_lengths_right() -> None:
    told = {line.printed.symbol: line for line in check_problem(vecpoly.load("8-13")).answers}
    assert told["AB"].deviation == pytest.approx(0.0816, abs=1e-4)
    assert {name: line.verdict for name, line in told.items() if line.verdict is not Verdict.REPRODUCED} == {
        "AB": Verdict.WRONG
    }


def test_of_8_15_the_coupler_and_the_frame_are_wrong_in_print() -> None:
    told = {line.printed.symbol: line.verdict for line in check_problem(vecpoly.load("8-15")).answers}
    assert {name for name, verdict in told.items() if verdict is Verdict.WRONG} == {"BC", "AD"}
    assert Verdict.OUTLIER not in told.values()


def test_8_10_is_a_rocker_slider_by_its_lengths() -> None:
    told = "".join(step.words.en for step in solved(vecpoly.load("8-10")).construction.steps)
    assert "$l_{AB} + e$ > $l_{BC}$, where $e$ is the distance of $A$ from the guide, $ABC$ is a rocker-slider" in told


def test_a_place_by_distance_and_a_direction_by_its_sine_are_those_of_their_coordinates() -> None:
    data = {"links": {"DC": "120 mm"}, "stages": [{"find": "B", "on": "AB", "from": "C"}]}
    angle, x, y = degrees(asin(0.3)), 250 * cos(radians(40)), -250 * sin(radians(40))
    typed = posed(
        "stages",
        **data,
        frame={"A": ["0 mm", "0 mm"], "D": [f"{x!r} mm", f"{y!r} mm"]},
        rays={"AB": ["0 deg", "90 deg"], "DC": [f"{90 - angle!r} deg", f"{90 + angle!r} deg"]},
    )
    first, told = solved(typed).construction.candidates[0], solved(vecpoly.load("8-7")).construction.candidates[0]
    assert dict(first.values) == pytest.approx(dict(told.values), rel=1e-9)


def test_a_sine_above_one_is_refused_with_its_value() -> None:
    with pytest.raises(ProblemFileError, match="the sine 2 must lie between"):
        posed(
            "stages",
            frame={"A": ["0 mm", "0 mm"], "D": "250 mm at -40 deg"},
            links={"DC": "120 mm"},
            rays={"AB": ["0 deg", "90 deg"], "DC": ["90 deg - asin(60 mm / 30 mm)", "90 deg"]},
            stages=[{"find": "B", "on": "AB", "from": "C"}],
        )


def test_a_pin_found_beyond_its_pivot_is_at_180_degrees_by_drawing_and_by_closed_form() -> None:
    problem = posed("angle-pairs", AB="30 mm", AD="60 mm", pairs=["50 deg -> 220 deg", "65 deg -> 240 deg"])
    (one,) = solved(problem).construction.candidates
    assert isinstance(problem.subject, Design)
    assert one.values["delta_C"] == linkages(problem.subject)[0].values["delta_C"] == 180.0
