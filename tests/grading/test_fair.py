"""What a fair lecturer would give: a zero follows from nobody's mistake, a direction is judged beside every size, and a
mistake costs where it was made."""

from __future__ import annotations

from cmath import exp
from math import radians

import pytest

from tests.grading.cases import key_of, marked, mutants_of, problem_of, told
from vecpoly import Mistake, Slip, load, solve
from vecpoly.algebra.quantity import number
from vecpoly.grading.compare.outcome import Basis, Outcome
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import Graded, Kind
from vecpoly.problem.values.vary import vary
from vecpoly.words import bare


def cell(one: Graded, times: float = 1.0, turned: float = 0.0) -> str:
    """The exact value as a student writes it."""
    value = bare(number(abs(one.exact * times), 4))
    if one.kind is Kind.SIGNED:
        return f"{value} {'ccw' if one.exact * times > 0 else 'cw'}"
    return f"{value} ∠ {one.degrees + turned:.1f}°" if one.degrees is not None else value


def sheet(name: str, **cells: str) -> dict[str, str]:
    """Everything that is asked, right but for these cells."""
    asked = [one for one in key_of(name).quantities if one.asked and one.kind is not Kind.PLACE]
    return {one.key: cell(one) for one in asked} | cells


@pytest.mark.parametrize("name", ["3-9", "3-2", "6-1", "5-3"])
def test_a_sheet_of_zeros_earns_no_more_than_its_scales(name: str) -> None:
    found = marked(name, {key: "0 cw" if "cw" in text else "0" for key, text in sheet(name).items()})
    assert not found.slips and found.total <= sum(found.stated.values())
    assert not any(one.is_right for one in found.findings if one.written.raw and key_of(name)[one.key].exact)


def test_zero_is_wrong_however_much_drawings_scatter_and_the_reason_is_not_its_tolerance() -> None:
    """F and η of 5-3 scatter by all of their size: 0 was right, 'error 39 N, allowed ±39 N'."""
    one = key_of("5-3")["F"]
    found = marked("5-3", sheet("5-3", F="0"))
    assert one.demoted and one.allowed == one.exact
    assert told(found, "F") == ["not_zero"]


def test_a_place_that_scatters_over_the_whole_figure_says_so() -> None:
    """P_58 of class-iii may lie 0.35 m off; any place was right without a word, and then any place with one."""
    far = [one.key for one in key_of("class-iii").quantities if one.demoted and one.kind is Kind.PLACE]
    assert "P_58" in far and "P_14" not in far
    assert "demoted" in told(marked("class-iii", {"P_58": beside("class-iii", "P_58", along=0.05)}), "P_58")
    assert told(marked("class-iii", {"P_58": beside("class-iii", "P_58", across=0.05)}), "P_58")[0] == "beside"


def beside(name: str, key: str, along: float = 0.0, across: float = 0.0) -> str:
    """A place so far (m) from the exact one, along the direction in which drawings scatter and across it."""
    one = key_of(name)[key]
    assert one.at is not None and one.leans is not None
    at = complex(*one.at) + complex(along, across) * exp(1j * radians(one.leans))
    return f"({1e3 * at.real:.3f}, {1e3 * at.imag:.3f})"


LEANING = [("class-iii", "P_26"), ("class-iii", "P_58"), ("3-1d", "P_46"), ("curv-1", "p_OE")]


@pytest.mark.parametrize(("name", "key"), LEANING)
def test_a_place_is_held_to_the_line_along_which_drawings_scatter(name: str, key: str) -> None:
    one = key_of(name)[key]
    assert 0 < one.across < one.allowed / 3
    for along, across, right in ((0.9, 0.9, True), (-0.9, -0.9, True), (0.0, 1.6, False), (0.0, -1.6, False)):
        said = marked(name, {key: beside(name, key, along * one.allowed * 0.9, across * one.across)})[key]
        assert said.outcome.is_right is right, (along, across)


@pytest.mark.parametrize(("name", "key"), LEANING[1:])
def test_a_right_drawing_by_pencil_is_accepted_where_places_lean(name: str, key: str) -> None:
    """Other hands than those whose scatter made T."""
    at = [solve(problem_of(name), by="pencil", seed=seed, repeats=0).answers[key].drawn_vector for seed in range(1, 41)]
    cells = [f"({1e3 * z.real:.2f}, {1e3 * z.imag:.2f})" for z in at if z is not None]
    right = [marked(name, {key: cell})[key].outcome.is_right for cell in cells]
    assert len(cells) == 40 and sum(right) >= 38


