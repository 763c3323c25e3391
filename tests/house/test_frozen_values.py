"""Problems, mechanisms, constructions, solutions are values: frozen, the same after pickle, deepcopy, JSON."""

from __future__ import annotations

import json
import pickle
from copy import deepcopy
from dataclasses import FrozenInstanceError, replace
from functools import cache
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import few, often
from vecpoly import Construction, Mechanism, Problem, Solution, from_json, load, solve, to_json
from vecpoly.errors import ArgumentError, VecpolyError
from vecpoly.problem.library import library

SOLVED = ("3-9", "4-3a", "C-inertia", "5-1", "2-9", "geared-five-bar", "tipper", "3-2", "D-1", "3-4a")


@cache
def problems() -> tuple[Problem, ...]:
    return tuple(load(entry.path) for entry in few(library(), 4))


@cache
def solved(problem: str) -> Solution:
    return solve(load(problem), repeats=5, precise=False)


def again(thing: Any) -> tuple[Any, ...]:
    """By pickle, by copy, by JSON."""
    return pickle.loads(pickle.dumps(thing)), deepcopy(thing), from_json(to_json(thing), type(thing))


def test_every_problem_of_the_library_survives_and_keeps_its_hash() -> None:
    for problem in problems():
        for other in again(problem):
            assert other == problem and hash(other) == hash(problem), problem.id
            assert other.written == problem.written and other.parameters == problem.parameters, problem.id


def test_every_mechanism_of_the_library_survives_and_keeps_its_hash() -> None:
    for mechanism in (problem.mechanism for problem in problems() if isinstance(problem.subject, Mechanism)):
        assert all(other == mechanism and hash(other) == hash(mechanism) for other in again(mechanism))


@pytest.mark.parametrize("name", few(SOLVED, 3))
def test_a_solution_and_its_construction_survive(name: str) -> None:
    solution = solved(name)
    for other in again(solution):
        assert to_json(other) == to_json(solution) and str(other) == str(solution)
    assert all(other == solution.construction for other in again(solution.construction))


def test_records_are_strict_json_without_nan() -> None:
    json.loads(to_json(solved("2-9")), parse_constant=lambda name: pytest.fail(name))


@pytest.mark.parametrize(
    ("thing", "field"), [("problem", "id"), ("mechanism", "frame"), ("construction", "steps"), ("solution", "answers")]
)
def test_nobody_changes_them(thing: str, field: str) -> None:
    solution = solved("3-9")
    one = {
        "problem": solution.problem,
        "mechanism": solution.problem.mechanism,
        "construction": solution.construction,
        "solution": solution,
    }[thing]
    with pytest.raises(FrozenInstanceError):
        setattr(one, field, None)


def test_a_varied_problem_from_json_varies_on() -> None:
    varied = load("3-9").vary(AB="31 mm")
    on, back = from_json(to_json(varied), Problem).vary(AB="30 mm", phi="40 deg"), load("3-9").vary(phi="40 deg")
    assert replace(on, text="") == replace(back, text="") and on.text == back.text


@settings(max_examples=often(4, 1000))
@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.text(),
        lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    )
)
def test_other_json_is_refused_in_words(data: object) -> None:
    with pytest.raises(VecpolyError, match="JSON holds"):
        from_json(json.dumps(data), Construction)


def test_what_is_none_of_ours_is_refused() -> None:
    with pytest.raises(ArgumentError, match="does not go to JSON"):
        to_json(object())
