"""Positions beside a dead point: drawing and closed solution judge alike, and where they do not it is told."""

from __future__ import annotations

from typing import Any

import pytest

from tests.synthesis.inversion import posed
from vecpoly import solve
from vecpoly.methods.synthesis import plan
from vecpoly.methods.synthesis.draft import Draft
from vecpoly.methods.synthesis.inversion import judged

LONG = {"AB": "34 mm", "AD": "81 mm", "pairs": ["23 deg -> 102 deg", "54 deg -> 136 deg", "88 deg -> 151 deg"]}
NEAR = {"AB": "58 mm", "AD": "101 mm", "pairs": ["1 deg -> 39 deg", "40 deg -> 33 deg", "78 deg -> 19 deg"]}


@pytest.mark.parametrize("data", [LONG, NEAR], ids=["bars of 44 m", "0.006 deg beside it"])
def test_a_branch_defect_is_seen_on_paper_as_in_the_closed_solution(data: dict[str, Any]) -> None:
    found = solve(posed("angle-pairs", **data), by="exact", repeats=0).construction
    assert found.warning is None and found.conclusion is not None
    assert "branch defect" in found.conclusion.en


def test_a_solution_that_is_on_paper_alone_gives_no_lengths_and_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judged, "DEAD", 1e-2)
    plan._ideal.cache_clear()  # the sketch of another test was judged by the other bound
    found = solve(posed("angle-pairs", **NEAR), by="exact", repeats=0)
    assert found.suspect and not {"BC", "CD", "delta_C"} & set(found.answers)
    assert found.construction.warning is not None
    assert "are not those of the closed solution" in found.construction.warning.en


def test_a_drawing_that_finds_nothing_where_the_closed_solution_rejects_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    data = {"K": "1.5", "CD": "75 mm", "AD": "100 mm", "ADC": "135 deg"}
    monkeypatch.setattr(Draft, "candidate", lambda *_, **__: None)
    plan._ideal.cache_clear()
    found = solve(posed("crank-rocker", **data), by="exact", repeats=0)
    assert found.suspect and "AB" not in found.answers
    plan._ideal.cache_clear()
