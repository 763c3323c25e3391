"""Whatever a lecturer says of points, right work has all of them, no work has more, and what nobody could earn is
refused."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.grading.cases import key_of, mutants_of, problem_of
from tests.grading.test_diagnosis import right
from tests.laws import often
from vecpoly.errors import ProblemFileError
from vecpoly.grading.key import AnswerKey, Kind
from vecpoly.grading.marking.marker import mark
from vecpoly.grading.scheme import scheme_of
from vecpoly.grading.sheet import sheet_of
from vecpoly.problem.marking import marking_of
from vecpoly.problem.text.source import parse

PROBLEM = "3-9"
TURNING = (Kind.SIGNED, Kind.VECTOR)
worth = st.sampled_from([0, 0.5, 1, 2, 7.25, 1000])
share = st.sampled_from([0, 0.25, 0.5, 1])


def filled(names: tuple[str, ...], values: st.SearchStrategy[float]) -> st.SearchStrategy[str]:
    """Some of these keys with values."""
    some = st.dictionaries(st.sampled_from(names), values, max_size=len(names))
    return some.map(lambda said: "{" + ", ".join(f"{name}: {value}" for name, value in said.items()) + "}")


@st.composite
def said(draw: st.DrawFn) -> str:
    """Rules, points of parts, points of single quantities that can be had."""
    key = key_of(PROBLEM)
    rules = draw(filled(("close", "own", "slip", "turned"), share))
    parts = st.sampled_from(["diagram", "velocity", "acceleration", "other"])
    kinds = ("scale", "drawn", "values", "rates", "equation")
    rubric = draw(st.dictionaries(parts, filled(kinds, worth), max_size=3))
    asked = [one for one in key.quantities if one.asked]
    some = draw(st.lists(st.sampled_from(asked), unique_by=lambda one: one.key, max_size=4))
    ways = ("method", "accuracy", "sense")
    points = {one.key: draw(filled(ways if one.kind in TURNING else ways[:2], worth)) for one in some}
    own = "{" + ", ".join(f'"{name}": {one}' for name, one in points.items()) + "}"
    return f"rules: {rules}\nrubric: { {**rubric} }\npoints: {{{PROBLEM}: {own}}}\n".replace("'", "")


def pointed(text: str, problem: str = PROBLEM) -> AnswerKey:
    """The key with these points."""
    return scheme_of(marking_of(parse(text, "rules.yaml")), {problem: key_of(problem)}).key(key_of(problem))


@given(text=said(), blank=st.sets(st.integers(0, 30)), times=st.sampled_from([1.0, -1.0, 0.0, 1.3]))
@settings(max_examples=often(12))
def test_right_work_has_all_points_and_no_work_more(text: str, blank: set[int], times: float) -> None:
    key = pointed(text)
    rules = scheme_of(marking_of(parse(text, "rules.yaml")), {PROBLEM: key}).rules
    whole = right(PROBLEM)
    spoilt = {name: value for n, (name, value) in enumerate(right(PROBLEM, v_B=times).items()) if n not in blank}
    sheets = [mark(problem_of(PROBLEM), key, lambda: mutants_of(PROBLEM), sheet_of(key, one), rules)
              for one in (whole, spoilt)]  # fmt: skip
    assert sheets[0].total == sheets[0].worth
    for sheet in sheets:
        assert math.isfinite(sheet.exactly) and 0 <= sheet.total <= sheet.worth


@pytest.mark.parametrize(
    ("problem", "said", "why"),
    [
        ("3-9", "pc2: {sense: 1}", "'pc2' has no sense"),
        ("two-solutions", "AD: {sense: 1000}", "'AD.*' has no sense"),
        ("3-9", "ω_2: {sense: 1}, omega_2: {sense: 2}", "'omega_2' is omega_2, whose points are said twice"),
        ("3-9", "v_E: {method: 1.0e+308}", "must be not above 10000"),
    ],
)
def test_points_that_nobody_could_have_are_refused(problem: str, said: str, why: str) -> None:
    with pytest.raises(ProblemFileError, match=why):
        pointed(f"points: {{{problem}: {{{said}}}}}", problem)


@pytest.mark.parametrize("name", ["ω_2", "ω2", "w2", "omega2"])
def test_a_quantity_is_named_as_it_is_written_elsewhere(name: str) -> None:
    assert pointed(f"points: {{3-9: {{{name}: {{accuracy: 4}}}}}}")["omega_2"].points.total == 4
