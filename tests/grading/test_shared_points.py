"""What one quantity weighs by the usual rubric: no ratio at the end is a third of the problem."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.grading.cases import key_of
from vecpoly.grading.derive.blocks import ACCELERATION, DIAGRAM, FORCE, OTHER, VELOCITY
from vecpoly.grading.derive.rubric import POLYGON, SINGLE, USUAL, Block, Rubric, shared
from vecpoly.grading.key import AnswerKey, Graded, Kind

PARTS = (DIAGRAM, VELOCITY, ACCELERATION, FORCE, OTHER)


def share(key: AnswerKey, name: str) -> float:
    return key[name].points.total / key.worth


@pytest.mark.parametrize(
    ("problem", "name"),
    [("4-3a", "eta"), ("7-2a", "M_r"), ("3-1b", "P_23"), ("class-iii", "v_L"), ("3-3", "omega_ratio_13")],
)
def test_what_is_worked_out_from_others_is_worth_two_points(problem: str, name: str) -> None:
    key = key_of(problem)
    assert 0 < key[name].points.total <= SINGLE and share(key, name) <= 0.25


def test_a_line_that_no_vector_asked_stands_for_is_paid_with_what_is_computed_from_it() -> None:
    key = key_of("geared-five-bar")
    assert {one.key for one in key.quantities if one.asked and one.block == ACCELERATION} >= {"a_C", "alpha_2"}
    assert key["alpha_2"].points.method > 0  # a_CB is not asked
    assert key_of("3-9")["omega_2"].points.method == 0  # v_C2B is


def test_a_centre_at_infinity_is_worth_what_another_is() -> None:
    key = key_of("3-1b")
    assert key["P_23"].kind is Kind.LINE and key["P_23"].points == key["P_13"].points


@st.composite
def quantities(draw: st.DrawFn) -> tuple[Graded, ...]:
    kinds = draw(st.lists(st.sampled_from([one for one in Kind if one is not Kind.READING]), min_size=1, max_size=20))
    parts = draw(st.lists(st.sampled_from(PARTS), min_size=len(kinds), max_size=len(kinds)))
    return tuple(
        Graded(
            key=f"q{n}", symbol="q", kind=kind, unit="", block=part, exact=1.0, asked=True,
            mu=draw(st.sampled_from(["", "mu_v"])),
        )
        for n, (kind, part) in enumerate(zip(kinds, parts, strict=True))
    )  # fmt: skip


@given(quantities())
def test_no_quantity_is_worth_more_than_it_may_and_no_point_of_a_part_is_lost_while_another_has_room(
    asked: tuple[Graded, ...],
) -> None:
    found, _ = shared(USUAL, asked, {})
    for part in {one.block for one in found}:
        here, block = [one for one in found if one.block == part], USUAL.blocks[part]
        most = [
            block.line if one.mu and one.kind is not Kind.SIGNED and one.kind is not Kind.YES_NO else block.single
            for one in here
        ]
        assert all(one.points.total <= bound + 1e-9 for one, bound in zip(here, most, strict=True))
        whole = block.drawn + block.values + block.rates
        assert sum(one.points.total for one in here) == pytest.approx(min(whole, sum(most)))
        assert all(min(one.points.method, one.points.accuracy, one.points.sense) >= 0 for one in here)


@given(quantities())
def test_a_rubric_of_one_s_own_is_shared_out_as_it_says(asked: tuple[Graded, ...]) -> None:
    own = Rubric(blocks={part: Block(drawn=3, values=5, rates=4) for part in PARTS})
    found, _ = shared(own, asked, {})
    for part in {one.block for one in found}:
        assert sum(one.points.total for one in found if one.block == part) == pytest.approx(12)


def test_a_moment_of_areas_stands_for_no_polygon() -> None:
    area = Graded(key="S1", symbol="S_1", kind=Kind.SCALAR, unit="mm^2", block=FORCE, exact=900.0)
    length = Graded(key="OT", symbol="OT", kind=Kind.READING, unit="mm", block=FORCE, exact=40.0)
    moment = Graded(
        key="M", symbol="M", kind=Kind.SCALAR, unit="N·m", block=FORCE, exact=5.0, asked=True, needs=("OT",)
    )
    of_areas = replace(moment, needs=("S1", "OT"))
    assert shared(USUAL, (length, moment), {})[0][1].points.total == POLYGON
    assert shared(USUAL, (area, length, of_areas), {})[0][2].points.total == SINGLE
