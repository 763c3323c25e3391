"""The sheet remembers acts: marks follow from them, what rests on what is a query on them,
and each can be done otherwise."""

from __future__ import annotations

import pickle
import re
from copy import deepcopy
from dataclasses import fields
from functools import cache
from unicodedata import east_asian_width

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import few, often
from vecpoly import Mistake, Slip, Solution, load, slips, solve
from vecpoly.board.acts import Act, Answer, Compute, Locate, Measure
from vecpoly.board.chain import following, numbers
from vecpoly.board.construction import Construction
from vecpoly.board.hand import hand
from vecpoly.board.otherwise.amended import AS_DRAWN, Amended
from vecpoly.board.paper.ink import marks
from vecpoly.board.place import Pane
from vecpoly.board.said.told import told as told_as_list
from vecpoly.errors import UnknownNameError, VecpolyError
from vecpoly.foundation.frozen import FrozenMap
from vecpoly.record import from_json, to_json
from vecpoly.solution import constructed

SEVERAL = (
    "3-2",
    "3-3",
    "3-9",
    "3-12",
    "4-3a",
    "4-4",
    "4-5",
    "C-inertia",
    "slider-crank-dynamic",
    "5-2",
    "geared-five-bar",
    "tipper",
    "three-legged-plate",
)
KINDS = (Measure, Locate)


@cache
def drawn(problem: str, amended: Amended = AS_DRAWN) -> Construction:
    """By an exact hand."""
    return constructed(load(problem), hand("exact"), amended).construction


@cache
def solved(problem: str) -> Solution:
    return solve(load(problem), by="exact", repeats=0, precise=False)


def named(act: Act) -> str:
    return f"{act.figure}:{act.key}" if act.figure else act.key


def amended(act: Act, by: float) -> Amended:
    """This reading, or this point, larger by so many mm."""
    if isinstance(act, Measure):
        return Amended(readings=FrozenMap({named(act): act.mm + by}))
    assert isinstance(act, Locate)
    return Amended(points=FrozenMap({named(act): act.at + by}))


def told(act: Act) -> tuple[object, ...]:
    return tuple(getattr(act, field.name) for field in fields(act) if field.name != "head")


@pytest.mark.parametrize("problem", few(SEVERAL, 4))
def test_marks_follow_from_the_acts_alone(problem: str) -> None:
    construction = drawn(problem)
    left = marks(construction.acts)
    for figure in construction.figures:
        place = next(
            p
            for p in left
            if (p.name if isinstance(p, Pane) else "") == figure.name
            and (p.view if isinstance(p, Pane) else p) is figure.view
        )
        assert left[place] == figure.marks
        assert all(mark.act >= 0 and construction.acts[mark.act].head.place == place for mark in figure.marks)


@pytest.mark.parametrize("problem", few(SEVERAL, 4))
def test_an_act_needs_only_acts_that_were_done_before_it(problem: str) -> None:
    for number, act in enumerate(drawn(problem).acts):
        assert act.number == number
        assert all(needed < number for needed in act.inputs)


@pytest.mark.parametrize("problem", SEVERAL)
def test_every_answer_is_an_act_that_rests_on_others_unless_it_is_given(problem: str) -> None:
    construction = drawn(problem)
    answers = {act.key: act for act in construction.acts if isinstance(act, Answer)}
    assert set(construction.readings) <= set(answers)


@settings(max_examples=often(12))
@given(data=st.data())
def test_going_on_with_ones_own_reading_or_point_changes_nothing_to_the_bit(data: st.DataObject) -> None:
    problem = data.draw(st.sampled_from(SEVERAL))
    act = data.draw(st.sampled_from([act for act in drawn(problem).acts if isinstance(act, KINDS)]))
    assert drawn(problem, amended(act, 0.0)).acts == drawn(problem).acts


@settings(max_examples=often(12))
@given(data=st.data())
def test_another_reading_or_point_changes_nothing_but_what_rests_on_it(data: st.DataObject) -> None:
    problem = data.draw(st.sampled_from(SEVERAL))
    before = drawn(problem).acts
    act = data.draw(st.sampled_from([act for act in before if isinstance(act, KINDS)]))
    try:
        after = drawn(problem, amended(act, 0.03)).acts
    except VecpolyError:
        return  # with this point there is no mechanism, or no equilibrium
    if [one.head for one in before] != [one.head for one in after]:
        return  # another case of the textbook: a vector is too short to be drawn
    meant = [one.number for one in before if type(one) is type(act) and named(one) == named(act)]
    rests = following(before, meant)
    changed = {
        one.number
        for one, other in zip(before, after, strict=True)
        if isinstance(one, (Measure, Locate, Compute, Answer)) and repr(told(one)) != repr(told(other))
    }
    assert changed <= rests, [before[n] for n in sorted(changed - rests)]


def test_a_reading_of_ones_own_is_gone_on_with() -> None:
    own = solve(load("3-9"), readings={"b c_2": "38 mm"}, repeats=0)
    measured = next(act for act in own.construction.acts if act.key == "bc2")
    assert isinstance(measured, Measure)
    assert measured.mm == 38.0
    assert own.answers["v_C2B"].reading.mm == 38.0
    assert own.answers["v_E"].drawn == solve(load("3-9"), repeats=0).answers["v_E"].drawn


