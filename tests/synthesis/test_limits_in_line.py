"""A limit position in the line of AD is the bound of the forbidden arc: a dead point, whoever judges."""

from __future__ import annotations

from cmath import rect

from hypothesis import given
from hypothesis import strategies as st

from tests.synthesis.inversion import posed
from vecpoly import solve
from vecpoly.designs.verdict import Verdict
from vecpoly.methods.synthesis.limits import judged as drawn
from vecpoly.oracle.synthesis import four_bar as exact

angles = st.floats(-3.1, 3.1)


@given(turn=angles, swing=st.floats(0.2, 2.8), frame=st.floats(0.3, 3.0), which=st.booleans())
def test_a_limit_on_ad_is_rejected_by_hand_and_by_formula_however_the_figure_lies(
    turn: float, swing: float, frame: float, which: bool
) -> None:
    way, d = rect(1.0, turn), rect(40.0, 1.0)
    on_it, other = d + 25.0 * way, d + 25.0 * way * rect(1.0, swing)
    a = d - 25.0 * frame * way
    ends = (on_it, other) if which else (other, on_it)
    assert drawn.judged(a, d, *ends) is exact.judged(a, d, *ends) is Verdict.OPPOSITE


def test_such_a_task_is_refused_with_the_range_of_its_angle() -> None:
    data = {"C1": "(0, 0) mm", "line_1": "301 deg", "C2": "(23, 23) mm", "line_2": "278 deg", "alpha_1": "39 deg"}
    said = solve(posed("limit-lines", **data)).construction.conclusion
    assert said is not None and "$α_1$ may be 39.01 to 89.99 deg" in said.en
    assert solve(posed("limit-lines", **{**data, "alpha_1": "39.01 deg"})).answers["AB"].exact > 0
