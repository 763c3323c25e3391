"""One root cause costs once, however it is written down."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, marked, mutants_of, problem_of
from vecpoly.grading.compare.outcome import Basis, Outcome
from vecpoly.grading.key import Kind
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.marking.marker import mark
from vecpoly.grading.rules import USUAL_RULES
from vecpoly.grading.sheet import sheet_of
from vecpoly.grading.slips.mutants import Mutant
from vecpoly.grading.student import check_answers
from vecpoly.grading.told.named import Told


def left_out(name: str, term: str) -> Mutant:
    """The mistake of one who leaves a term out of a polygon."""
    return next(one for one in mutants_of(name) if one.leaves_out(term))


def written(name: str, mutant: Mutant, **otherwise: float) -> dict[str, str]:
    """All values as they follow from a mistake, with their senses, but for these."""
    cells = {}
    for one in key_of(name).quantities:
        value = otherwise.get(one.key, mutant.values[one.key].value if one.key in mutant.values else one.exact)
        sense = (" ccw" if value > 0 else " cw") if one.kind is Kind.SIGNED else ""
        cells[one.key] = f"{abs(value):.4g}{sense}"
    return cells


def lost(sheet: Marked) -> float:
    return sheet.key.worth - sheet.exactly


def lost_at(sheet: Marked, key: str) -> float:
    return sheet.key[key].points.total - sheet[key].earned.total


@pytest.mark.parametrize(("name", "term"), [("3-9", "ak_C2C3"), ("3-12", "an_CB"), ("3-12", "ak_D5D4")])
def test_a_term_that_is_left_out_may_be_written_as_zero_and_costs_once(name: str, term: str) -> None:
    mutant = left_out(name, term)
    sheet = marked(name, written(name, mutant, **{term: 0.0}))
    assert sheet.roots == (term,) and sheet[term].outcome is Outcome.WRONG
    assert sheet.slips == {term: mutant.slip}
    assert lost(sheet) == pytest.approx(lost_at(sheet, term))


@pytest.mark.parametrize(("name", "term"), [("3-9", "ak_C2C3"), ("3-12", "an_CB"), ("3-12", "ak_D5D4")])
def test_what_a_mistake_moves_but_little_is_right_by_it_and_not_close(name: str, term: str) -> None:
    sheet = marked(name, written(name, left_out(name, term)))
    assert not [one.key for one in sheet.findings if one.outcome is Outcome.CLOSE]
    moved = [one for one in sheet.findings if one.basis is Basis.SLIP]
    assert moved and all(one.outcome is Outcome.RIGHT for one in moved)


def test_whoever_lost_a_quarter_of_a_point_has_not_all_of_them() -> None:
    key = key_of("3-9")
    turning = next(one for one in key.quantities if one.kind is Kind.SIGNED and one.asked)
    right = {one.key: f"{abs(one.exact):.4g}" + (" ccw" if one.exact > 0 else " cw") * (one.kind is Kind.SIGNED)
             for one in key.quantities if one.kind in (Kind.VECTOR, Kind.SIGNED, Kind.READING)}  # fmt: skip
    whole = marked("3-9", right)
    wrong = marked("3-9", right | {turning.key: f"{abs(turning.exact) / 6.2832:.4g}" + right[turning.key][-4:]})
    assert whole.exactly > wrong.exactly
    assert wrong.total < whole.total


def test_the_solutions_of_a_synthesis_may_be_numbered_otherwise() -> None:
    """What somebody calls the first is the key's second: right throughout, and said."""
    key = key_of("8-4")
    right = {one.key: f"{one.exact:.5g}" for one in key.quantities if one.asked}
    other = {name[:-1] + {"1": "2", "2": "1"}[name[-1]] if name[-2:] in ("_1", "_2") else name: text
             for name, text in right.items()}  # fmt: skip
    assert key.solutions == (1, 2) and other != right
    for cells, said in ((right, 0), (other, 1)):
        sheet = marked("8-4", cells)
        assert all(one.is_right for one in sheet.findings if one.written.raw)
        assert len(sheet.messages) == said
    checked = check_answers(problem_of("8-4"), other)
    assert checked.right and "1 → 2, 2 → 1" in str(checked) and checked.as_json()["said"]
    mixed = marked("8-4", right | {"AB_1": right["AB_2"]})
    assert not mixed["AB_1"].is_right and mixed["AB_2"].is_right and mixed["BC_1"].is_right


@pytest.mark.parametrize("name", ["K-crank-rocker-gamma", "K-crank-rocker-AD", "8-15"])
def test_the_solution_without_a_number_may_be_exchanged_with_the_numbered_one(name: str) -> None:
    """AB and AB_2: which is which nobody is told, and whoever has them the other way round is right throughout."""
    key = key_of(name)
    right = {one.key: f"{one.exact:.5g}" for one in key.quantities if one.asked}
    pairs = [one for one in right if f"{one}_2" in right]
    other = right | {one: right[f"{one}_2"] for one in pairs} | {f"{one}_2": right[one] for one in pairs}
    assert key.solutions == (1, 2) and len(pairs) > 1 and other != right
    for cells, said in ((right, 0), (other, 1)):
        sheet = marked(name, cells)
        assert all(one.is_right for one in sheet.findings if one.written.raw)
        assert len(sheet.messages) == said
    second = check_answers(problem_of(name), {one: right[f"{one}_2"] for one in pairs})
    assert second.right and "1 → 2" in str(second)


def test_a_scale_is_missed_only_where_something_of_its_figure_was_answered() -> None:
    """Whoever left a problem blank was told of each of its scales."""
    key = key_of("3-12")
    told: dict[str, list[str]] = {}
    sheets: dict[str, dict[str, str]] = {"blank": {}, "velocity": {"v_C": "0.506"}, "acceleration": {"a_C": "1.33"}}
    for name, cells in sheets.items():
        sheet = sheet_of(key, cells, printed_scales=False)
        marked = mark(problem_of("3-12"), key, lambda: (), sheet, USUAL_RULES)
        told[name] = [str(one.numbers["mu"]) for one in marked.messages if one.id is Told.SCALE_UNDECLARED]
    assert told == {"blank": [], "velocity": ["μ_v"], "acceleration": ["μ_a"]}
