"""Class III groups drawn by special points: what is drawn, what is told, which assembly is meant, what is refused."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.laws import few
from vecpoly import load, oracle, solve
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import Figure, Step, View
from vecpoly.board.paper.marks import ImageOf, Point
from vecpoly.errors import EquationError
from vecpoly.names import At, Kind, Rel
from vecpoly.solution import Solution
from vecpoly.vector.equation import Equation, Term
from vecpoly.words import Words

PLATE, SLIDES, GEAR = "three-legged-plate", "class-iii-slides", "stephenson-valve-gear"


def exact(name: str) -> Solution:
    return solve(load(name), by="exact", repeats=0, precise=False)


def figure(solution: Solution, view: View) -> Figure:
    return next(f for f in solution.construction.figures if f.view is view)


def spot(shown: Figure, label: str) -> complex:
    return next(m.at for m in shown.marks if isinstance(m, Point) and m.label == label)


def tables(solution: Solution) -> list[tuple[str, ...]]:
    return [step.equation.symbols for step in solution.construction.steps if step.equation is not None]


def told(solution: Solution, what: str) -> Step:
    return next(step for step in solution.construction.steps if what in step.words.en)


def sine(u: complex, v: complex) -> float:
    return abs((u.conjugate() * v).imag) / abs(u) / abs(v)


# -- the construction
# ---------------------------------------------------------------------------------------------------


def test_the_special_point_lies_on_the_lines_of_the_two_legs() -> None:
    solution = exact(PLATE)
    shown = figure(solution, View.MECHANISM)
    s = spot(shown, "S")
    for outer, inner in (("D", "E"), ("B", "C")):
        assert sine(s - spot(shown, outer), spot(shown, inner) - spot(shown, outer)) < 1e-9
    assert (
        "the line $DE$ of link 4 and the line $BC$ of link 2 meet at $S$"
        in told(solution, "Take a special point").words.en
    )
    assert "特殊点法" in told(solution, "Take a special point").words.zh


def test_the_special_point_of_a_slide_lies_on_its_normal() -> None:
    shown = figure(exact(SLIDES), View.MECHANISM)
    s, e = spot(shown, "S"), spot(shown, "E")
    assert s.real == pytest.approx(e.real, abs=1e-9)  # the guide of E is horizontal
    assert sine(s - spot(shown, "B"), spot(shown, "C") - spot(shown, "B")) < 1e-9


def test_every_equation_has_its_table_and_the_parallel_unknowns_count_as_one() -> None:
    solution = exact(PLATE)
    assert tables(solution) == [
        ("v_{S3}", "(v_{E} + v_{S3E})", "v_{B}", "(v_{CB} + v_{S3C})"),
        ("v_{F}", "v_{S3}", "v_{FS3}"),
        (
            "a_{S3}",
            "a^n_{E}",
            "a^n_{S3E}",
            "(a^t_{E} + a^t_{S3E})",
            "a_{B}",
            "a^n_{CB}",
            "a^n_{S3C}",
            "(a^t_{CB} + a^t_{S3C})",
        ),
        ("a_{F}", "a^n_{F}", "a^t_{F}", "a_{S3}", "a^n_{FS3}", "a^t_{FS3}"),
    ]
    table = next(step.equation for step in solution.construction.steps if step.equation is not None)
    assert [d.en for d in table.directions] == ["?", "⊥$ DE$", "⊥$ AB$", "⊥$ BC$"]
    assert table.magnitudes == ("?", "?", "$ω_1 l_AB$", "?")


@pytest.mark.parametrize("view", [View.VELOCITY, View.ACCELERATION])
def test_the_image_of_the_central_link_is_similar_to_it_and_keeps_its_letter_order(view: View) -> None:
    solution = exact(PLATE)
    shown, drawn, prime = (
        figure(solution, View.MECHANISM),
        figure(solution, view),
        "′" if view is View.ACCELERATION else "",
    )
    link = [spot(shown, letter) for letter in "CEF"]
    image = [spot(drawn, f"{letter}^{prime}" if prime else letter) for letter in "cef"]
    assert (image[2] - image[0]) / (image[1] - image[0]) == pytest.approx(
        (link[2] - link[0]) / (link[1] - link[0]), rel=1e-9
    )
    assert sum(isinstance(m, ImageOf) for m in drawn.marks) == 2


def test_a_slide_on_the_central_link_has_a_coriolis_term_with_its_own_turning() -> None:
    solution = exact(SLIDES)
    assert ("a_{H3}", "a_{H5}", "a^k_{H3H5}", "a^r_{H3H5}", "a_{S3}", "a^n_{H3S3}", "a^t_{H3S3}") in tables(solution)
    answers = solution.answers
    assert answers["ak_H3H5"].drawn == pytest.approx(
        2 * abs(answers["omega_3"].drawn) * answers["v_H3H5"].drawn, rel=1e-9
    )


@pytest.mark.parametrize("name", few([PLATE, SLIDES, GEAR], 2))
def test_the_library_s_class_iii_machines_are_drawn_as_they_are(name: str) -> None:
    answers = exact(name).answers
    assert len(answers) > 10
    for key, one in answers.items():
        assert one.drawn == pytest.approx(one.exact, rel=1e-9, abs=1e-9 * abs(one.exact)), key


def test_the_name_of_a_measured_length_has_its_indices() -> None:
    lines = [plain(line) for step in exact(SLIDES).construction.steps for line in step.formulas]
    assert any("s_3h_3" in line for line in lines)


def test_no_step_has_a_word_of_the_other_language() -> None:
    for name in (PLATE, SLIDES, GEAR):
        for step in exact(name).construction.steps:
            plain = re.sub(r"\$[^$]*\$", "", step.words.zh)
            assert not re.search(r"[a-z]{4,}", plain), plain
            assert not re.search(r"[一-鿿]", step.words.en), step.words.en


# -- sums of parallel unknowns in an equation
# --------------------------------------------------------------------------------


def _term(
    to: str,
    ref: str | None,
    *,
    along: complex | None = None,
    vector: complex | None = None,
    summed: tuple[Rel, ...] = (),
) -> Term:
    rel = Rel(Kind.V, At(to), At(ref) if ref else None)
    return Term(
        rel=rel,
        symbol=f"v_{to}{ref or ''}",
        direction=Words.same("?"),
        magnitude="?",
        along=along,
        vector=vector,
        summed=summed,
    )


def test_a_summed_term_bridges_the_way_that_its_vectors_make() -> None:
    parts = Rel(Kind.V, At("C"), At("B")), Rel(Kind.V, At("S"), At("C"))
    way = (_term("B", None, vector=1 + 0j), _term("S", "B", along=1j, summed=parts))
    other = (_term("S", None, along=1 + 0j, summed=(Rel(Kind.V, At("E")), Rel(Kind.V, At("S"), At("E")))),)
    assert str(Equation(left=way, right=other)) == "v_B + v_SB = v_S"


def test_a_summed_term_with_a_gap_is_refused() -> None:
    parts = Rel(Kind.V, At("C"), At("B")), Rel(Kind.V, At("S"), At("E"))
    with pytest.raises(EquationError):
        Equation(
            left=(_term("B", None, vector=1 + 0j), _term("S", "B", along=1j, summed=parts)),
            right=(_term("S", None, along=1 + 0j),),
        )


# -- machines of the lecturer
# -----------------------------------------------------------------------------------------------


def test_peaucellier_s_point_moves_across_the_line_of_the_pivots() -> None:
    answers = exact("peaucellier").answers
    for key in ("v_P", "a_P"):
        vector = answers[key].drawn_vector
        assert vector is not None and abs(vector.real) < 1e-9 * abs(vector)


def test_the_pantograph_enlarges_every_motion_two_and_a_half_times() -> None:
    answers = exact("pantograph").answers
    for kind in ("v", "a"):
        large, small = (answers[f"{kind}_{point}"].drawn_vector for point in "ED")
        assert large is not None and small is not None and large == pytest.approx(2.5 * small, rel=1e-9)


@pytest.mark.parametrize(("name", "flat", "stride"), [("jansen-leg", 2.5, 60.0), ("klann-leg", 5.0, 95.0)])
def test_a_walking_leg_keeps_its_foot_on_the_ground_for_a_third_of_a_turn(
    name: str, flat: float, stride: float
) -> None:
    foot = 1e3 * np.asarray(oracle.solve(load(name).mechanism, np.radians(np.arange(0, 360, 5))).position("H"))
    down = foot[foot.imag < foot.imag.min() + flat]
    assert len(down) >= 24 and np.ptp(down.real) > stride