def test_words_in_every_cell_earn_no_scale() -> None:
    assert marked("3-9", dict.fromkeys(sheet("3-9"), "不会")).total == 0


def test_a_reaction_of_the_right_size_in_a_wrong_direction_is_wrong_beside_its_own_length_too() -> None:
    one = key_of("4-3a")["R_41"]
    mm = f"{key_of('4-3a')[one.line].exact:.1f} mm"
    for turned, outcome in ((0.0, Outcome.RIGHT), (180.0, Outcome.SENSE), (70.0, Outcome.DIRECTION)):
        found = marked("4-3a", sheet("4-3a", R_41=cell(one, turned=turned), **{one.line: mm}))
        assert found["R_41"].outcome is outcome
    lost = marked("4-3a", sheet("4-3a", **{one.line: mm})).exactly - found.exactly
    assert lost == pytest.approx(one.points.method / 2)  # as it costs where no length stands beside it
    alone = [marked("4-3a", sheet("4-3a", R_41=cell(one, turned=turned))).exactly for turned in (0.0, 70.0)]
    assert lost == pytest.approx(alone[0] - alone[1])


def test_a_size_that_follows_from_an_own_length_is_wrong_by_its_direction_alone() -> None:
    one = key_of("3-9")["v_E"]
    read = 1.5 * key_of("3-9")["pe"].exact
    found = marked("3-9", sheet("3-9", pe=f"{read:.1f} mm", v_E=cell(one, 1.5, 90.0)))
    assert found["v_E"].outcome is Outcome.DIRECTION and "wrong_from" not in told(found, "v_E")


def test_a_size_written_as_negative_points_the_other_way() -> None:
    assert marked("3-9", sheet("3-9", v_B="-" + cell(key_of("3-9")["v_B"])))["v_B"].outcome is Outcome.SENSE


def test_what_is_equal_to_an_own_value_is_gone_on_from() -> None:
    """ω_3 = ω_2 is asked, and 2 ω_2 v_r is found from ω_2, which nobody writes down twice."""
    key = key_of("3-9")
    asked = sheet("3-9", omega_3=cell(key["omega_3"], 1.2), ak_C2C3=cell(key["ak_C2C3"], 1.2))
    found = marked("3-9", {name: text for name, text in asked.items() if name != "omega_2"})
    assert (found["ak_C2C3"].outcome, found["ak_C2C3"].basis) == (Outcome.RIGHT, Basis.OWN)
    assert found.roots[0] == "omega_3" and "ak_C2C3" not in found.roots


def test_a_mistake_costs_at_the_vector_with_which_it_was_made() -> None:
    """A Coriolis term laid off the wrong way: α is found before a^k is written down, and follows from it."""
    key, slip = key_of("3-9"), Slip(Mistake.REVERSED, "ak_C2C3")
    mutant = next(one for one in mutants_of("3-9") if slip in (one.slip, *one.also))
    cells = {n: cell(key[n], v.value / key[n].exact) for n, v in mutant.values.items() if key[n].asked}
    found = marked("3-9", sheet("3-9", **cells) | {"ak_C2C3": cell(key["ak_C2C3"], turned=180.0)})
    assert found.slips == {"ak_C2C3": slip} and found["alpha_3"].is_right


def test_two_names_exchanged_are_no_mistake_of_the_construction() -> None:
    key = key_of("3-9")
    one, other = key["v_C2B"], key["v_C2C3"]
    found = marked("3-9", sheet("3-9", v_C2B=bare(number(other.exact, 4)), v_C2C3=bare(number(one.exact, 4))))
    assert not found.slips and all("swapped" in told(found, name) for name in ("v_C2B", "v_C2C3"))


def test_a_thousandfold_value_everywhere_is_a_matter_of_units_and_not_of_the_scale() -> None:
    key = key_of("3-9")
    cells = {n: cell(key[n], 1000.0) for n in ("v_B", "v_C2B", "v_C2C3", "v_E", "v_D")}
    found = marked("3-9", sheet("3-9", **cells))
    assert "pow10" in {said.id for one in found.findings for said in one.messages}
    assert "scale_const" not in {said.id for one in found.findings for said in one.messages}