def test_a_point_of_ones_own_moves_all_that_rests_on_it() -> None:
    was, own = solved("3-12"), solve(load("3-12"), by="exact", repeats=0, precise=False, points={"c": (20.0, -35.0)})
    assert next(act.at for act in own.construction.acts if isinstance(act, Locate) and act.key == "c") == 20 - 35j
    changed = {key for key in was.answers if was.answers[key].drawn != own.answers[key].drawn}
    assert changed
    assert changed <= set(was.construction.dependents("velocity:c"))


def test_what_an_answer_rests_on_is_told_by_name() -> None:
    rests = solved("3-9").construction.depends("a_D")
    assert {"A", "B", "C", "b", "omega_2", "ak_C2C3", "c2'"} <= set(rests)
    assert "e" not in rests


def test_a_letter_that_is_not_on_the_sheet_is_refused_with_those_that_are() -> None:
    with pytest.raises(UnknownNameError, match="bc2"):
        solve(load("3-9"), readings={"bc": 38.0}, repeats=0)
    with pytest.raises(UnknownNameError, match="force"):
        solve(load("4-3a"), readings={"bc": 38.0}, repeats=0)


@pytest.mark.parametrize("problem", few(SEVERAL, 4))
def test_a_construction_survives_json_pickle_and_copy(problem: str) -> None:
    construction = drawn(problem)
    assert from_json(to_json(construction), Construction) == construction
    assert pickle.loads(pickle.dumps(construction)) == construction
    assert deepcopy(construction) == construction


@pytest.mark.parametrize("problem", few(["3-9", "4-3a", "tipper"], 3))
def test_every_slip_that_is_offered_leads_to_another_answer_or_to_no_mechanism(problem: str) -> None:
    right, quiet = solved(problem), set[str]()
    for slip in slips(load(problem)):
        try:
            wrong = solve(load(problem), by="exact", repeats=0, precise=False, slip=slip)
        except VecpolyError:
            continue
        if wrong.construction.acts == right.construction.acts:
            quiet.add(str(slip))
    assert not quiet


def test_a_forgotten_two_halves_the_coriolis_term_and_what_follows_from_it() -> None:
    wrong = solve(load("3-9"), by="exact", repeats=0, precise=False, slip=Slip(Mistake.HALVED, "ak_C2C3"))
    right = solved("3-9")
    assert wrong.answers["ak_C2C3"].drawn == pytest.approx(right.answers["ak_C2C3"].drawn / 2, rel=1e-12)
    assert wrong.answers["v_E"].drawn == right.answers["v_E"].drawn
    assert wrong.answers["alpha_2"].drawn != right.answers["alpha_2"].drawn


def test_a_slip_with_what_is_not_there_is_refused() -> None:
    with pytest.raises(UnknownNameError, match="v_Q"):
        solve(load("3-9"), slip=Slip(Mistake.REVERSED, "v_Q"), repeats=0)


def test_a_construction_reads_as_a_list_of_steps_and_acts() -> None:
    text = str(solved("3-9").construction)
    assert re.search(r"#\d+  measure +bc2 = ", text) and re.search(r"point +c2 \(", text)
    assert len(str(solved("3-9")).splitlines()) == len(solved("3-9").answers) + 1


def test_the_list_of_acts_keeps_its_columns_in_chinese() -> None:
    construction = solved("3-9").construction
    lines = [line for line in told_as_list(construction.steps, construction.acts, "zh").splitlines() if "← " in line]
    wide = {sum(2 if east_asian_width(letter) in "WF" else 1 for letter in line.partition("←")[0]) for line in lines}
    assert len(lines) > 40 and len(wide) == 1


def test_the_list_of_acts_writes_units_and_symbols_as_people_do() -> None:
    text = str(solved("3-9").construction)
    assert "m/s²" in text and "b′c_2′" in text
    assert not re.search(r"\^2|[$^{}]′|  ω|\$", text)


@pytest.mark.parametrize("problem", SEVERAL)
def test_a_key_on_two_figures_is_told_by_its_figure(problem: str) -> None:
    acts = drawn(problem).acts
    for act in acts:
        if isinstance(act, KINDS):
            assert act.number in numbers(acts, named(act))


def test_what_the_readme_shows_of_acts_works() -> None:
    problem = load("3-9")
    moved = solve(problem, points={"c2": (30, 20)}, repeats=0)
    assert next(act.at for act in moved.construction.acts if isinstance(act, Locate) and act.key == "c2") == 30 + 20j
    assert Slip(Mistake.HALVED, "ak_C2C3") in slips(problem)
    assert solved("3-9").construction.depends("a_D")[:3] == ("A", "C", "B")


def test_ones_own_length_stands_on_the_nominal_sheet_and_the_others_scatter_about_it() -> None:
    answer = load("3-9").solve(readings={"bc2": "30 mm"}).answers["omega_2"]
    assert answer.drawn == pytest.approx(-1.463, abs=2e-3)
    assert answer.expected_error is not None and 1e-4 < answer.expected_error < 0.1
