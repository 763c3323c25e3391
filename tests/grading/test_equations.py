"""The direction and magnitude rows of vector equations: ticked, read, paid out of the points for lines."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.grading.cases import key_of, marked
from tests.grading.test_diagnosis import right
from vecpoly.grading.compare.outcome import Outcome
from vecpoly.grading.equations.ticks import shown, ticks
from vecpoly.grading.key import AnswerKey, Kind
from vecpoly.grading.rules import Rules
from vecpoly.grading.student import check_answers
from vecpoly.words import Words

ROWS = ("eq1_dir", "eq1_size", "eq2_dir", "eq2_size")
STRICT = Rules(compensatory=False)


def filled(name: str, **other: str) -> dict[str, str]:
    """All rows as they should be, but for some."""
    return {row.key: shown(row.known) for row in key_of(name).equations} | other


def test_the_four_bar_has_the_unknowns_of_the_textbook() -> None:
    assert filled("golden") == {"eq1_dir": "✓✓✓", "eq1_size": "?✓?", "eq2_dir": "?✓✓✓✓✓", "eq2_size": "?✓?✓✓?"}
    assert AnswerKey.from_json(key_of("golden").as_json()) == key_of("golden")


@pytest.mark.parametrize("name", ["golden", "3-9", "4-3a", "5-2"])
def test_right_rows_cost_nothing_and_are_worth_nothing_more(name: str) -> None:
    plain, ticked = marked(name, right(name)), marked(name, right(name) | filled(name))
    assert ticked.total == ticked.worth == plain.total == plain.worth
    assert not plain.equations and len(ticked.equations) == len(key_of(name).equations)


def test_one_wrong_sign_costs_half_a_row_and_more_cost_all_of_it_with_the_reason() -> None:
    full = marked("golden", right("golden"))
    one = marked("golden", right("golden") | filled("golden", eq1_size="✓✓?"))
    two = marked("golden", right("golden") | filled("golden", eq1_size="✓✓✓"))
    assert (full.exactly - one.exactly, full.exactly - two.exactly) == pytest.approx((0.5, 1.0))
    row = next(each for each in one.equations if each.row.key == "eq1_size")
    assert row.outcome is Outcome.CLOSE and "v_{C}" in row.messages[0].words.zh and "未知" in row.messages[0].words.zh
    turned = marked("golden", right("golden") | filled("golden", eq1_dir="?✓✓"))
    assert "is given" in turned.equations[0].messages[0].words.en


@given(st.lists(st.booleans(), min_size=18, max_size=18))
def test_every_wrong_sign_costs_and_none_costs_more_than_its_row(flipped: list[bool]) -> None:
    full, lost, wrong, left = marked("golden", right("golden")), 0.0, {}, iter(flipped)
    for row in key_of("golden").equations:
        signs = [known is not next(left) for known in row.known]
        count = sum(mine is not known for mine, known in zip(signs, row.known, strict=True))
        lost += row.points * (0.0, 0.5, 1.0)[min(count, 2)]
        wrong[row.key] = shown(signs)
    sheet = marked("golden", right("golden") | wrong)
    assert full.exactly - sheet.exactly == pytest.approx(lost) and sheet.worth == full.worth


@pytest.mark.parametrize("raw", ["⊥CD B→A ⊥BC", "✓,√,v", "✓✓✓", "YY知", "⊥CD，✓；✓"])
def test_what_stands_in_the_cells_is_read_as_given(raw: str) -> None:
    assert ticks(raw, 3) == (True, True, True)


@pytest.mark.parametrize("raw", ["✓✓", "✓✓✓✓", "✓0?", "ωl"])
def test_what_is_no_row_of_so_many_terms_waits_for_a_person(raw: str) -> None:
    assert isinstance(ticks(raw, 3), Words)
    sheet = marked("golden", filled("golden", eq1_size=raw))
    (doubt,) = sheet.doubts
    assert doubt[0].en == "equation 1, magnitude" and sheet.waiting >= 1


def test_a_length_that_is_typed_in_costs_nothing_where_numbers_alone_do_not_do() -> None:
    """The points of its line stand with it; they were taken for its accuracy marks."""
    key, cells = key_of("golden"), right("golden")
    vectors = [one for one in key.quantities if one.asked and one.line and one.kind is Kind.VECTOR]
    typed = {one.line: f"{one.mm:.1f}" for one in vectors if one.mm}
    assert typed and marked("golden", cells | typed, STRICT).exactly == pytest.approx(
        marked("golden", cells, STRICT).exactly
    )


def test_without_its_equation_a_number_keeps_its_accuracy_mark_only_where_the_rules_let_it() -> None:
    cells = right("golden")
    assert marked("golden", cells | filled("golden"), STRICT).total == 20.0
    bare, wrong = marked("golden", cells, STRICT), marked("golden", cells | filled("golden", eq1_dir="???"), STRICT)
    assert all(one.earned.accuracy == 0 for one in bare.findings if one.written.raw)
    assert wrong["v_C"].earned.accuracy == 0 < wrong["a_C"].earned.accuracy
    assert "no_equation" in [said.id.value for said in wrong["v_C"].messages]
    assert bare.worth == wrong.worth == 20.0 and bare.exactly < wrong.exactly < 20.0


def test_a_student_may_ask_about_a_row_alone() -> None:
    from vecpoly import load

    checked = check_answers(load("3-9"), {"eq1_size": "? ✓ ? ✓ ?"})
    assert checked.right and checked.rows("en")[0][2] == "right"
    assert not check_answers(load("3-9"), {"eq1 size": "? ✓ ✓ ✓ ✓"}).right
