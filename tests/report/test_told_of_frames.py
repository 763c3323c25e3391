"""What is said of scales and frames is true of them: one scale is one, what is printed in a frame is begun with."""

from __future__ import annotations

from cmath import rect

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.marks import Arc, Point, Segment
from vecpoly.figures import View
from vecpoly.problem.load import load
from vecpoly.report.document import markup
from vecpoly.report.question.framed.frames import frames
from vecpoly.report.question.kinds import kinds
from vecpoly.report.titles import subject
from vecpoly.solution import solve
from vecpoly.words import Lang

LANGS: tuple[Lang, ...] = ("zh", "en")


def told(name: str, lang: str) -> str:
    return markup([solve(load(name))], lang, "question", {}, None, None)[0]  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["8-4", "8-15"])
def test_a_frame_with_pivots_in_it_leaves_no_choice_of_place(name: str) -> None:
    assert "they are built upon the lines given there" in told(name, "en") and "your choice" not in told(name, "en")
    assert "以框内已给出的图线为基础作图" in told(name, "zh")


@pytest.mark.parametrize(
    ("name", "words"), [("8-4", "Draw to the scale $μ_l$ ="), ("3-5", "Draw to these scales: $μ_l$")]
)
def test_one_scale_is_not_spoken_of_as_several(name: str, words: str) -> None:
    assert words in told(name, "en")


@pytest.mark.parametrize("name", ["7-1", "7-2b"])
def test_a_machine_reduced_to_one_link_is_headed_by_the_motion_of_machines(name: str) -> None:
    assert subject([solve(load(name))]).zh == "机械的运转及其速度波动作业"


def test_equations_with_and_without_friction_have_names_of_their_own() -> None:
    steps = [step for step in solve(load("5-3")).construction.steps if step.equation is not None]
    assert kinds(steps, "zh") == ["夹紧行程：力平衡方程（计入摩擦）", "夹紧行程：力平衡方程（不计摩擦）"]
    assert len(set(kinds(steps, "en"))) == 2 and kinds(steps, "en")[1].endswith(", without friction")


@each((*IDS, "5-1", "travel-doubler"))
def test_no_two_equations_of_a_question_are_called_alike(name: str) -> None:
    construction = drawn(name).construction
    steps = [step for step in construction.steps if step.equation is not None]
    for lang in LANGS:
        told = kinds(steps, lang, construction.figures)
        assert len(set(told)) == len(told), told


@pytest.mark.parametrize("name", ["cam-heart", "cam-roller-offset"])
def test_a_place_of_a_cam_that_is_drawn_apart_begins_with_its_centre_and_base_circle(name: str) -> None:
    problem = load(name)
    construction = solve(problem).construction
    apart = [figure.name for figure in construction.figures if figure.view is View.MECHANISM and figure.name]
    shown = {figure.name: figure for figure in frames(construction, problem)[0].figures}
    assert apart
    for one in apart:
        marks = shown[one].marks
        centre = next(mark for mark in marks if isinstance(mark, Point) and mark.label == "O")
        (circle,) = (mark for mark in marks if isinstance(mark, Arc))
        low, high = bounds([mark for mark in marks if isinstance(mark, Segment)])
        assert circle.centre == centre.at and abs(circle.radius * shown[one].scale.value - problem.subject.r0.si) < 1e-9  # type: ignore[union-attr]
        ends = [circle.centre + rect(circle.radius, circle.start + circle.sweep * part) for part in (0.0, 0.5, 1.0)]
        assert all(low.real < z.real < high.real and low.imag < z.imag < high.imag for z in ends)


def test_equations_of_one_part_are_told_apart_by_the_figures_in_which_they_are_drawn() -> None:
    drawing = solve(load("6-7"), repeats=0, precise=False).construction
    steps = [step for step in drawing.steps if step.equation is not None]
    told = kinds(steps, "en", drawing.figures)
    assert told == [f"Polygon of plane ${plane}$: vector equation" for plane in ("I", "II")]
