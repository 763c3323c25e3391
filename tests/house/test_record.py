"""A construction survives the way to JSON and back."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests import force_figures
from vecpoly.board.construction import Construction, Pane, Step, View
from vecpoly.errors import VecpolyError
from vecpoly.problem.load import load
from vecpoly.record import from_json, to_json
from vecpoly.solution import solve
from vecpoly.words import Words


@pytest.mark.parametrize("name", ["3-6", "3-9", "3-13", "7-5", "7-6"])
def test_a_construction_goes_to_json_and_back(name: str) -> None:
    construction = solve(load(name)).construction
    again = from_json(to_json(construction), Construction)
    assert again.figures == construction.figures
    assert again.steps == construction.steps
    assert dict(again.readings) == dict(construction.readings)


def test_free_bodies_with_their_names_and_marks_go_to_json_and_back() -> None:
    figures = tuple(make() for make in force_figures.SINGLE.values())
    step = Step(number=1, section=Words.same(""), words=Words("取分离体", "The free body"), view=Pane(View.BODY, "2"))
    construction = replace(force_figures.slider_crank(), figures=figures, steps=(step,))
    again = from_json(to_json(construction), Construction)
    slide = replace(force_figures.slide(), tones=construction.tones)
    assert again == construction and again.figure(Pane(View.BODY, "3")) == slide


@pytest.mark.parametrize("text", ["", "[]", '{"is": "Nothing"}', '{"is": "Words", "zh": "a", "en": "b"}', '{"a": 1}'])
def test_other_json_is_refused(text: str) -> None:
    with pytest.raises(VecpolyError, match="Construction"):
        from_json(text, Construction)
