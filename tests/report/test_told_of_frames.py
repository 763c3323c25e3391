"""What is said of scales and frames is true of them: one scale is one, what is printed in a frame is begun with."""

from __future__ import annotations

import pytest

from vecpoly.problem.load import load
from vecpoly.report.document import markup
from vecpoly.report.titles import subject
from vecpoly.solution import solve


def told(name: str, lang: str) -> str:
    return markup([solve(load(name))], lang, "question", {}, None, None)[0]  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["8-4", "8-15"])
def test_a_frame_with_pivots_in_it_leaves_no_choice_of_place(name: str) -> None:
    assert "they begin with what is printed there" in told(name, "en") and "your choice" not in told(name, "en")
    assert "从框内已印出的部分画起" in told(name, "zh")


@pytest.mark.parametrize(
    ("name", "words"), [("8-4", "Draw to the scale $μ_l$ ="), ("3-5", "Draw to these scales: $μ_l$")]
)
def test_one_scale_is_not_spoken_of_as_several(name: str, words: str) -> None:
    assert words in told(name, "en")


@pytest.mark.parametrize("name", ["7-1", "7-2b"])
def test_a_machine_reduced_to_one_link_is_headed_by_the_motion_of_machines(name: str) -> None:
    assert subject([solve(load(name))]).zh == "机械的运转及其速度波动作业"