def test_every_variant_of_a_problem_is_worth_the_same_though_a_centre_lies_off_its_sheet() -> None:
    """P_24 found outside of the paper has no scale of its own: the diagram's is stated all the same."""
    worth = {answer_key(vary(load("3-2"), values)).worth for values in (
        {"AB": "54 mm", "phi": "140 deg"}, {"AB": "50 mm", "phi": "168 deg"},
    )}  # fmt: skip
    assert len(worth) == 1


def test_an_own_centre_is_gone_on_from_to_the_rates_and_velocities_that_rest_on_it() -> None:
    """P_13 read 20 mm aside: ω_3 = ω_1 P14P13 / P34P13 from there, and v_C = ω_3 l_CD by whoever takes that way."""
    key = key_of("3-2")
    centre, omega, speed = key["P_13"], key["omega_3"], key["v_C"]
    assert centre.at is not None
    x, y = centre.at[0] - 0.02, centre.at[1]
    a, d = complex(x, y), complex(x, y) - 0.12
    rate = 10 * abs(a) / abs(d)
    cells = sheet("3-2", P_13=f"({1e3 * x:.1f}, {1e3 * y:.1f}) mm", omega_3=f"{rate:.3f} ccw", v_C=f"{rate * 0.09:.4f}")
    assert abs(rate - omega.exact) > 2 * omega.allowed and abs(rate * 0.09 - speed.exact) > 2 * speed.allowed
    found = marked("3-2", cells)
    assert found.roots == ("P_13",)
    assert {found[name].basis for name in ("omega_3", "v_C")} == {Basis.OWN}
    assert "(-116" in found["omega_3"].messages[0].words.en.replace("−", "-") or found["omega_3"].chain > 1


def test_two_values_that_are_wrong_alike_are_not_both_right_by_each_other() -> None:
    """v_C misread and ω_3 = v_C/l found from it: ω_3 follows, v_C costs; and K follows from θ, not θ from K."""
    key = key_of("golden")
    found = marked("golden", sheet("golden", v_C=cell(key["v_C"], 1.3), omega_3=cell(key["omega_3"], 1.3)))
    assert "v_C" in found.roots and found["omega_3"].basis is Basis.OWN
    angles = marked("8-3a", sheet("8-3a", theta="20", K="1.25"))
    assert angles.roots == ("theta",) and angles["K"].basis is Basis.OWN


def test_angles_exchanged_are_no_mistake_of_the_construction_though_nobody_takes_one_for_the_other() -> None:
    key = key_of("8-15")
    one, other = key["theta"], key["gamma_min"]
    cells = sheet("8-15", theta=bare(number(other.exact, 4)), gamma_min=bare(number(one.exact, 4)))
    assert not marked("8-15", cells).slips


@pytest.mark.parametrize(("name", "times"), [("4-5", 1.43), ("4-5", 0.63), ("3-12", 1.35)])
def test_values_that_are_all_too_large_or_too_small_are_no_single_mistake(name: str, times: float) -> None:
    """One of many wrong values agrees with some mistake by chance: it takes more than that to name it."""
    key = key_of(name)
    written = [one for one in key.quantities if one.asked or one.kind is Kind.READING]
    cells = {one.key: cell(one, times) for one in written if one.kind in (Kind.READING, Kind.VECTOR, Kind.SIGNED)}
    assert not marked(name, cells).slips


def test_the_greatest_speed_is_not_the_least_though_they_are_nearer_than_a_hundredth() -> None:
    key = key_of("7-5")
    greatest, least = key["n_max"], key["n_min"]
    assert abs(greatest.exact - least.exact) < 0.011 * greatest.exact
    found = marked("7-5", sheet("7-5", n_max=cell(least), n_min=cell(greatest)))
    assert not found["n_max"].is_right and not found["n_min"].is_right
    assert marked("7-5", sheet("7-5"))["n_max"].outcome is Outcome.RIGHT


def test_forces_are_read_in_tens_of_newtons() -> None:
    one = key_of("4-3a")["R_41"]
    assert marked("4-3a", sheet("4-3a", R_41=f"{one.exact / 10:.2f} daN"))["R_41"].is_right
