"""Class III groups: which assembly is meant, dead points, and what of higher classes is refused."""

from __future__ import annotations

import re

import pytest

from tests.at_once import exactly
from tests.texts import CLASS_III, CLASS_IV
from vecpoly import loads, solve
from vecpoly.board.construction import Step
from vecpoly.board.hand import hand
from vecpoly.errors import AssemblyError, DeadPointError, NoMethodError
from vecpoly.methods.plan import construct
from vecpoly.solution import Solution

TWO_PLATES = """\
id: two-plates
title: two plates hinged together, each on two bars
frame: {A: [0 mm, 0 mm], P: [60 mm, -40 mm], Q: [220 mm, -40 mm], U: [300 mm, 40 mm]}
links:
  1: {AB: 30 mm}
  2: {CD: 60 mm, E: {CE: 80 mm, DE: 70 mm, side: left of CD}}
  3: {BC: 90 mm}
  4: {PD: 100 mm}
  5: {EF: 70 mm, G: {EG: 90 mm, FG: 60 mm, side: left of EF}}
  6: {QF: 100 mm}
  7: {UG: 90 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
find: [v_E]
"""


def told(solution: Solution, what: str) -> Step:
    return next(step for step in solution.construction.steps if what in step.words.en)


# -- which assembly
# -----------------------------------------------------------------------------------------------------


def test_without_a_guess_the_assemblies_are_listed_and_each_of_them_is_taken() -> None:
    text = re.sub(r"guesses: .*\n", "", CLASS_III).replace("phi: 60", "phi: 120")
    with pytest.raises(AssemblyError, match="can be joined in 2 ways") as refused:
        solve(loads(text))
    offers = re.findall(r"\{C: \[[^}]*\}", str(refused.value))
    assert len(offers) == 2 and "有 2 种装配" in refused.value.words.zh
    speeds = {round(exactly(loads(text + f"guesses: {offer}\n")).answers["v_C"].drawn, 6) for offer in offers}
    assert len(speeds) == 2


def test_a_branch_statement_tells_the_assemblies_apart_and_is_told_in_the_step() -> None:
    text = re.sub(r"guesses: .*\n", "", CLASS_III).replace("phi: 60", "phi: 120")
    high, low = (
        solve(loads(text + f"branch: [C {side} E]\n"), by="exact", repeats=0, precise=False)
        for side in ("above", "below")
    )
    assert high.answers["v_C"].drawn != pytest.approx(low.answers["v_C"].drawn)
    assert "$C$ above $E$" in told(high, "by trial").words.en and "$C$ below $E$" in told(low, "by trial").words.en


def test_a_branch_that_no_assembly_fulfils_is_refused() -> None:
    with pytest.raises(AssemblyError, match="fulfils"):
        solve(loads(CLASS_III + "branch: [C below AD]\n"))


def test_a_group_that_cannot_be_joined_is_refused() -> None:
    with pytest.raises(AssemblyError):
        construct(loads(CLASS_III.replace("FG: 120", "FG: 20")), hand("exact"))


# -- dead points, other classes
# --------------------------------------------------------------------------------------------


def test_three_parallel_legs_are_a_dead_point() -> None:
    text = """
id: dead
title: three parallel bars
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm], G: [180 mm, 20 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 80 mm}
  3: {CE: 100 mm, F: {along: CE, at: 180 mm, left: 10 mm}}
  4: {DE: 120 mm}
  5: {GF: 110 mm}
input: {link: 1, phi: 90 deg, omega: 10 rad/s ccw}
guesses: {C: [0 mm, 120 mm], E: [100 mm, 120 mm], F: [180 mm, 130 mm]}
find: [v_C, omega_3]
"""
    with pytest.raises((DeadPointError, AssemblyError)):
        construct(loads(text), hand("exact"))


def test_two_parallel_legs_leave_another_pair_for_the_special_point() -> None:
    text = """
id: parallel
title: two parallel bars
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm], G: [260 mm, 60 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 80 mm}
  3: {CE: 100 mm, F: {along: CE, at: 150 mm, left: 40 mm}}
  4: {DE: 120 mm}
  5: {GF: 148.66 mm}
input: {link: 1, phi: 90 deg, omega: 10 rad/s ccw}
guesses: {C: [0 mm, 120 mm], E: [100 mm, 120 mm], F: [150 mm, 160 mm]}
find: [v_C, v_F, omega_3, a_C, alpha_3]
"""
    for one in exactly(loads(text)).answers.values():
        assert one.drawn == pytest.approx(one.exact, rel=1e-9, abs=1e-9)


def test_class_iv_is_refused_with_the_input_that_would_do() -> None:
    with pytest.raises(
        NoMethodError, match=r"class IV group 2, 3, 4, 5.*with link 5 as the input it can be drawn"
    ) as refused:
        construct(loads(CLASS_IV), hand("exact"))
    assert "若改以构件 5 为原动件" in refused.value.words.zh and refused.value.code == "no-method"


def test_two_central_links_are_refused_by_name() -> None:
    with pytest.raises(NoMethodError, match="is not one central link on three legs"):
        construct(loads(TWO_PLATES), hand("exact"))
