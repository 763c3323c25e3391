"""What is rejected or refused, and why: circuit, branch, order; lines that do not meet; data that do not fit."""

from __future__ import annotations

from math import isfinite
from typing import Any

import pytest

import vecpoly
from tests.flat_positions import FLAT
from tests.synthesis.inversion import drawn_anyhow, place, pose, posed, solved
from vecpoly.board.otherwise.slip import Mistake
from vecpoly.errors import AssemblyError, ProblemFileError
from vecpoly.solution import solve

THREE: dict[str, dict[str, Any]] = {
    "circuit": {
        "poses": [pose(0, 0, 0), pose(35, 15, 34), pose(105, -16, 79)],
        "body": {"B": place(0, 6), "C": place(50, -4)},
    },
    "branch": {
        "poses": [pose(0, 0, 0), pose(33, 33, 18), pose(109, -12, 51)],
        "body": {"B": place(0, -3), "C": place(30, 4)},
    },
    "ok": {
        "poses": [pose(0, 0, 0), pose(49, 12, 30), pose(100, 58, 88)],
        "body": {"B": place(0, -5), "C": place(46, 9)},
    },
}
REASONS = {"circuit": "taken apart", "branch": "meets a dead point"}


@pytest.mark.parametrize(("name", "verdict"), [("circuit", "CIRCUIT"), ("branch", "BRANCH"), ("ok", "VALID")])
def test_the_three_positions_with_a_defect_and_those_without_are_told_apart_on_paper(name: str, verdict: str) -> None:
    (found,) = drawn_anyhow("positions", **THREE[name])
    assert found.verdict == verdict


@pytest.mark.parametrize("name", REASONS)
def test_where_every_candidate_has_a_defect_it_is_concluded_that_there_is_no_solution(name: str) -> None:
    drawn = solved(posed("positions", **THREE[name])).construction
    assert drawn.conclusion is not None and REASONS[name] in drawn.conclusion.en


def test_a_body_that_comes_back_is_in_the_wrong_order() -> None:
    poses = [THREE["ok"]["poses"][i] for i in (0, 2, 1)]
    (found,) = drawn_anyhow("positions", poses=poses, body=THREE["ok"]["body"])
    assert found.verdict == "ORDER"


def test_a_linkage_that_only_its_other_link_can_drive_is_valid_and_says_so() -> None:
    solution = solved(vecpoly.load(FLAT))
    assert [one.verdict for one in solution.construction.candidates] == 3 * ["VALID"]
    told = "".join(step.words.en for step in solution.construction.steps)
    assert "$CD$ must drive it: $AB$ as the driver meets a dead point between the positions" in told


def test_a_bisector_along_the_line_of_the_pin_is_refused() -> None:
    data = {"poses": [pose(-20, 0, 0), pose(20, 0, 30)], "body": {"B": place(0, 0), "C": place(0, 30)}}
    with pytest.raises(AssemblyError, match="does not meet it; choose another line for A") as refused:
        posed("positions", **data, A="on x = 5 mm", D="on y = -40 mm").solve()
    assert "平行" in refused.value.words.zh


def test_a_pin_that_stays_where_it_is_leaves_the_other_undetermined() -> None:
    data = {"poses": [pose(0, 0, 0), pose(0, 0, 40)], "body": {"B": place(0, 0), "C": place(30, 0)}}
    with pytest.raises(AssemblyError, match="A remains undetermined"):
        posed("positions", **data, A="on y = -40 mm", D="on y = -40 mm").solve()


def test_a_body_that_is_only_shifted_is_led_by_two_links_that_turn_alike() -> None:
    data = {"poses": [pose(0, 0, 10), pose(30, 5, 10)], "body": {"B": place(0, 0), "C": place(40, 0)}}
    found = solved(posed("positions", **data, A="on y = -40 mm", D="on y = -40 mm")).answers
    assert found["AB"].drawn == pytest.approx(found["AB"].exact, rel=1e-9)


def test_places_in_a_row_as_a_rocker_sees_them_are_refused_too() -> None:
    pairs = ["0 deg -> 10 mm", "0 deg -> 20 mm", "0 deg -> 40 mm"]
    with pytest.raises(AssemblyError, match=r"as link AE sees them lie on a straight line"):
        posed("angle-pairs", guide="on y = -10 mm", pairs=pairs).solve()


def test_links_that_do_not_reach_each_other_are_refused_with_the_range() -> None:
    data: dict[str, Any] = {
        "frame": {"A": place(0, 0), "D": place(200, 0), "F": place(100, 100)},
        "links": {"AB": "30 mm", "BC": "50 mm", "CD": "40 mm"},
        "rays": {"AB": ["90 deg", "60 deg"], "FE": ["0 deg", "30 deg"]},
        "stages": [{"join": "C", "to": "BD", "side": "left"}, {"find": "E", "on": "FE", "from": "C"}],
    }
    with pytest.raises(AssemblyError, match="join points between 10 and 90 mm apart"):
        posed("stages", **data).solve()


def test_a_limit_that_cannot_be_the_left_one_is_refused() -> None:
    data = vecpoly.load("8-14").data["data"]
    stages = [dict(data["stages"][0], first=place(1500, -120)), data["stages"][1]]
    with pytest.raises(AssemblyError, match="none of which makes C1 the left limit"):
        posed("stages", **{**data, "stages": stages}).solve()


