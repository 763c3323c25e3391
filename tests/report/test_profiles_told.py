"""A question whose intermediate results are those of a profile's centre of curvature tells that letter."""

from __future__ import annotations

import pytest

from vecpoly.problem.load import load
from vecpoly.report.document import markup
from vecpoly.solution import solve
from vecpoly.words import Lang


@pytest.mark.parametrize("lang", ["zh", "en"])
@pytest.mark.parametrize(("name", "cam"), [("cam-moves-flat-arm", True), ("cam-roller-load", True), ("3-9", False)])
def test_the_centre_of_curvature_of_a_profile_is_told_on_the_question(name: str, cam: bool, lang: Lang) -> None:
    solution = solve(load(name), repeats=0, precise=False)
    question, _ = markup([solution], lang, "question", {}, None, None)
    told = {"zh": "为凸轮 1 的廓线在接触点", "en": "is the centre of curvature of the profile of cam 1 at the contact"}
    assert (told[lang] in question) is cam
