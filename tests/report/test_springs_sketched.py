"""Springs stand on the sketch of what is given, a torsion spring about its pin."""

from __future__ import annotations

from vecpoly.board.paper.marks import Point, Segment
from vecpoly.problem.load import load
from vecpoly.report.picture import picture
from vecpoly.solution import solve


def test_a_torsion_spring_stands_about_its_pin_with_its_letter() -> None:
    problem = load("return-spring")
    figure = picture(problem, solve(problem, repeats=0, precise=False).construction, 120.0, 80.0)
    assert figure is not None
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    assert abs(spots["M_{s}"] - spots["D"]) < 8.0
    near = [m for m in figure.marks if isinstance(m, Segment) and max(abs(m.a - spots["D"]), abs(m.b - spots["D"])) < 5]
    assert len(near) > 30, "the turns of a spiral"


def test_the_sense_of_its_moment_is_told_where_it_is_worked_out() -> None:
    steps = solve(load("return-spring"), repeats=0, precise=False).construction.steps
    (said,) = [step.words for step in steps if "torsion spring" in step.words.en]
    assert said.en.endswith("Its moment on link 3 is clockwise.") and said.zh.endswith("力矩为顺时针方向。")
