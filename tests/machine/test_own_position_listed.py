"""The table of twelve positions tells of the given position what the steps before it came to."""

from __future__ import annotations

import pytest

import vecpoly
from tests.laws import few


@pytest.mark.parametrize("seed", few([1, 2], 2))
def test_the_given_position_has_one_inertia_and_one_moment(seed: int) -> None:
    solution = vecpoly.load("press-flywheel").solve(by="drafting", seed=seed)
    found = {key: solution.answers[key].drawn for key in ("J_e", "M_e")}
    tables = (step.listing for step in solution.construction.steps if step.listing is not None)
    (table,) = [one for one in tables if one.head[0].en == "$φ$ /°"]
    (row,) = [row for row in table.rows if row[0] == "120"]
    assert [float(cell.replace("−", "-")) for cell in row[1:]] == [
        pytest.approx(found["J_e"], abs=6e-5),
        pytest.approx(found["M_e"], abs=0.06),
    ]
