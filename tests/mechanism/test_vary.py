"""problem.vary(...) is the file with the changed text: the same problem, the same solution to the bit."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vecpoly
from tests.laws import few, often
from vecpoly import Problem, load, loads, solve, to_json
from vecpoly.errors import ArgumentError, ProblemFileError, UnknownNameError, VecpolyError
from vecpoly.foundation.data import data_dir
from vecpoly.mechanism.dimensions.placements import ByOffsets
from vecpoly.problem.library import library

NUMBER = re.compile(r"([-−]?\d[\d.]*) *(\D.*)?")


@dataclass(frozen=True, slots=True)
class Case:
    """A name, and where its value stands in the text of a file: between the two groups of the pattern."""

    problem: str
    name: str
    pattern: str


CASES = (
    Case("3-9", "AB", r"(\bAB: )[^,}]+()"),
    Case("3-9", "phi", r"(\bphi: )[^,}]+()"),
    Case("3-9", "omega", r"(\bomega: )[^,}]+()"),
    Case("3-9", "x_C", r"(\bC: \[)[^,]+(,)"),
    Case("3-9", "left_E", r"(\bleft: )[^,}]+()"),
    Case("3-9", "mu_v", r"(\bmu_v: )[^,}]+()"),
    Case("A-27", "BC", r"(\bBC: )[^,}]+()"),
    Case("A-27", "at_F", r"(\bat: )[^,}]+()"),
    Case("A-27", "y_D", r"(\bD: \[[^,]+, )[^\]]+(\])"),
    Case("4-3a", "F", r"(\bF: \{.*?size: )[^,}]+()"),
    Case("4-3a", "direction_F", r"(\bF: \{.*?direction: )[^,}]+()"),
    Case("4-3a", "rho_A", r"(\bA: \{rho: )[^,}]+()"),
    Case("4-3a", "y_3", r"(3 slides on y = )[^,\]]+()"),
    Case("elliptic-trammel", "s", r"(\bs: )[^,}]+()"),
    Case("elliptic-trammel", "v", r"(\bv: )[^,}]+()"),
    Case("lift-gate", "length", r"(\blength: )[^,}]+()"),
    Case("boom-thrust", "m_1", r"(\bmass: )[^,}]+()"),
    Case("cam-roller", "phi", r"(\bphi: )[^,}]+()"),
    Case("geared-five-bar", "angle_E", r"(\bangle: )[^,}]+()"),
    Case("5-1", "f", r"(\bf: )[^,}\s]+()"),
    Case("5-1", "Q", r"(\bQ: )[^,}\n]+()"),
)


@cache
def text(problem: str) -> str:
    return load(problem).path.read_text("utf-8")  # type: ignore[union-attr]


def bare(problem: Problem) -> Problem:
    """Without its text, where it was read, and the lines of which its warnings tell."""
    return replace(problem, path=None, text="", read=(), warnings=(), tables=())


def solved(problem: Problem) -> str:
    """All that a solution holds, to the last bit; or why there is none."""
    try:
        solution = solve(problem, by="exact", repeats=2, precise=False)
    except VecpolyError as error:
        return str(error)
    return to_json((solution.construction, tuple(solution.answers.values())))


def other(written: str, by: float) -> str:
    """The value with another number before its unit."""
    m = NUMBER.fullmatch(written)
    assert m is not None, written
    return f"{float(m[1].replace('−', '-')) * by:.12g} {m[2] or ''}".strip()


@settings(max_examples=often(5))
@given(st.sampled_from(CASES), st.floats(0.98, 1.02))
def test_a_varied_problem_solves_as_its_file_with_the_changed_text(case: Case, by: float) -> None:
    problem = load(case.problem)
    new = other(problem.parameters[case.name], by)
    changed, count = re.subn(case.pattern, lambda m: f"{m[1]}{new}{m[2]}", text(case.problem), count=1)
    assert count == 1
    varied, loaded = problem.vary(**{case.name: new}), loads(changed)
    assert bare(varied) == bare(loaded)
    assert solved(varied) == solved(loaded)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.problem}-{case.name}")
def test_every_kind_of_parameter_changes_the_problem(case: Case) -> None:
    problem = load(case.problem)
    varied = problem.vary(**{case.name: other(problem.parameters[case.name], 1.01)})
    assert bare(varied) != bare(problem)
    assert bare(loads(varied.text)) == bare(varied)
    assert bare(varied.vary(**{case.name: problem.parameters[case.name]})) == bare(problem)


def settable(problem: Problem) -> dict[str, str]:
    """Names with a number, points left out."""
    return {name: said for name, said in problem.parameters.items() if NUMBER.fullmatch(said) and "," not in said}


@cache
def everything() -> tuple[Problem, ...]:
    return tuple(problem for entry in library() if settable(problem := load(entry.path)))


def test_its_own_value_changes_nothing_anywhere_in_the_library() -> None:
    for problem in few(everything(), 8):
        own = settable(problem)
        some = {name: said for name, said in own.items() if not name.endswith(("_1", "_A"))} or own
        for name, said in list(some.items())[:4]:
            varied = problem.vary(**{name: said})
            assert varied == problem and varied.written == problem.written, (problem.id, name)


@settings(max_examples=often(20))
@given(st.data())
def test_two_changes_commute_and_may_be_made_at_once(data: st.DataObject) -> None:
    problem = data.draw(st.sampled_from(everything()))
    own = settable(problem)
    assume(len(own) > 1)
    names = data.draw(st.lists(st.sampled_from(sorted(own)), min_size=2, max_size=2, unique=True))
    one, two = ({name: other(own[name], data.draw(st.floats(0.99, 1.01)))} for name in names)
    try:
        both = problem.vary(**one, **two)
        there, back = problem.vary(**one).vary(**two), problem.vary(**two).vary(**one)
    except VecpolyError:
        assume(False)
    assert bare(there) == bare(back) == bare(both)


def test_numbers_are_si_and_letters_may_be_turned_round() -> None:
    problem = load("3-9")
    assert (
        problem.vary(BA=0.12).mechanism
        == problem.vary(AB="120 mm").mechanism
        == problem.vary(**{"links.1.AB": "12 cm"}).mechanism
    )
    assert problem.vary(omega=-3.0).mechanism == problem.vary(omega="3 rad/s cw").mechanism
    assert (
        problem.vary(C=(-0.12, 0)).mechanism
        == problem.vary(C=-0.12 + 0j).mechanism
        == problem.vary(x_C="-120 mm").mechanism
    )


def test_a_name_that_is_not_there_is_refused_with_those_that_are() -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'omega'"):
        load("3-9").vary(omgea="3 rad/s")
    with pytest.raises(UnknownNameError, match="nothing that is given is called 'XY'"):
        load("3-9").vary(XY="3 mm")
    with pytest.raises(UnknownNameError, match="vary x_D and y_D"):
        load("A-27").vary(AD="200 mm")


def test_a_name_that_several_share_means_all_of_them_where_they_say_the_same() -> None:
    problem = load("scissor-lift")
    varied = problem.vary(at_E="810 mm")
    there = [place for link in varied.mechanism.links for place in link.placements if place.point == "E"]
    assert len(there) == 2 and all(isinstance(place, ByOffsets) and place.along == 0.81 for place in there)
    assert problem.parameters["at_E"] == "800 mm"


def test_a_name_that_means_several_that_differ_is_refused_with_their_full_names() -> None:
    rubbing = load("4-3a").data | {"friction": {"A": {"f": "0.1", "r": "20 mm"}, "B": {"f": "0.12", "r": "20 mm"}}}
    problem = vecpoly.problem(rubbing)
    with pytest.raises(UnknownNameError, match=r"friction\.A\.f = 0\.1, friction\.B\.f = 0\.12"):
        problem.vary(f=0.11)
    assert problem.vary(**{"friction.B.f": 0.1}).vary(f=0.11).loads != problem.loads


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"AB": "-3 mm"}, r"vary\(AB\).*links\.1\.AB.*greater than zero"),
        ({"AB": "3 kg"}, r"vary\(AB\).*not a length"),
        ({"phi": "30"}, r"vary\(phi\).*no unit"),
        ({"omega": "-3 rad/s cw"}, r"vary\(omega\).*both a minus sign"),
    ],
)
def test_what_no_file_may_hold_is_refused_by_the_name_that_was_varied(changes: dict[str, str], said: str) -> None:
    with pytest.raises(ProblemFileError, match=said):
        load("3-9").vary(**changes)


@pytest.mark.parametrize(
    "changes",
    [
        {"AB": None},
        {"AB": True},
        {"C": 3},
        {"C": (1, 2, 3)},
        {"C": "0 mm"},
        {"x_C": "1 mm", "C": ("1 mm", "2 mm")},
        {"phi": "1 deg", "phi_1": "2 deg"},
    ],
)
def test_values_of_no_kind_and_one_quantity_twice_are_refused(changes: dict[str, object]) -> None:
    with pytest.raises(ArgumentError):
        load("3-9").vary(**changes)


def test_what_was_replaced_by_hand_stays_and_what_its_values_no_longer_say_is_refused() -> None:
    problem = load("3-9")
    assert replace(problem, id="mine").vary(AB="31 mm").id == "mine"
    with pytest.raises(ArgumentError, match="vary first"):
        replace(problem, subject=load("3-8").subject).vary(AB="31 mm")


def test_a_varied_problem_keeps_its_tables_and_its_place() -> None:
    problem = load("A-16")
    varied = problem.vary(phi="61 deg")
    assert varied.tables == problem.tables and varied.path == problem.path and "tables" in varied.data


def kinds() -> Iterator[str]:
    yield from (path.stem for path in data_dir("problems").rglob("*.yaml"))


def test_every_case_is_in_the_library() -> None:
    assert {case.problem for case in CASES} <= set(kinds())
