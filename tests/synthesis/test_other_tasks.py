"""Shaper, Whitworth, limit lines, dead centre, drag link, limits of given linkages: cases, motion, refusals."""

from __future__ import annotations

from functools import partial
from math import asin, degrees

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import vecpoly
from tests.laws import few
from vecpoly.errors import AssemblyError, ProblemFileError
from vecpoly.oracle import solve
from vecpoly.oracle.synthesis.registry import linkages

CASES = {
    "shaper": (
        {"K": "1.5", "H": "240 mm", "AC": "160 mm"},
        {"theta": 36.0, "AB": 49.4427191, "CD": 388.3281573, "h": 378.825090881},
    ),
    "whitworth": ({"K": "2", "H": "160 mm", "AC": "60 mm"}, {"AB": 120.0, "CD": 80.0}),
    "limit-lines": (
        {"C1": "(0, 0) mm", "line_1": "270 deg", "C2": "(35, 11) mm", "line_2": "230 deg", "alpha_1": "40 deg"},
        {"AB": 11.869479, "BC": 42.580855, "CD": 34.091672, "AD": 27.557770, "gamma_min": 19.9402, "psi": 65.1056},
    ),
    "dead-centre": (
        {"AD": "100 mm", "CD": "60 mm", "psi_1": "125 deg", "psi_2": "75 deg", "phi_12": "-140 deg"},
        {"AB": 27.486076729, "BC": 101.76495244},
    ),
    "drag-link": (
        {"AD": "25 mm", "AB": "60 mm", "K": "1.5", "phi_1": "275 deg", "psi_1": "180 deg"},
        {"BC": 65.386399983, "CD": 46.279660459, "gamma_min": 30.917032733},
    ),
    "crank-rocker-limits": (
        {"AB": "40 mm", "BC": "125 mm", "CD": "70 mm", "AD": "120 mm"},
        {"theta": 12.96285, "K": 1.155209, "gamma_min": 36.18229},
    ),
    "slider-crank-limits": (
        {"AB": "35 mm", "BC": "100 mm", "e": "28 mm"},
        {"theta": 13.54592, "K": 1.162759, "gamma_min": 50.94988, "H": 73.4043},
    ),
    "guide-bar-limits": (
        {"AB": "54 mm", "AC": "80 mm", "e": "23 mm"},
        {"theta": 97.05848, "K": 3.340408, "gamma_min": 27.79577},
    ),
}


def posed(kind: str, **data: str) -> vecpoly.Problem:
    """A task of synthesis with these data."""
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": kind, "data": data})


@pytest.mark.parametrize("kind", few(tuple(CASES), 2))
def test_what_is_found_is_that_of_the_case(kind: str) -> None:
    data, true = CASES[kind]
    solution = posed(kind, **data).solve(by="exact")
    found = {key: solution.answers[key].drawn for key in true}
    assert found == pytest.approx(true, rel=1e-9 if kind in ("shaper", "dead-centre", "drag-link") else 3e-6)
    assert not solution.suspect and all(one.full for one in solution.verification)


@pytest.mark.parametrize("offset", [{}, {"e": "3 mm"}, {"e": "30 mm"}, {"e": "49 mm"}])
def test_a_guide_bar_is_drawn_with_any_offset_and_moves_as_read(offset: dict[str, str]) -> None:
    """Without one; with less than the crank, as much, and more."""
    solution = posed("guide-bar-limits", AB="30 mm", AC="80 mm", **offset).solve(by="exact")
    (moved,) = solution.verification
    assert not solution.suspect
    assert (moved.ratio, moved.stroke) == pytest.approx(
        tuple(solution.answers[key].drawn for key in ("K", "psi")), rel=1e-6
    )


@pytest.mark.parametrize("kind", ["shaper", "whitworth"])
def test_a_quick_return_that_is_moved_has_its_ratio_and_its_stroke(kind: str) -> None:
    data, _ = CASES[kind]
    (moved,) = posed(kind, **data).solve(by="exact").verification
    assert (moved.ratio, moved.stroke) == pytest.approx((float(data["K"]), float(data["H"][:3])), rel=1e-6)


def test_the_second_d_of_8_5_stays_on_the_sheet_with_its_reason() -> None:
    valid, rejected = vecpoly.load("8-5").solve().construction.candidates
    assert valid.reason is None and rejected.verdict == "OPPOSITE" and rejected.number == 2