def test_a_line_through_the_pole_puts_both_pivots_there_and_leaves_no_frame() -> None:
    data = {"poses": [pose(-30, 0, -45), pose(30, 0, 45)], "body": {"B": place(0, 0), "C": place(0, 20)}}
    solution = solved(posed("positions", **data, A="on y = -30 mm", D="on y = -30 mm"))
    assert [one.verdict for one in solution.construction.candidates] == ["NO_LINK"] and not solution.suspect


@pytest.mark.parametrize(("name", "count"), [("8-8", 12), ("8-13", 8), ("three-positions-frame", 6)])
def test_mistakes_with_given_angles_can_be_made_and_go_on_to_an_answer(name: str, count: int) -> None:
    problem = vecpoly.load(name)
    right = solved(problem).answers
    made = [slip for slip in vecpoly.slips(problem) if slip.mistake in (Mistake.COMPLEMENT, Mistake.OTHER_SIDE)]
    assert len(made) == count
    wrong = solve(problem, by="exact", repeats=0, precise=False, slip=made[0]).answers
    assert any(abs(wrong[key].drawn - right[key].drawn) > 1e-3 for key in right)
    assert all(isfinite(answer.drawn) for answer in wrong.values())


def test_limits_on_both_sides_of_the_frame_belong_to_two_circuits() -> None:
    data = vecpoly.load("8-14").data["data"]
    stages = [dict(data["stages"][0], K="2"), data["stages"][1]]
    assert [one.verdict for one in drawn_anyhow("stages", **{**data, "stages": stages})] == ["CIRCUIT"]


TWO: dict[str, Any] = {"poses": [pose(0, 0, 0), pose(30, 5, 30)], "body": {"B": place(0, 0), "C": place(30, 0)}}
WRONG: list[tuple[str, dict[str, Any], str]] = [
    ("positions", {"poses": TWO["poses"][:1], "body": TWO["body"]}, "two, three or four"),
    ("positions", TWO, "infinitely many places for A"),
    ("positions", {**THREE["ok"], "A": "on y = 0 mm"}, "three positions determine A already"),
    ("positions", {**THREE["ok"], "frame": {"A": place(0, 0)}}, "1 of the ends of AB must be given, and here are 2"),
    ("positions", {**THREE["ok"], "onto": "4"}, "there are 3 positions"),
    ("positions", {**THREE["ok"], "body": {"B": place(0, 0), "E": place(9, 9)}}, "'E' is no pin of the body"),
    ("positions", {**THREE["ok"], "poses": ["(0, 0) at 3 deg"]}, "is no position; write e.g."),
    ("angle-pairs", {"pairs": ["10 deg -> 20 deg"] * 3, "AB": "30 mm"}, "AD is missing"),
    ("angle-pairs", {"pairs": ["10 deg -> 20 mm"] * 2, "AB": "30 mm", "guide": "on y = 0 mm"}, "AB has no place"),
    ("angle-pairs", {"pairs": ["10 deg -> 20 mm", "10 deg -> 2 deg"], "guide": "on y = 0 mm"}, "two or three pairs"),
    ("angle-pairs", {"pairs": ["10 deg 20 mm"], "guide": "on y = 0 mm"}, "is no pair; write e.g."),
]
CHAIN: dict[str, Any] = {"frame": {"A": place(0, 0), "D": place(30, 0)}, "rays": {"AB": ["90 deg", "30 deg"]}}
FIND = {"find": "B", "on": "AB", "from": "C"}
WRONG += [
    ("stages", {**CHAIN, "stages": [FIND]}, "'C' is not known at this stage; known are A, D"),
    ("stages", {**CHAIN, "stages": [{"find": "B"}]}, "one of three sorts of stage"),
    ("stages", {**CHAIN, "points": {"C": [place(0, 0)]}, "stages": [FIND]}, "AB: 2, C: 1"),
    ("stages", {**CHAIN, "points": {"C": [place(0, 0)] * 2}, "stages": [FIND]}, "different points of one straight"),
    ("stages", {**CHAIN, "rays": {"XB": ["90 deg", "30 deg"]}, "stages": [FIND]}, "'X' is not known"),
    ("cognates", {"AB": "30 mm", "BC": "7 mm", "CD": "6 mm", "AD": "80 mm", "E": place(9, 9), "phi": "40 deg"}, "BD ="),
    (
        "cognates",  # just at a dead point: rounding let it pass, and then there was no C
        {"AB": "40 mm", "BC": "40 mm", "CD": "100 mm", "AD": "100 mm", "E": place(38, -25), "phi": "0 deg"},
        "join points more than 60 and less than 140 mm apart",
    ),
    (
        "cognates",
        {"AB": "3 mm", "BC": "9 mm", "CD": "6 mm", "AD": "8 mm", "E": place(9, 0), "phi": "40 deg"},
        "no cogn",
    ),
]


@pytest.mark.parametrize(("kind", "data", "why"), WRONG)
def test_data_that_do_not_fit_are_refused_where_they_are_read(kind: str, data: dict[str, Any], why: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        posed(kind, **data)
    assert why in str(refused.value)
    assert all(fault.words.zh != fault.words.en for fault in refused.value.faults)
