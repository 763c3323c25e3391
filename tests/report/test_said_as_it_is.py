"""What is said of a drawing is so: no datum is named that is not given, no word stands for something else."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import drafted, given, said
from tests.flat_positions import FLAT
from tests.framed_answers import rows_in
from vecpoly.check.printed.answers import check_problem
from vecpoly.printed.digits import HOPELESS
from vecpoly.report.answers.box import answer_box
from vecpoly.report.content import by_rank, statement
from vecpoly.report.picture import NOT_TO_SCALE
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.sketch import sketched
from vecpoly.report.titles import Kind, kind_of
from vecpoly.report.verdicts import verdicts
from vecpoly.report.verification.table import heads_told, verification_table
from vecpoly.solution import Solution
from vecpoly.words import Lang

LANGS: tuple[Lang, ...] = ("zh", "en")


def solved(name: str) -> Solution:
    """A problem of the library, drawn."""
    found = drafted(name)
    assert found is not None
    return found


def _told(name: str, lang: Lang = "zh") -> str:
    return "\n".join(words.of(lang) for words in said(name))


@pytest.mark.parametrize("lang", LANGS)
def test_a_cams_centre_of_curvature_is_not_laid_off_at_the_angle_of_the_cam(lang: Lang) -> None:
    """K of the heart cam lies at its own angle, ρ from the tip; a radius r_1 is no datum."""
    told = _told("cam-knife-load", lang)
    assert "l_{KB} = ρ" in told
    assert "r_1 + r_2" not in told and "作与 $x$ 轴成" not in told and "draw link 1" not in told


def test_a_flat_face_is_no_guide() -> None:
    """What slides along a flat face moves parallel to the face."""
    tables = [step.equation for step in solved("4-5").construction.steps if step.equation is not None]
    directions = {words.zh for table in tables for words in table.directions}
    assert "∥平底" in directions and "∥导路" not in directions


@pytest.mark.parametrize("lang", LANGS)
def test_the_type_of_a_four_bar_is_told_of_it_alone(lang: Lang) -> None:
    """A crank-rocker to which a dyad is added may stop before a full turn: both are told, and of what."""
    table = verification_table(solved("8-12"), lang)
    assert table is not None
    assert "$ABCD$" in " ".join(table.header) and "$ABCD$" in heads_told(table, lang)
    plain = verification_table(solved("8-4"), lang)
    assert plain is not None and "$ABCD$" not in " ".join(plain.header)


def test_a_reading_that_its_error_swallows_is_not_called_small() -> None:
    """13.4° is no small angle: it is read with an error of about half of it, and the other one is not."""
    box, answers = answer_box(solved("8-4"), "zh"), solved("8-4").answers
    marked = {row.keys: row.off for row in rows_in(box) if row.error.endswith("*")}
    assert [*marked] == [("gamma_min_1",)] and "过小" not in "".join(box.notes)
    least = answers["gamma_min_1"]
    assert (marked["gamma_min_1",] == "—") is (least.expected_error > HOPELESS * abs(least.drawn))


def test_a_question_on_structure_prints_no_kinematic_diagram() -> None:
    """The picture of a chain is not to scale, and is not asked for where it is printed."""
    for name in ("2-1", "2-2", "2-3", "2-4"):
        one = solved(name)
        shown = sketched(one.problem, one.construction, 120.0, 70.0)
        assert shown is not None and shown.title == NOT_TO_SCALE
        assert one.problem.statement is not None and "绘制机构运动简图" not in one.problem.statement.zh


def test_of_a_structure_only_what_the_rank_gives_is_compared_with_it() -> None:
    """The numbers of links, pairs and groups are counted, and no rank tells them; a train has no rank at all."""
    assert by_rank(solved("2-1"), "zh") == "自由度 $F$和虚约束 $p′$"
    assert by_rank(solved("2-1"), "en") == "degree of freedom $F$ and number of redundant constraints $p′$"
    assert not by_rank(solved("7-2a"), "zh")


def test_where_all_solutions_are_asked_there_is_room_for_several() -> None:
    """More columns than there are solutions; where they are asked by number each has its row."""
    one, other = solved("four-positions-b"), solved(FLAT)
    assert len(empty_table(one, "zh").header) - 1 > len(one.construction.candidates)
    assert "解 1" not in " ".join(empty_table(other, "zh").header)


def test_a_report_on_pressure_angles_is_called_so() -> None:
    """Angles of pressure and of transmission are no kinematics."""
    for name in ("8-2a", "8-2b", "8-2c", "8-2d"):
        assert kind_of(given(name)) is Kind.TRANSMISSION
    assert kind_of(given("3-9")) is Kind.KINEMATICS


def test_senses_of_turning_alone_are_no_directions() -> None:
    """Where directions count from is told under a box of answers that has one."""
    for name, has in (("7-2b", False), ("hoist", False), ("4-5", True)):
        assert answer_box(solved(name), "zh").directed is has


def test_a_count_that_agrees_is_the_same_as_the_books() -> None:
    """A number of links has no exact value to come near to."""
    one = solved("2-5")
    assert [text for kind, text in verdicts(one, check_problem(one.problem), "zh") if kind == "pass"] == [
        "各计数均与原书答案一致。"
    ]


def test_an_angle_is_told_as_it_is_given() -> None:
    """190° stays 190°, and a gear that stands about another one is a ring gear."""
    told = _told("two-trains-one-sun")
    assert "成 190°（自 $x$ 轴逆时针量）定出" in told and "−170°" not in told and "固定内齿轮上纯滚动" in told


def test_a_module_is_no_metre() -> None:
    """The limit of the thickness of a tip is a product of modules, and told in mm beside it; no number stands alone
    before an m."""
    told = _told("gear-shifted")
    assert "小于 $0.25·m$ = 2.5 mm" in told and not re.search(r"\d m\$", told)


@pytest.mark.parametrize("lang", LANGS)
def test_a_roller_that_is_welded_to_its_lever_keeps_its_own_number(lang: Lang) -> None:
    """Roller 3 of lever 2 has the radius r_3, where it is given and where the bar of the contact is told."""
    assert "r_{3}" in (text := statement(solved("cam-roller"), lang)["given"]) or "r_3" in text
    assert "r_2" not in text and "r_1 + r_3" in _told("cam-roller", lang)


def test_points_of_the_second_solution_are_told_by_their_prime_where_its_quantities_have_a_number() -> None:
    assert statement(solved("best-gamma"), "zh")["primed"] == "$A′$"
    assert statement(solved("8-4"), "zh")["primed"] == "$C′_2$"
    assert not statement(solved("3-9"), "zh")["primed"]
