"""A course report speaks of what its problem has: no force that is nothing has a way, no symbol is listed in vain."""

from __future__ import annotations

import re

import pytest

from tests.studies import course_words, studied
from vecpoly.cycle.facts.duties import duties
from vecpoly.findings.advice import advice
from vecpoly.findings.conditioning import conditioning
from vecpoly.findings.limits import limit
from vecpoly.findings.motion import motion
from vecpoly.findings.study.study import study
from vecpoly.problem.load import load
from vecpoly.report.answers.verdict import is_ill
from vecpoly.report.course.analysis import forces
from vecpoly.report.course.analysis.stated import stated
from vecpoly.report.course.checks.influences import influences, targets
from vecpoly.report.course.checks.tolerances import judged
from vecpoly.report.course.results import drawings, loaded
from vecpoly.report.course.symbols import rows_of
from vecpoly.solution import solve
from vecpoly.words import Words

WAYS = ("to the right", "to the left", "upwards", "downwards", "from $x$", "clockwise")
COUPLE = "guided-couple"  # a Scotch yoke whose loads do no work: M_1, R_12 and R_32 are nothing all along
SPEAKING = "$h$ $S_{2}$ $m_{2}$"  # letters that stand for points where no force acts


def test_a_zero_has_no_direction_and_no_unit_of_its_own() -> None:
    [told] = stated(studied(COUPLE))
    zero = [part for part in told.en.split("; ") if re.search(r"= 0\b(?!\.)", part)]
    assert zero and not any(way in part for part in zero for way in WAYS)
    assert "$R_{43}$ = 200.0 N, downwards" in told.en


def test_loads_that_do_no_work_have_no_parts_and_what_balances_them_no_greatest_value() -> None:
    it = studied(COUPLE)
    assert [(one.drives, one.resists) for one in duties(it.whole)] == [((), ())]
    [said] = forces.conclusion(it)
    assert said.en.endswith("so $M_{1}$ = 0 throughout.") and "最大" not in said.zh


def test_loads_that_work_keep_their_parts() -> None:
    assert any(one.drives and one.resists for one in duties(studied("4-3a").whole))


def test_a_force_that_never_changes_is_told_in_words_and_one_that_does_in_a_table() -> None:
    still, moved = studied(COUPLE), studied("4-3a")
    assert loaded.unchanged(still) == [*still.forces] and not loaded.unchanged(moved)
    [said] = loaded.constant(still, loaded.unchanged(still))
    assert "$R_{43}$ = 200 N, downwards" in said.en and "$M_{1}$ = 0" in said.en


def test_effects_are_told_as_greatest_and_least_only_where_they_differ() -> None:
    it = studied(COUPLE)
    keys, found = targets(it), influences(it)
    [told] = [w.en for w in judged(it, keys, found) if "effect" in w.en]
    most, least = re.split(r", the least that of ", told.split("greatest effect is that of ")[1])
    assert not set(re.findall(r"[\d.]+ %", most)) & set(re.findall(r"[\d.]+ %", least))


def test_no_position_is_drawn_for_the_least_of_an_angle_that_never_changes() -> None:
    it = studied(COUPLE)
    assert all(t.is_constant for t in it.facts.transmissions)
    assert not [why for _, why in drawings._candidates(it) if "transmission" in why.en]


def test_a_limit_position_names_the_guide_to_which_the_crank_is_square() -> None:
    found = limit(studied(COUPLE), "s_34", 0.0)
    assert found is not None and found.words == Words(
        "$AB$ 垂直于构件 3 的导路", "$AB$ is at right angles to the slideway of link 3"
    )


@pytest.mark.parametrize(("name", "acts"), [("planetary-sun-drives", False), ("six-bar-dynamic", True)])
def test_symbols_of_forces_and_masses_are_listed_only_where_there_are_any(name: str, acts: bool) -> None:
    listed = {symbol for symbol, *_ in rows_of(studied(name), SPEAKING)}
    assert ({"$h$", "$S_i$", "$m_i$"} <= listed) is acts and (bool({"$h$", "$S_i$", "$m_i$"} & listed)) is acts


def test_a_radius_among_the_symbols_is_that_of_a_gear_not_of_a_roller() -> None:
    [words] = [words for symbol, words, _ in rows_of(studied("planetary-sun-drives"), "") if symbol.startswith("$r_")]
    assert words == Words("齿轮的节圆半径", "pitch radius of a gear")


@pytest.mark.parametrize(("name", "parts"), [("3-10", "$a^n$、$a^t$、$a^k$、$a^r$"), ("3-5", "$a^n$、$a^t$")])
def test_of_an_acceleration_the_parts_are_listed_that_stand_in_an_equation(name: str, parts: str) -> None:
    assert parts in [symbol for symbol, *_ in rows_of(studied(name), "")]


def test_a_linkage_with_change_points_is_not_said_to_move_without_them() -> None:
    it = studied("parallelogram-locomotive")
    groups = conditioning(it)
    told = "".join(w.en for w in motion(it, groups))
    assert "change points, at $φ_{1}$ = 0° and 180°" in told and "no dead point" not in told
    assert "there is no dead point" in "".join(w.en for w in motion(studied("4-3a"), conditioning(studied("4-3a"))))


def test_equal_lengths_that_make_the_change_points_are_not_to_be_changed_for_the_transmission_angle() -> None:
    it = studied("parallelogram-locomotive")
    [told] = [w.en for one in conditioning(it) for w in advice(it, one)]
    assert "are stretched" in told and "at a change point" in told and "would raise" not in told


def test_the_table_of_counterweights_follows_the_sentence_that_speaks_of_it() -> None:
    """The values of the static balance were said to be listed behind the crank's own counterweight."""
    text = course_words("C-inertia", "zh")[0]
    (told,) = re.findall(r"<p>([^<]*)</p><p>数值列于表 9-3", text)
    assert "静平衡" in told and "如下表" in told


@pytest.mark.parametrize("name", ["C-inertia", "3-9", "curv-5"])
def test_what_is_hardly_found_by_drawing_is_not_said_to_agree(name: str) -> None:
    """M_1 was read from an arm of 0.7 mm, with an expected error of 38 %, beside 'at most 0.74 %'."""
    solution = solve(load(name))
    it = study(solution)
    ill = [one.rel.symbol for one in it.solution.answers.values() if is_ill(one, it.solution)]
    told = "".join(words.zh for words in stated(it))
    assert ("由作图不易准确求得，不在此列" in told) == any(f"${one}$ = " in told for one in ill)
    assert name != "C-inertia" or "$M_{1}$ 由作图不易准确求得" in told.replace("M_1", "M_{1}")