def test_the_rocker_of_a_dead_centre_turns_back_there() -> None:
    solution = posed("dead-centre", **CASES["dead-centre"][0]).solve(by="exact")
    pins = solution.construction.candidates[0].pins
    b, c = pins["B2"] - pins["A"], pins["C2"] - pins["A"]
    assert abs((b.conjugate() * c).imag) < 1e-9 * abs(b) * abs(c)


def test_a_dead_centre_of_a_link_that_is_no_crank_is_moved_from_its_first_position() -> None:
    """AB cannot stand at 60°; positions 1 and 2 lie 80° apart, where AB turns by so much while DC turns by 60°."""
    data = {"AD": "120 mm", "CD": "50 mm", "psi_1": "60 deg", "psi_2": "120 deg", "phi_12": "80 deg"}
    solution = posed("dead-centre", **data).solve(by="exact")
    (moved,) = solution.verification
    assert moved.broken is None and not moved.full
    mech = solution.mechanism
    rocker, points = solve(mech, np.array([mech.drive.position])).body("3"), mech.link("3").points
    (dc,) = np.degrees(np.angle(rocker.point(points["C"]) - rocker.point(points["D"])))
    assert dc == pytest.approx(60, abs=1e-9)


@pytest.mark.parametrize(
    ("kind", "change", "told"),
    [
        ("shaper", {"K": "1"}, "K > 1 is needed"),
        ("whitworth", {"AB": "70 mm"}, "just one of AB, AC"),
        ("limit-lines", {"alpha_1": "95 deg"}, "between 0 and 90"),
        ("limit-lines", {"C2": "35, 11 mm"}, "is no given point"),
        ("dead-centre", {"take": "zero"}, "no number of a solution"),
    ],
)
def test_data_that_cannot_be_are_told(kind: str, change: dict[str, str], told: str) -> None:
    with pytest.raises(ProblemFileError, match=told):
        posed(kind, **(CASES[kind][0] | change))


