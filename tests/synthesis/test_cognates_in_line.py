"""Cognates of a four-bar whose point E lies nearly in line with crank or rocker are drawn as surely as any."""

from __future__ import annotations

import pytest

from vecpoly import loads

DATA = "{{AB: 30 mm, BC: 70 mm, CD: {cd}, AD: 70 mm, E: '(38, 32) mm', phi: {phi} deg}}"


@pytest.mark.parametrize(("cd", "phi"), [("30 mm", 40), ("30 mm", 41.5), ("30 mm", 36), ("36 mm", 40)])
def test_no_length_of_a_cognate_is_suspect_where_sides_of_a_parallelogram_meet_flat(cd: str, phi: float) -> None:
    solution = loads(
        f"id: mine\ntitle: mine\nsynthesis: cognates\ndata: {DATA.format(cd=cd, phi=phi)}\nfind: [AG, GH, AF, MN, DF]"
    ).solve()
    assert len(solution.answers) == 5 and not solution.suspect
    for answer in solution.answers.values():
        assert answer.expected_error < 0.03 * answer.exact
