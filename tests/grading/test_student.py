"""Somebody's answers, one problem, at once: v_D=0.49, and a reason."""

from __future__ import annotations

import re

import pytest

from tests.laws import few
from vecpoly import check_answers, load, loads
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.errors import ArgumentError, AssemblyError, UnknownNameError, VecpolyError
from vecpoly.mistakes import slips


def test_answers_are_right_close_or_wrong_with_a_reason() -> None:
    checked = load("3-12").check_answers({"v_D": "0.49", "ω5": "4.72", "α3": "12 rad/s² 顺"})
    assert {one.key: one.is_right for one in checked.answers} == {"v_D": True, "omega_5": False, "alpha_3": False}
    assert [said.id for said in checked.answers[-1].messages] == ["translates"]
    assert not checked.right and "translates" in str(checked)


def test_answers_may_stand_in_one_text_each() -> None:
    texts, mapped = (
        check_answers(load("3-9"), ["v_E=0.173", "ω2＝1.99 顺"]),
        check_answers(load("3-9"), {"v_E": 0.173, "omega_2": "1.99 cw"}),
    )
    assert [one.outcome for one in texts.answers] == [one.outcome for one in mapped.answers]
    assert texts.right


def test_what_was_not_asked_for_is_checked_too() -> None:
    problem = load("3-12")
    assert "alpha_4" not in {ask.rel.key for ask in problem.asks}
    assert check_answers(problem, ["α4=3.66 逆"]).right


@pytest.mark.parametrize("behind", few(["→", "向右", "@ 0°", "to the right", "↗"], 3))
def test_an_arrow_that_points_the_other_way_is_not_right(behind: str) -> None:
    """3-12's C goes to the left."""
    assert check_answers(load("3-12"), ["v_C=0.506 m/s ←"]).right
    assert not check_answers(load("3-12"), [f"v_C=0.506 m/s {behind}"]).right


@pytest.mark.parametrize("text", ["v_C=0.506 m/s ccw", "ω2=1.256 rad/s →"])
def test_no_vector_turns_and_no_angular_velocity_points(text: str) -> None:
    (found,) = check_answers(load("3-12"), [text]).answers
    assert not found.is_right and found.outcome.for_a_person


@pytest.mark.parametrize(
    ("text", "why"),
    [("v_Q=3", "point Q"), ("q=2", "nothing asked"), ("v_D", "write v_D=0.49"), ("=3", "write v_D=0.49")],
)
def test_what_is_no_answer_is_refused(text: str, why: str) -> None:
    with pytest.raises(VecpolyError, match=why):
        check_answers(load("3-12"), [text])


def test_an_answer_given_twice_is_refused() -> None:
    with pytest.raises(ArgumentError, match="twice"):
        check_answers(load("3-12"), ["v_D=1", "v_D=2"])
    with pytest.raises(UnknownNameError):
        check_answers(load("5-2"), ["zeta=1"])


def test_forces_and_devices_are_checked_as_well() -> None:
    assert check_answers(load("4-3a"), ["R12=1004 N", "M=64.3 N·m 顺", "η=79.5%"]).right
    assert check_answers(load("5-2"), ["R_13=980", "φ=7.41°"]).right


def test_what_no_drawing_can_tell_from_another_value_is_said_to_be_so() -> None:
    """The coupler of 8-15 scatters by a third from drawing to drawing; its frame does not."""
    doubtful, sound = check_answers(load("8-15"), ["BC=214 mm", "AD=283 mm"]).answers
    assert doubtful.is_right and re.search(r"scatter by ±[78]\d mm \(3\d %\)", doubtful.messages[-1].words.en)
    assert sound.is_right and "scatter" not in "".join(said.words.en for said in sound.messages)


@pytest.mark.parametrize(("text", "right"), [("168.4°", True), ("348.4°", True), ("-11.6°", True), ("150°", False)])
def test_of_a_centre_at_infinity_the_direction_is_checked_whichever_way_round_it_is_told(
    text: str, right: bool
) -> None:
    assert check_answers(load("3-1d"), {"P_23": text}).right is right


def test_the_direction_of_a_line_near_180_degrees_scatters_no_more_than_any_other() -> None:
    guide = "id: x\ntitle: x\nframe: {A: [0 mm, 0 mm]}\nlinks: {1: {AB: 40 mm}, 2: {BC: 120 mm}, 3: {block: C}}\n"
    guide += "joints: [3 slides on line through A at 90.0 deg]\nbranch: [C above B]\nmethod: centres\n"
    guide += "input: {link: 1, phi: 20 deg, omega: 10 rad/s ccw}\nfind: [P_34]\n"
    answers = [check_answers(loads(guide), {"P_34": text}) for text in ("0.2°", "179.8°", "10°")]
    assert [one.right for one in answers] == [True, True, False]


@pytest.mark.parametrize("said", ["自锁", "能自锁", "self-locking", "是", "1"])
def test_a_yes_is_correct_without_an_error_beside_it(said: str) -> None:
    (one,) = check_answers(load("5-5"), {"self_locking": said}).answers
    assert [told.id for told in one.messages] == ["right"] and one.value == 1 and one.off == 0


def test_one_quantity_under_two_spellings_is_given_twice() -> None:
    with pytest.raises(ArgumentError, match="given twice"):
        check_answers(load("3-9"), ["ω3=1.99 cw", "ω_3=5 cw"])


@pytest.mark.parametrize("other", ["w5", "omega_5", "ω5", "ϖ₅"])
def test_one_quantity_by_two_names_is_given_twice(other: str) -> None:
    """The last one was taken in silence."""
    with pytest.raises(ArgumentError, match="given twice"):
        check_answers(load("3-12"), ["ω_5=4.72", f"{other}=4.7"])


def test_a_length_under_its_printed_symbol_answers_what_is_asked() -> None:
    """A step of 8-16 has the symbol of its result: l_AB, of which AB is asked."""
    right, wrong = (check_answers(load("8-16"), {"l_AB": text}).answers for text in ("21.5 mm", "25 mm"))
    assert [(one.key, one.is_right) for one in (*right, *wrong)] == [("AB", True), ("AB", False)]


def test_where_no_name_is_near_those_that_are_asked_are_told_first() -> None:
    with pytest.raises(UnknownNameError, match=r"there are r0_apex, e_apex, s0_apex, r0, e, s0"):
        check_answers(load("cam-least-circle"), ["qqqq=1"])


def test_a_slip_that_leaves_no_circle_to_draw_breaks_no_check() -> None:
    """The perpendicular at C₂ ruled along C₁C₂ meets the ray in C₁."""
    slip = Slip(Mistake.TURNED, "C2P")
    assert slip in slips(load("best-gamma"))
    with pytest.raises(AssemblyError, match="no circle"):
        load("best-gamma").solve(by="exact", slip=slip)
    checked = check_answers(load("best-gamma"), ["AB=20", "BC=60", "AD=70", "gamma_min=30"])
    assert not checked.right and not any(one.for_a_person for one in checked.answers)
