"""Drag links and dead centres: what is found is led by AB from one position to the other, and nothing else is taken."""

from __future__ import annotations

from contextlib import suppress
from math import cos, radians

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.generators.designed.driven import half_a_turn, rests
from tests.laws import often
from vecpoly.designs.verdict import Verdict
from vecpoly.errors import AssemblyError
from vecpoly.oracle.synthesis.registry import linkages


def drag_link(ad: float, ab: float, k: float, phi: float, psi: float) -> vecpoly.Problem:
    """A drag link by its data (mm, deg)."""
    data = {"AD": f"{ad} mm", "AB": f"{ab} mm", "K": f"{k}", "phi_1": f"{phi} deg", "psi_1": f"{psi} deg"}
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": "drag-link", "data": data, "find": ["BC", "CD"]})


def verdicts(problem: vecpoly.Problem) -> list[str]:
    """Of all candidates, by drawing and closed solution alike."""
    drawn = [one.verdict for one in problem.solve(by="exact").construction.candidates]
    assert drawn == [one.verdict.name for one in linkages(problem.design)]
    return drawn


def test_a_drag_link_with_its_positions_on_two_circuits_is_rejected() -> None:
    """Driven by 102.86°, DC of the first would turn by 93.03°."""
    for phi in (20, 250):
        assert verdicts(drag_link(40, 55, 2.5, phi, 10)) == ["OTHER_SIDE"]


@pytest.mark.parametrize("data", [(20, 55, 1.3, 300, 200), (25, 60, 1.5, 200, 90), (25, 60, 1.5, 275, 0)])
def test_a_drag_link_whose_driven_crank_would_point_backwards_is_told_with_the_angle_that_it_has(
    data: tuple[float, float, float, float, float],
) -> None:
    """It is the linkage for the opposite angle."""
    ad, ab, k, phi, psi = data
    problem = drag_link(ad, ab, k, phi, psi)
    assert verdicts(problem) == ["REVERSED"]
    ended = problem.solve(by="exact").construction.conclusion
    assert ended is not None and "ψ_1 ± 180°" in ended.en and "ψ_1 ± 180°" in ended.zh
    assert verdicts(drag_link(ad, ab, k, phi, psi + 180)) == ["VALID"]


@pytest.mark.parametrize(("psi", "told"), [(10, "$φ_1$ may be 0 to 1.532 deg or 318.4 to 360 deg."), (190, "")])
def test_the_range_told_of_a_drag_link_has_one_circuit_and_the_given_ray(psi: float, told: str) -> None:
    ended = drag_link(40, 55, 2.5, 100, psi).solve(by="exact").construction.conclusion
    assert ended is not None and told in ended.en and "49.38" not in ended.en


@settings(max_examples=often(30))
@given(st.integers(10, 50), st.integers(30, 120), st.integers(110, 250), st.integers(0, 359), st.integers(0, 359))
def test_a_drag_link_is_taken_where_its_driven_crank_turns_half_round_while_ab_is_led_and_nowhere_else(
    ad: int, ab: int, k: int, phi: int, psi: int
) -> None:
    try:
        solution = vecpoly.solve(drag_link(ad, ab, k / 100, phi, psi), by="exact", repeats=0)
    except AssemblyError:
        return  # the bisector is parallel to the ray
    assert not half_a_turn(solution)


@pytest.mark.parametrize(("ad", "ab", "phi", "psi"), [(25, 60, 3.3, 53.2), (20, 80, 350, 320)])
def test_a_drag_link_without_quick_return_is_found_where_half_a_turn_of_ab_is_half_a_turn_of_dc(
    ad: float, ab: float, phi: float, psi: float
) -> None:
    """B₂ opposite to B₁, turned over about D, lies 2 AD beside B₁: C₁ stands AD beside B₁ on the ray."""
    problem = drag_link(ad, ab, 1.0, phi, psi)
    assert verdicts(problem) == ["VALID"]
    solution = problem.solve(by="exact")
    assert solution.answers["CD"].drawn == pytest.approx(ab * cos(radians(phi)) / cos(radians(psi)))
    assert not half_a_turn(solution)


def test_where_no_datum_alone_can_be_changed_the_conclusion_says_so_and_none_can() -> None:
    data = {"ad": 47.0, "ab": 104.0, "k": 1.62, "phi": 87.0, "psi": 86.0}
    ended = drag_link(**data).solve(by="exact").construction.conclusion
    assert ended is not None and "alone, none was found" in ended.en and "单独改变 $φ_1$" in ended.zh
    tried = {
        "ad": (0.5 * n for n in range(1, 400)), "ab": (n for n in range(1, 400)), "phi": range(360),
        "psi": range(360), "k": (1 + n / 50 for n in range(1, 250)),
    }  # fmt: skip
    for key, values in tried.items():
        for value in values:
            design = drag_link(**data | {key: float(value)}).design
            with suppress(AssemblyError):
                assert all(one.verdict is not Verdict.VALID for one in linkages(design)), (key, value)


def dead_centre(ad: float, cd: float, psi_1: float, psi_2: float, phi: float) -> vecpoly.Problem:
    """A dead centre by its data (mm, deg)."""
    data = {"AD": f"{ad} mm", "CD": f"{cd} mm", "psi_1": f"{psi_1} deg", "psi_2": f"{psi_2} deg"}
    data["phi_12"] = f"{phi} deg"
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": "dead-centre", "data": data, "find": ["AB", "BC"]})


def test_a_dead_centre_that_ab_reaches_by_the_short_way_alone_is_rejected_for_the_long_way() -> None:
    """A double rocker: AB has two ranges, and by +329° it would have to leave them."""
    assert verdicts(dead_centre(90, 50, 100, 40, 329)) == ["BRANCH"]
    assert verdicts(dead_centre(90, 50, 100, 40, -31)) == ["VALID"]
    assert verdicts(dead_centre(100, 60, 125, 75, 220)) == verdicts(dead_centre(100, 60, 125, 75, -140)) == ["VALID"]
    ended = dead_centre(90, 50, 100, 40, 329).solve(by="exact").construction.conclusion
    assert ended is not None and "$φ_{12}$ may be 9.749 to 278.1 deg" in ended.en


def test_a_dead_centre_whose_crank_vanishes_has_both_its_pins_in_a() -> None:
    (one,) = dead_centre(50, 30, 0, 0, 125).solve(by="exact").construction.candidates
    assert one.verdict == "NO_LINK" and max(abs(one.pins[b] - one.pins["A"]) for b in ("B1", "B2")) < 1e-9


@pytest.mark.parametrize("by", ["exact", "drafting"])
def test_a_dead_centre_that_starts_beside_the_end_of_its_range_is_moved_with_the_lengths_as_read(by: str) -> None:
    (moved,) = dead_centre(90, 50, 100, 40, -31).solve(by=by).verification
    assert moved.broken is None and not moved.full


@settings(max_examples=often(20))
@given(st.integers(50, 150), st.integers(30, 100), st.integers(0, 180), st.integers(0, 180), st.integers(-355, 355))
def test_a_dead_centre_is_taken_where_ab_leads_its_rocker_there_and_nowhere_else(
    ad: int, cd: int, psi_1: int, psi_2: int, phi: int
) -> None:
    try:
        solution = vecpoly.solve(dead_centre(ad, cd, psi_1, psi_2, phi), by="exact", repeats=0)
    except AssemblyError:
        return  # the bisector is parallel to the line AC₂
    assert not rests(solution)
