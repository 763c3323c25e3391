"""A linkage that reading off the paper makes another of is told so, and is not gone on with; what a datum had to be is
sought on both sides of zero."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import vecpoly
from vecpoly.check.designs.admissible import admissible
from vecpoly.check.designs.found_words import told as told_of
from vecpoly.cli.app import app
from vecpoly.cli.errors import REFUSED
from vecpoly.designs.base import Design
from vecpoly.errors import NotAskedError

NARROW = """
id: narrow
title: narrow
synthesis: crank-rocker
data: {{K: 1.3, CD: 80 mm, swing: 120 deg, best: gamma_min, take: {take}}}
find: [AB, BC, AD]
"""


def test_a_linkage_that_as_read_cannot_turn_is_told_so_with_the_lengths_that_turn() -> None:
    good, spoilt = vecpoly.loads(NARROW.format(take=2)).solve().verification
    assert good.spoilt is None and good.full
    assert spoilt.spoilt is not None and not spoilt.full
    line = told_of(spoilt, alone=False)
    assert "with those read it is not" in line.en and "l_{AB}$ = 68.77" in line.en and "不能按量得值采用" in line.zh
    assert "spoilt" in spoilt.as_json() and "spoilt" not in good.as_json()


def test_it_is_not_gone_on_with_unless_by_the_exact_hand() -> None:
    problem = vecpoly.loads(NARROW.format(take=2))
    with pytest.raises(NotAskedError, match=r"cannot be gone on with.*0\.03\d* mm.*--hand exact") as refused:
        _ = problem.solve().linkage
    assert refused.value.code == "spoilt"
    bars = {one.name for one in problem.solve(by="exact").linkage.mechanism.links}
    assert {"1", "2", "3"} <= bars
    assert vecpoly.loads(NARROW.format(take=1)).solve().linkage.id == "narrow-1"


def test_the_command_says_the_same(tmp_path: Path) -> None:
    file = tmp_path / "narrow.yaml"
    file.write_text(NARROW.format(take=2), encoding="utf-8")
    done = CliRunner().invoke(app, ["solve", str(file), "--then", "analyse", "--lang", "en"])
    assert done.exit_code == REFUSED and "l_AB = 68.77" in done.output and "$" not in done.output


@pytest.mark.parametrize("phi", [147, -147])
def test_a_turn_in_the_other_sense_is_offered_where_none_in_the_given_one_serves(phi: int) -> None:
    text = """
id: other
title: other
synthesis: dead-centre
data: {AD: 116 mm, CD: 70 mm, psi_1: FIRST deg, psi_2: SECOND deg, phi_12: PHI deg}
find: [AB, BC]
"""
    first, second = (162, 243) if phi > 0 else (-162, -243)
    filled = text.replace("PHI", str(phi)).replace("FIRST", str(first)).replace("SECOND", str(second))
    design = vecpoly.loads(filled).design
    assert isinstance(design, Design)
    told = admissible(design)
    assert told is not None and (f"{-140.3 * phi / 147:.1f}" in told.en or f"{-78.3 * phi / 147:.1f}" in told.en)
    served = vecpoly.loads(filled.replace(f"phi_12: {phi}", f"phi_12: {-100 * phi // 147}")).solve(by="exact")
    assert any(one.reason is None for one in served.construction.candidates)