@pytest.mark.parametrize("kind", ["shaper", "drag-link"])
@pytest.mark.parametrize(("below", "inverse"), [("0.8", "1.25"), ("-3", "1.4")])
def test_a_ratio_below_one_is_refused_with_the_one_that_may_be_meant(kind: str, below: str, inverse: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        posed(kind, **(CASES[kind][0] | {"K": below}))
    (fault,) = refused.value.faults
    assert f"write its inverse {inverse}" in fault.words.en and f"请写其倒数 {inverse}" in fault.words.zh
    posed(kind, **(CASES[kind][0] | {"K": inverse}))  # is taken


@pytest.mark.parametrize(
    ("kind", "change", "told"),
    [
        ("shaper", {"DE": "9 mm"}, r"must exceed MN/\(2 cos\(θ/2\)\) = 9\.\d+ mm"),
        ("whitworth", {"DE": "70 mm"}, r"must exceed CD = H/2 = 80 mm"),
        ("whitworth", {"DE": "80 mm"}, r"must exceed CD = H/2 = 80 mm"),
        ("limit-lines", {"line_2": "270 deg"}, "are parallel: no A"),
        ("dead-centre", {"psi_2": "125 deg", "phi_12": "0 deg"}, "bisector is parallel"),
        ("crank-rocker-limits", {"AB": "70 mm", "BC": "126 mm"}, r"AB is no crank: AB \+ l_max = 196 mm, 190 mm"),
        ("slider-crank-limits", {"e": "66 mm"}, r"AB \+ e = 101 mm, BC = 100 mm"),
        ("guide-bar-limits", {"e": "26 mm"}, r"AB \+ e = 80 mm, AC = 80 mm"),
    ],
)
def test_what_cannot_be_found_is_refused_with_the_numbers(kind: str, change: dict[str, str], told: str) -> None:
    with pytest.raises(AssemblyError, match=told):
        posed(kind, **(CASES[kind][0] | change)).solve()


@pytest.mark.parametrize(
    ("kind", "change", "verdict"),
    [
        ("drag-link", {"AD": "80 mm"}, "NO_DOUBLE_CRANK"),
        ("drag-link", {"AD": "50 mm", "AB": "50 mm", "phi_1": "300 deg", "K": "2"}, "NO_DOUBLE_CRANK"),
        ("dead-centre", {"psi_2": "125 deg"}, "NO_LINK"),
    ],
)
def test_what_is_found_and_no_use_is_drawn_with_its_verdict(kind: str, change: dict[str, str], verdict: str) -> None:
    solution = posed(kind, **(CASES[kind][0] | change)).solve(by="exact")
    assert [one.verdict for one in solution.construction.candidates] == [verdict] and not solution.suspect


@given(st.integers(10, 90), st.integers(1, 60), st.sampled_from(["mm", "cm", "m"]))
def test_what_just_reaches_is_refused_however_its_sum_is_rounded(crank: int, more: int, unit: str) -> None:
    """AB + e = BC, AB + e = AC, AB + AD = BC + CD: 44 mm + 26 mm is 70 mm, in metres too."""
    ab, e, both = f"{crank} mm", f"{more} mm", f"{(crank + more) / {'mm': 1, 'cm': 10, 'm': 1000}[unit]!r} {unit}"
    for task, told in (
        (posed("slider-crank-limits", AB=ab, BC=both, e=e), "equals BC: AB can turn right round, but"),
        (posed("guide-bar-limits", AB=ab, AC=both, e=e), "AB is no crank"),
        (
            posed("crank-rocker-limits", AB=ab, BC=both, CD=both, AD=f"{crank + 2 * more} mm"),
            "equals the sum of the others: AB can turn right round, but",
        ),
    ):
        with pytest.raises(AssemblyError, match=told):
            linkages(task.design)


@pytest.mark.parametrize("kind", few(tuple(CASES), 2))
def test_every_linkage_that_was_found_goes_on_to_be_drawn(kind: str) -> None:
    further = vecpoly.solve(posed(kind, **CASES[kind][0]).solve(by="exact").linkage, by="exact", repeats=0)
    assert further.construction.steps and not further.suspect


def test_the_linkage_that_was_found_goes_on_as_a_problem_of_its_own() -> None:
    solution = vecpoly.load("8-16").solve(by="exact")
    assert solution.mechanism.drive.rate == 1.0
    assert solution.linkage.id == "8-16-1" and solution.as_json()["verification"][0]["turns_fully"]


@pytest.mark.parametrize(
    ("kind", "data"),
    [("slider-crank-limits", {"AB": "40 mm", "BC": "110 mm"}), ("guide-bar-limits", {"AB": "50 mm", "AC": "130 mm"})],
)
def test_an_offset_that_is_written_as_zero_is_none(kind: str, data: dict[str, str]) -> None:
    central, written = (posed(kind, **data, **more).solve(by="exact").answers for more in ({}, {"e": "0 mm"}))
    assert {key: one.drawn for key, one in central.items()} == {key: one.drawn for key, one in written.items()}
    with pytest.raises(ProblemFileError, match=r"must not be negative; write 25 mm"):
        posed(kind, **data, e="-25 mm")


def test_a_slider_crank_without_quick_return_is_told_what_it_is() -> None:
    with pytest.raises(ProblemFileError, match="e = 0 and AB = H/2, whatever BC: give BC instead"):
        posed("slider-crank", K="1", H="50 mm", AB="25 mm")


@pytest.mark.parametrize("hand", ["exact", "drafting", "pencil"])
@pytest.mark.parametrize("coupler", [26.0, 90.0, 400.0])
def test_a_central_slider_crank_is_drawn_from_its_stroke_and_its_coupler(hand: str, coupler: float) -> None:
    solution = posed("slider-crank", K="1", H="50 mm", BC=f"{coupler} mm").solve(by=hand)
    (one,) = solution.construction.candidates
    near = pytest.approx if hand == "exact" else partial(pytest.approx, rel=0.05)
    assert one.values["AB"] == near(25.0) and one.values["BC"] == near(coupler) and one.values["e"] == 0
    assert one.values["alpha_max"] == near(degrees(asin(25 / coupler)))
    (moved,) = solution.verification
    assert moved.full and moved.ratio == near(1.0) and moved.stroke == near(50.0)


def test_a_coupler_that_is_shorter_than_half_the_stroke_makes_no_central_slider_crank() -> None:
    for coupler in ("25 mm", "20 mm"):
        with pytest.raises(AssemblyError, match=r"BC may be at least 25\.01 mm"):
            posed("slider-crank", K="1", H="50 mm", BC=coupler).solve()
