"""A given limit position of a rocker is drawn with all that is given; a meeting on its wrong side is told."""

from __future__ import annotations

import pytest

import vecpoly
from tests.synthesis.inversion import posed, solved
from vecpoly.board.paper.marks import Point, Segment
from vecpoly.report.question.sketch import sketched


def cutter(limit: str, first: str, ends: tuple[str, str]) -> vecpoly.Problem:
    """8-14 with another limit of the rocker given."""
    stage = {"limits": "C", "on": "DC", "crank": "AB", "K": "1.4", "first": first, "limit": limit}
    frame = {"A": ["0 mm", "0 mm"], "D": ["800 mm", "-120 mm"]}
    stages = [stage, {"find": "E", "on": "DC", "from": "F"}]
    return posed("stages", frame=frame, rays={}, points={"F": list(ends)}, stages=stages)


LEFT = ("left", "(380, -680) mm", ("(840, -750) mm", "(1790, -750) mm"))
RIGHT = ("right", "(1183.319, -705.116) mm", ("(1790, -750) mm", "(840, -750) mm"))


@pytest.mark.parametrize("data", [LEFT, RIGHT])
def test_the_sketch_of_what_is_given_shows_the_limit_position(data: tuple[str, str, tuple[str, str]]) -> None:
    problem = cutter(*data)
    figure = sketched(problem, solved(problem).construction, 120, 80)
    assert figure is not None
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    bars = [{mark.a, mark.b} for mark in figure.marks if isinstance(mark, Segment)]
    assert "C_1" in at and "C_2" not in at
    assert any(
        min(abs(end - at["C_1"]) for end in bar) < 1e-6 and min(abs(end - at["D"]) for end in bar) < 1e-6
        for bar in bars
    )


@pytest.mark.parametrize("data", [LEFT, RIGHT])
def test_a_meeting_that_would_make_it_the_other_limit_is_told(data: tuple[str, str, tuple[str, str]]) -> None:
    said = [step.words for step in solved(cutter(*data)).construction.steps]
    assert any(f"on the {data[0]} of $C_1$ is rejected" in words.en and "舍去" in words.zh for words in said)
