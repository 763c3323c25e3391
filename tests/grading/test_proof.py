"""The grader against a few hundred simulated students; `python -m tests.grader_proof` has thousands."""

from __future__ import annotations

import pytest

from tests.grader_proof.__main__ import BARS, prove
from tests.laws import few, often

FEW = ("pencil: whole sheets accepted", "pencil: quantities accepted", "pencil: accused of a slip",
       "single slips caught",
       "another student's sheet accepted", "follow-through lowered a mark")  # fmt: skip


@pytest.mark.parametrize("name", few(["3-9", "4-3a", "5-2", "3-2"], 4))
def test_right_work_is_accepted_slips_are_caught_and_no_other_sheet_passes(name: str) -> None:
    total, _ = prove(name, often(20))
    for claim in FEW:
        if claim in total.of:
            bar, share = BARS[claim], total.share(claim)
            assert share >= bar[1] if bar[0] == ">=" else share <= bar[1], (claim, share)
    assert total.share("single slips named rightly") >= 0.9  # of so few
    assert total.share("uncatalogued errors caught") >= 0.95
