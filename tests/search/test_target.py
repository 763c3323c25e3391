"""The path of a point beside the curve that it should run along."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from vecpoly.board.acts import Compute, Curve
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Role
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.errors import ProblemFileError
from vecpoly.search.path import distance

TEXT = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [70 mm, 0 mm]}
links:
  1: {AB: 25 mm}
  2: {BC: 60 mm, E: {along: BC, at: 30 mm, left: 40 mm}}
  3: {DC: 55 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C left of BD]
find: [v_E]
"""
TARGET = "target: {point: E, through: [[20 mm, 60 mm], [35 mm, 62 mm], [5 mm, 30 mm], [0 mm, 45 mm]], closed: yes}\n"


def test_the_path_is_thin_the_curve_dashed_and_the_greatest_distance_is_that_of_the_cycle() -> None:
    solution = vecpoly.loads(TEXT + TARGET).solve(by="exact")
    curves = [act for act in solution.construction.acts if isinstance(act, Curve)]
    path, given = curves
    assert (path.role, given.role) == (Role.CONSTRUCTION, Role.HIDDEN)
    assert len(given.points) == 5 and given.points[0] == given.points[-1]
    exact = np.asarray(cycle(vecpoly.loads(TEXT), 3601).column("p_E"), np.complex128)
    worst = max(distance(exact, at) for at in (0.02 + 0.06j, 0.035 + 0.062j, 0.005 + 0.03j, 0.045j))
    (read,) = [act for act in solution.construction.acts if isinstance(act, Compute) and act.key == "δ_max"]
    assert read.value == pytest.approx(worst, rel=0.01)


def test_it_leaves_the_answers_alone() -> None:
    plain, traced = (vecpoly.loads(text).solve(by="exact").answers["v_E"] for text in (TEXT, TEXT + TARGET))
    assert traced.drawn == pytest.approx(plain.drawn, rel=1e-12)


def test_a_mechanism_that_does_not_turn_right_round_has_its_path_in_pieces() -> None:
    short = TEXT.replace("AB: 25", "AB: 60").replace("BC: 60", "BC: 45")
    acts = vecpoly.loads(short + TARGET).solve(by="exact").construction.acts
    assert [act.role for act in acts if isinstance(act, Curve)].count(Role.HIDDEN) == 1
    figure = vecpoly.loads(short + TARGET).solve(by="exact").construction.figures[0]
    assert figure.view is View.MECHANISM


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("{point: F, through: [[0 mm, 0 mm], [1 mm, 0 mm], [2 mm, 1 mm]]}", "no moving link carries a point 'F'"),
        ("{point: E, through: [[0 mm, 0 mm]]}", "target.through"),
    ],
)
def test_a_target_that_cannot_be_drawn_is_refused(target: str, said: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        vecpoly.loads(f"{TEXT}target: {target}\n")
    assert said in refused.value.words.en


def test_what_a_search_finds_for_a_path_has_its_curve_on_the_sheet() -> None:
    from vecpoly.search.run import run
    from vecpoly.search.spec import load_search
    from vecpoly.words import Words

    search, _, _ = load_search("problems/search-path.yaml")
    found = run(search, "t", Words.same("t"), count=2000, seed=1).problem
    assert found.target is not None and found.target.point == "E" and found.target.closed
    assert len(found.target.through) == 12


def test_how_far_a_point_lies_from_a_path_is_to_its_nearest_side_or_to_its_end() -> None:
    path = np.array([0, 2, 2 + 3j])
    assert [distance(path, z) for z in (1 + 1j, 3 + 1j, -3 + 0j, 2 + 5j, 5 + 7j)] == pytest.approx([1, 1, 3, 2, 5])
