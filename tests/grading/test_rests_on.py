"""A value rests on what it was found from, whatever the symbol under which that was computed: θ as theta, η as eta."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, marked, mutants_of
from vecpoly.grading.compare.outcome import Basis
from vecpoly.grading.told.named import Told


@pytest.mark.parametrize(
    ("problem", "name", "on"), [("8-15", "AD mm", "theta"), ("5-6", "P", "eta"), ("8-4", "psi_1", "theta")]
)
def test_what_is_found_with_a_computed_symbol_rests_on_its_answer(problem: str, name: str, on: str) -> None:
    assert on in key_of(problem)[name].needs


def test_a_power_follows_from_ones_own_efficiency() -> None:
    exact = key_of("5-6")["P"].exact
    own = exact * key_of("5-6")["eta"].exact / 0.5
    followed = marked("5-6", {"eta": "0.500", "P": f"{own:.4g}"})
    assert followed["P"].is_right and followed["P"].basis is Basis.OWN and not followed["eta"].is_right
    assert not marked("5-6", {"eta": "0.500", "P": f"{1.3 * own:.4g}"})["P"].is_right


def test_nobody_who_wrote_another_value_of_what_a_mistake_moves_is_said_to_have_made_it() -> None:
    """What else was written agrees with a θ of 45°, without K; with θ = 12.6° it cannot come from that."""
    without = next(one for one in mutants_of("8-15") if str(one.slip) == "θ left out of its formula (K)")
    cells = {name: f"{without.values[name].value:.3g}" for name in ("theta", "AD", "AD_2", "gamma_min_2")}
    (made,) = set(marked("8-15", cells).slips.values())
    assert str(made) == "θ left out of its formula (K)"
    assert not marked("8-15", cells | {"theta": "12.6"}).slips


def test_a_polygon_that_shrinks_to_a_point_is_nobodys_work() -> None:
    """Q left out of the frictionless polygon of 4-4: every force in it is 0. To halve it is a mistake."""
    made = [str(one.slip) for one in mutants_of("4-4")]
    assert "force 2 ideal:Q halved" in made and "force 2 ideal:Q dropped" not in made


def test_an_angle_that_nobody_reads_is_judged_by_own_values_and_never_by_the_largest_of_the_sheet() -> None:
    """γ_min of 8-4's first solution is 13.5°; a tenth of the hands find no crank-rocker, and T was 105.8°."""
    one = key_of("8-4")["gamma_min_1"]
    assert one.demoted and one.allowed <= one.exact
    assert not marked("8-4", {"gamma_min_1": "60"})["gamma_min_1"].is_right


def test_only_a_right_answer_that_drawings_can_hardly_tell_from_another_is_told_what_it_is_worth() -> None:
    sheets = [marked("8-4", cells) for cells in ({"gamma_min_1": "13.5"}, {"gamma_min_1": "60"}, {"psi_1": "40.7"})]
    sheets.append(marked("8-4", {"l_BC(1)": "96.6", "gamma_min_1": "39"}))  # the half forgotten, and what follows
    right, wrong, sure, own = (
        sheet[key] for sheet, key in zip(sheets, ("gamma_min_1", "gamma_min_1", "psi_1", "gamma_min_1"), strict=True)
    )
    assert right.messages[-1].words.en.startswith("Drawings scatter by ±14° (100 %) here")
    assert sure.is_right and own.is_right and own.basis is not Basis.EXACT and not wrong.is_right
    assert not any(one.id is Told.DEMOTED for found in (wrong, sure, own) for one in found.messages)


def test_what_is_computed_once_more_as_a_check_is_not_what_others_rest_on() -> None:
    """M_2/Q of the screw jack is read off the polygon and then checked by a formula, which no length enters."""
    assert "F_t1" in key_of("5-5")["M_2/Q"].needs
    for name in ("5-1", "5-4"):
        assert key_of(name)["eta"].needs


def test_a_force_that_is_no_vector_of_the_key_stands_for_its_length_where_that_was_not_written() -> None:
    """η = F_0/F of the clamp is found from both lengths; who writes forces alone goes on with these."""
    own = {"F": "20", "F_0": "30"}
    assert (
        marked("5-3", {**own, "eta": "1.5"})["eta"].is_right and not marked("5-3", {**own, "eta": "4"})["eta"].is_right
    )
