"""A wrong value has a reason where one slip alone explains it, and none where two would do."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, marked, mutants_of, told
from tests.laws import few
from vecpoly import Mistake, Slip
from vecpoly.algebra.quantity import number
from vecpoly.grading.compare.outcome import Basis, Outcome
from vecpoly.grading.key import Kind
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.rules import Rules
from vecpoly.grading.slips.whole import mutated
from vecpoly.grading.told.catalogue import SENTENCES
from vecpoly.grading.told.named import Told
from vecpoly.grading.told.slip import told_of
from vecpoly.words import bare

SEVERAL = ("3-9", "golden", "3-12", "4-3a")


def right(name: str, **spoilt: float) -> dict[str, str]:
    """A sheet with the exact value of all that is asked, some of them times a factor."""
    cells = {}
    for one in key_of(name).quantities:
        if one.asked and one.kind in (Kind.VECTOR, Kind.SIGNED, Kind.SCALAR):
            value = bare(number(abs(one.exact) * abs(spoilt.get(one.key, 1.0)), 4))
            ccw = one.exact * spoilt.get(one.key, 1.0) > 0
            cells[one.key] = value + ((" ccw" if ccw else " cw") if one.kind is Kind.SIGNED else "")
    return cells


def by_mistake(name: str, slip: Slip) -> dict[str, str]:
    """The sheet of one who makes this slip and no other error."""
    mutant = next(one for one in mutants_of(name) if slip in (one.slip, *one.also))
    return right(name, **{key: value.value / (key_of(name)[key].exact or 1.0) for key, value in mutant.values.items()})


@pytest.mark.parametrize("name", SEVERAL)
def test_the_exact_sheet_is_right_throughout(name: str) -> None:
    sheet = marked(name, right(name))
    assert all(one.outcome is Outcome.RIGHT for one in sheet.findings if one.written.raw)
    assert not sheet.roots and not sheet.slips and not sheet.lost


@pytest.mark.parametrize("name", few(SEVERAL, 4))
def test_every_slip_that_changes_an_asked_size_is_caught_and_never_named_as_another_that_looks_otherwise(
    name: str,
) -> None:
    key = key_of(name)
    for mutant in mutants_of(name):
        seen = [
            one
            for one, value in mutant.values.items()
            if key[one].asked and abs(abs(value.value) - abs(key[one].exact)) > 2 * key[one].allowed and value.value
        ]
        if not seen:
            continue
        sheet = marked(name, by_mistake(name, mutant.slip))
        assert sheet.roots, mutant.slip
        for named in sheet.slips.values():
            assert alike(name, named, mutant.slip), (mutant.slip, named)


def alike(name: str, one: Slip, other: Slip) -> bool:
    """Whether two slips are one, or give the same values of all that is asked."""
    first, second = (next(each for each in mutants_of(name) if each.slip == slip).values for slip in (one, other))
    key = key_of(name)
    exact = {each.key: each.exact for each in key.quantities if each.asked}
    sizes = [
        {each: abs(values[each].value) if each in values else abs(exact[each]) for each in exact}
        for values in (first, second)
    ]
    return one == other or all(abs(sizes[0][each] - sizes[1][each]) <= 2 * key[each].allowed for each in exact)


def test_a_forgotten_coriolis_two_is_named_and_what_follows_costs_nothing() -> None:
    sheet = marked("3-9", by_mistake("3-9", Slip(Mistake.HALVED, "ak_C2C3")))
    assert sheet.slips == {"ak_C2C3": Slip(Mistake.HALVED, "ak_C2C3")}
    assert told(sheet, "ak_C2C3") == ["coriolis_2"]
    assert sheet["alpha_2"].is_right and sheet["a_D"].is_right
    full = marked("3-9", right("3-9"))
    assert full.exactly - sheet.exactly == pytest.approx(full["ak_C2C3"].earned.total - sheet["ak_C2C3"].earned.total)


def test_a_final_answer_alone_tells_of_a_slip_where_only_one_gives_it() -> None:
    sheet = marked("3-9", {"alpha_2": "11.22 cw", "a_D": "2.537", "omega_2": "1.995 cw"})
    assert sheet.slips == {"alpha_2": Slip(Mistake.HALVED, "ak_C2C3")}
    assert sheet["a_D"].basis is Basis.SLIP


def test_what_is_right_although_it_rests_on_the_value_exonerates_from_the_slip() -> None:
    cells = right("3-9")
    alone = marked("3-9", {**cells, "ak_C2C3": f"{key_of('3-9')['ak_C2C3'].exact / 2:.3g}"})
    assert not alone["ak_C2C3"].is_right and not alone.slips
    assert all(one.is_right for one in alone.findings if one.written.raw and one.key != "ak_C2C3")


def test_slips_that_give_the_same_numbers_are_told_in_one_sentence() -> None:
    made = [each.slip for each in mutants_of("3-2") if each.slip.mistake is Mistake.OTHER_CENTRE
            and each.slip.key == "P12P14" and each.slip.instead in ("P23", "P13")]  # fmt: skip
    assert len(made) == 2  # by directions alone, which nobody writes here, one is told from the other
    for slip in made:
        sheet = marked("3-2", by_mistake("3-2", slip))
        (root,) = sheet.slips
        assert sheet.slips[root] in made and "slip" in told(sheet, root)
        assert sheet[root].messages[-1].words.en.count("wrong two centres") < 2


def test_a_mistake_by_which_lines_meet_badly_is_allowed_its_own_scatter() -> None:
    key = key_of("5-2")
    turned = next(one for one in mutants_of("5-2") if str(one.slip) == "F turned")
    larger = turned.values["bc"].value / key["bc"].exact
    assert mutated(key["bc"], turned, key.allowance).allowed > 3 * larger * key["bc"].allowed
    halved = next(one for one in mutants_of("5-2") if str(one.slip) == "force F:R_23 halved")
    assert mutated(key["bc"], halved, key.allowance).allowed == pytest.approx(key["bc"].allowed)


def test_where_two_slips_would_do_none_is_named() -> None:
    same = [
        one for one in mutants_of("3-9") if "omega_2" in one.values and abs(one.values["omega_2"].value + 3.99) < 0.05
    ]
    assert same
    cells = {"alpha_2": "14.0 cw"}  # without the Coriolis term, and with it turned
    sheet = marked("3-9", cells)
    assert not sheet.slips and "two_slips" in told(sheet, "alpha_2")


@pytest.mark.parametrize(("cell", "sentence"), [
    ("225.7", "pow10"), ("0.02257", "pow10"), ("225.7 m/s", "pow10"), ("0.2257 mm/s", "pow10"),
    ("1.4185", "two_pi"), ("0.03593", "two_pi"),
    ("2.156", "per_minute"), ("0.02364", "per_minute"),
])  # fmt: skip
def test_powers_of_ten_two_pi_and_minutes_are_told_apart(cell: str, sentence: str) -> None:
    sheet = marked("3-9", right("3-9") | {"v_D": cell})
    assert sheet["v_D"].outcome is Outcome.WRONG and sentence in told(sheet, "v_D")
    assert sheet["v_D"].earned.method == pytest.approx(key_of("3-9")["v_D"].points.method / 2)


def test_no_factor_is_offered_where_no_slip_explains_it() -> None:
    for factor in (0.5, 2.0, 1 / 3, 3.0, 0.707, 1.7):
        sheet = marked("3-9", right("3-9", a_E=factor))
        assert not sheet.slips and told(sheet, "a_E")[0] == "wrong", factor
        assert sheet["a_E"].earned.total == 0


def test_a_sense_alone_loses_the_sense_alone() -> None:
    sheet = marked("3-9", right("3-9", alpha_2=-1.0))
    worth = key_of("3-9")["alpha_2"].points
    assert told(sheet, "alpha_2") == ["sense"] and sheet["alpha_2"].earned.total == worth.total - worth.sense
    assert not sheet.slips


def test_a_sense_that_is_not_said_is_neither_right_nor_wrong() -> None:
    sheet = marked("3-9", right("3-9") | {"omega_2": "1.995"})
    assert sheet["omega_2"].outcome is Outcome.UNSAID and "sense_missing" in told(sheet, "omega_2")


def test_all_senses_reversed_are_one_mistake() -> None:
    sheet = marked("3-9", by_mistake("3-9", Slip(Mistake.REVERSED, "v_B")))
    assert sheet.slips == {"omega_2": Slip(Mistake.REVERSED, "v_B")}
    assert sheet["omega_3"].is_right and sheet["omega_3"].earned.sense == 0


def test_another_vector_taken_is_told_by_its_symbol() -> None:
    sheet = marked("3-9", right("3-9") | {"v_C2B": "0.1724", "v_C2C3": "0.2455"})
    assert told(sheet, "v_C2B")[-1] == "swapped" and sheet["v_C2B"].messages[-1].numbers["other"] == "v_{C2C3}"


def test_the_value_of_another_vector_in_ones_own_direction_is_not_that_vector() -> None:
    own, other = (key_of("3-9")[key].degrees for key in ("v_C2B", "v_C2C3"))
    said = {at: told(marked("3-9", right("3-9") | {"v_C2B": f"0.1724 m/s ∠{at:.0f}°"}), "v_C2B") for at in (own, other)}
    assert "swapped" not in said[own] and said[other][-1] == "swapped"


def test_a_link_that_only_translates_has_no_angular_velocity() -> None:
    sheet = (
        marked("travel-doubler", {"omega_3": "2.5 ccw"})
        if "omega_3" in {one.key for one in key_of("travel-doubler").quantities}
        else None
    )
    zeros = [
        (name, one.key)
        for name in ("3-9", "4-3a", "oldham-coupling", "travel-doubler", "3-1a")
        for one in key_of(name).quantities
        if one.exact == 0 and one.kind is Kind.SIGNED
    ]
    assert zeros or sheet is not None
    for name, key in zeros:
        assert told(marked(name, {key: "3.1 ccw"}), key)[-1] == "translates"
        assert marked(name, {key: "0"})[key].is_right and marked(name, {key: "—"})[key].is_right


def constantly(factor: float, name: str = "3-9") -> Marked:
    """All velocities times a factor; lengths as they are."""
    key = key_of(name)
    cells = {
        one.key: f"{one.exact * factor:.4g}"
        for one in key.quantities
        if one.kind is Kind.VECTOR and one.block == "velocity"
    }
    cells |= {one.key: f"{one.exact:.1f}" for one in key.quantities if one.kind is Kind.READING and one.mu == "mu_v"}
    return marked(name, cells)


def test_a_wrong_scale_costs_once() -> None:
    sheet = constantly(1.3)
    assert "scale_const" in told(sheet, "v_B") and sheet.roots == ("v_B",)
    assert all(sheet[key].basis in (Basis.SCALE, Basis.OWN) for key in ("v_C2B", "v_D", "v_E"))


def test_ones_own_scale_is_right_when_it_is_stated() -> None:
    cells = {"mu_v": "0.01 (m/s)/mm", "v_B": "0.3", "bc2": "24.5", "v_C2B": "0.245", "pd": "22.6", "v_D": "0.226"}
    sheet = marked("3-9", cells)
    assert all(sheet[key].is_right for key in cells if key != "mu_v")
    assert not marked("3-9", {key: cell for key, cell in cells.items() if key != "mu_v"})["bc2"].is_right


def test_a_unit_costs_once_a_problem_and_nothing_where_it_is_printed() -> None:
    bare_cells = {"v_B": "0.300", "v_D": "0.2257", "v_E": "0.1727"}
    assert marked("3-9", bare_cells).lost == 0
    strict = marked("3-9", bare_cells, Rules(printed=False))
    assert strict.lost == Rules().unit and told(strict, "v_D")[-1] == "unit_missing"
    wrong = marked("3-9", {key: f"{cell} m" for key, cell in bare_cells.items()})
    assert wrong.lost == Rules().unit and "unit_wrong" in told(wrong, "v_D") and wrong["v_D"].outcome is Outcome.RIGHT


def test_a_value_that_is_not_ones_own_length_times_the_scale_is_told_with_both() -> None:
    length, value = {"pd": "37.6"}, key_of("3-9").scales["mu_v"] * 37.6
    assert "read" not in told(marked("3-9", length | {"v_D": f"{value:.4f}"}), "v_D")
    sheet = marked("3-9", length | {"v_D": f"{1.2 * value:.4f}"})
    (said,) = (one for one in sheet["v_D"].messages if one.id.value == "read")
    assert said.numbers["mm"] == "37.6" and str(said.numbers["own"]).startswith(f"{value:.3g}")


def test_digits_are_remarked_on_and_cost_nothing() -> None:
    sheet = marked("3-9", {"v_D": "0.2257483", "v_E": "0.2"})
    assert "many_digits" in told(sheet, "v_D") and "few_digits" in told(sheet, "v_E")
    assert sheet["v_D"].earned == key_of("3-9")["v_D"].points


def test_what_nobody_can_read_waits_for_a_person() -> None:
    sheet = marked("3-9", {"v_D": "O.23", "omega_2": "-2.0 ccw", "v_E": ""})
    assert {one.key for one in sheet.queue} == {"v_D", "omega_2"} and sheet.total == 0
    assert "O.23" in sheet["v_D"].messages[0].words.zh


@pytest.mark.parametrize("name", list(Told))
def test_every_sentence_has_both_languages_with_the_same_gaps(name: Told) -> None:
    said = SENTENCES[name]
    gaps = [
        {part.partition("}")[0] for part in text.split("{")[1:] if part.partition("}")[0].isalpha()}
        for text in (said.zh, said.en)
    ]
    assert gaps[0] == gaps[1] and said.zh and said.en


@pytest.mark.parametrize("mistake", Mistake)
def test_every_mistake_has_a_sentence_of_its_own_in_both_languages(mistake: Mistake) -> None:
    said = told_of(Slip(mistake, "v_B", "C")).words
    others = {told_of(Slip(other, "v_B", "C")).words for other in Mistake if other is not mistake}
    assert "$v_{B}$" in said.zh and "$v_{B}$" in said.en and said not in others


@pytest.mark.parametrize("name", SEVERAL)
def test_a_small_error_is_told_no_finer_than_two_digits_of_what_is_allowed(name: str) -> None:
    for one in marked(name, right(name)).findings:
        for said in one.messages:
            if said.id in (Told.OK, Told.OK_RECKONED) and "×" not in str(said.numbers["t"]):
                e, t = (str(said.numbers[key]).partition(" ")[0].partition(".") for key in ("e", "t"))
                assert len(e[2]) <= max(len(t[2]), 1), (one.key, said.numbers)


def test_a_size_that_is_right_by_an_own_length_alone_is_not_told_as_right_without_that() -> None:
    """Whoever wrote the length of another vector, its value and its direction, was told the magnitude to be right."""
    key = key_of("3-9")
    other, mu = key["v_C2C3"], key.scales["mu_v"]
    cells = {key["v_C2B"].line: f"{other.exact / mu:.1f} mm", "v_C2B": f"{other.exact:.3f} ∠ {other.degrees:.1f}°"}
    found = marked("3-9", cells)["v_C2B"]
    assert found.outcome is Outcome.DIRECTION
    (said,) = (one for one in found.messages if one.id is Told.SIZE_OWN)
    assert f"{other.exact / mu:.1f} mm" in said.words.en
