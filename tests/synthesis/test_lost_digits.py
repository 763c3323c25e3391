"""Data of a design so near to a limiting case that nothing is left of a value are refused; others keep their digits."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from tests.each import Later, each
from tests.laws import few
from vecpoly import loads
from vecpoly.check.nudged import nudged_data
from vecpoly.check.precision import PLENTY, digits, noise, sizes
from vecpoly.check.truth import truth_of
from vecpoly.designs.base import Design
from vecpoly.errors import DeadPointError
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.solution import solve

DESIGNS = Later(lambda: few([e.id for e in library() if isinstance(load(e.id).subject, Design)], 5))
HARDLY = """
id: hardly
title: t
synthesis: crank-rocker
data: {{K: {K}, CD: 56 mm, swing: 44 deg, AB: 8 mm}}
find: [BC, AD, gamma_min]
"""


def test_a_transmission_angle_of_which_rounding_leaves_nothing_is_refused_with_the_data() -> None:
    with pytest.raises(
        DeadPointError, match=r"gamma_min: the data are so near to a limiting case.*choose other data"
    ) as told:
        solve(loads(HARDLY.format(K="1.00000000001")), by="exact", repeats=0)
    assert told.value.code == "precision.lost"


def test_a_range_is_sought_past_data_for_which_a_lies_in_a_limit_position() -> None:
    data = "{C1: '(0, 0) mm', C2: '(57, 0) mm', line_1: 284 deg, line_2: 256 deg, alpha_1: 22 deg}"
    text = f"id: t\ntitle: t\nsynthesis: limit-lines\ndata: {data}\nfind: [AB]"
    ended = solve(loads(text), by="exact", repeats=0).construction.conclusion
    assert ended is not None


def test_where_the_drawing_alone_loses_it_it_is_suspect() -> None:
    solution = solve(loads(HARDLY.format(K="1.0000001")), by="exact", repeats=0)
    assert solution.construction.warning is not None and solution.answers["gamma_min"].suspect


@each(DESIGNS)
def test_every_design_of_the_library_keeps_its_digits(name: str) -> None:
    problem = load(name)
    truth = truth_of(problem)
    size = sizes(problem, truth)
    off = noise(problem, truth, size)
    assert all(digits(off[key], size[key]) >= PLENTY for key in off), off


@each(DESIGNS)
def test_nudged_data_are_the_data_but_for_their_last_places(name: str) -> None:
    design = load(name).design
    near = nudged_data(design, np.random.default_rng(1))
    assert near != design and type(near) is type(design)
    assert near.given() == design.given()


def test_the_least_angle_of_links_ten_thousand_times_the_frame_keeps_its_digits() -> None:
    data = {"AD": "20 mm", "AB": "60 mm", "K": "1.34", "phi_1": "347 deg", "psi_1": "49 deg"}
    found = vecpoly.problem({"id": "t", "title": "t", "synthesis": "drag-link", "data": data, "find": ["gamma_min"]})
    answer = solve(found, by="exact", repeats=0).answers["gamma_min"]  # by a cosine of nearly 1 it was 10⁻⁸ of it off
    assert answer.drawn == pytest.approx(answer.exact, rel=1e-10)
    assert answer.exact == pytest.approx(0.007100280226, rel=1e-10)
