"""One quantity, one sign: what is told with a sense is printed as a size; where a sum needs signs the positive sense is
told."""

from __future__ import annotations

import re

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.algebra.formula import plain
from vecpoly.problem.load import load
from vecpoly.report.answers.line import short_line
from vecpoly.report.answers.tables import way

LESS = re.compile(r"= −[\d.×^{}−]+ (N·m|rad/s)$")  # a line that ends so


@each(IDS)
def test_what_turns_is_worked_out_as_the_size_that_stands_beside_its_sense(name: str) -> None:
    for answer in drawn(name).solution.answers.values():
        if answer.sense is not None and answer.reading.formula is not None:
            assert not LESS.search(plain(answer.reading.formula)), plain(answer.reading.formula)


@each(IDS)
def test_a_step_whose_line_ends_below_zero_tells_which_sense_is_positive(name: str) -> None:
    for step in drawn(name).construction.steps:
        for line in filter(LESS.search, map(plain, step.formulas)):
            turning = "逆时针为正" in step.words.zh and "positive counter-clockwise" in step.words.en
            assert turning or ("为负" in step.words.zh and "is negative" in step.words.en), line


@each(("winch-gears", "slider-crank-dynamic", "return-spring"))
def test_a_moment_has_one_sense_by_whichever_way_it_is_found(name: str) -> None:
    solution = drawn(name).solution
    steps = [step.words.en for step in solution.construction.steps if "virtual power" in step.words.en]
    turn = {"cw": "clockwise:", "ccw": "counter-clockwise:"}[solution.answers["M_1_power"].sense or ""]
    assert steps and all(words.endswith(f"is {turn}") for words in steps)


@each(IDS)
def test_directions_of_vectors_are_told_from_0_to_360_degrees(name: str) -> None:
    solution = drawn(name).solution
    for answer in solution.answers.values():
        if answer.drawn_vector is not None and not answer.is_place:
            told = f"{plain(short_line(answer, solution, 'en'))} {way(answer, solution.problem, 'en')}"
            assert not re.search(r"−[\d.]+°", told), told


@each((*IDS, "3-7b", "3-11", "hypocycloid-drive"))
def test_an_angle_between_two_lines_has_words_for_its_side_and_no_minus(name: str) -> None:
    steps = [step.words for step in drawn(name).construction.steps]
    for zh, en in [(one.zh, one.en) for one in steps] + [
        (one.of("zh"), one.of("en")) for one in drawn(name).problem.given.data
    ]:
        assert not re.search(r"成 ?[−-]\d", zh) and not re.search(r"\bat [−-][\d.]+° to", en), (zh, en)
        if below := re.search(r"= −[\d.]+°(.{5})", zh if "作与 $x$ 轴成" in zh else ""):
            assert below[1] == "（顺时针）" and "° to the $x$ axis (clockwise)" in en, (zh, en)


def test_a_load_told_clockwise_has_the_direction_that_stands_in_the_table() -> None:
    given = " ".join(one.of("en") for one in load("winch-gears").given.loads)
    assert "directed vertically downwards" in given and "−90" not in given, given


def test_an_equivalent_moment_is_computed_as_a_size_and_is_said_to_be_one() -> None:
    """The size is |ΣP|/ω_1 by the rule and by its line, and the sense is that of the sum."""
    (told,) = [step for step in drawn("7-1").construction.steps if "功率等效：$M_{e}$" in step.words.zh]
    assert "$M_{e}$ 的大小等于" in told.words.zh and "为顺时针方向" in told.words.zh
    assert "its magnitude is $|ΣP|/ω_1$" in told.words.en
    assert re.fullmatch(r"M_e = \(\|P_F5\|\)/\(ω_1\) = \(500\)/\(10\) = 50(\.0)? N·m", plain(told.formulas[-1]))


def test_an_equivalent_force_is_a_size_that_acts_along_or_against_the_motion_as_a_moment_has_its_sense() -> None:
    (told,) = [step for step in drawn("7-1").construction.steps if "功率等效：$F_{e5}$" in step.words.zh]
    assert "$F_{e5}$ acts against $v_F$" in told.words.en and "$F_{e5}$ 与 $v_F$ 反向" in told.words.zh
    assert plain(told.formulas[-1]).endswith("= 1000 N")
    solution = drawn("7-1").solution
    line = plain(short_line(solution.answers["F_e5"], solution, "en"))
    assert line == "F_e5 = 1000 N (against the motion)" and solution.answers["F_e5"].drawn < 0
