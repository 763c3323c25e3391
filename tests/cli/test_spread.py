"""Reports by several processes: the same bytes, each refusal in its place, and the rest is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from vecpoly.cli.app import app
from vecpoly.errors import AssemblyError, VecpolyError
from vecpoly.foundation.running.spread import spread
from vecpoly.words import Words

LONG = """
id: too-short
title: t
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 20 mm}, 3: {DC: 30 mm}}
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
branch: [C left of BD]
find: [omega_3]
"""


def halved(number: int) -> int:
    if number % 2:
        raise AssemblyError(Words("奇数", "odd"), code="odd", numbers={"number": number})
    return number // 2


@pytest.mark.parametrize("jobs", [1, 2])
def test_results_come_in_their_turn_and_so_do_refusals(jobs: int) -> None:
    found: list[int | str] = []
    for done in spread(halved, [2, 3, 4, 5, 6], jobs):
        try:
            found.append(done())
        except VecpolyError as error:
            found.append(f"{error} {dict(error.faults[0].numbers)['number']}")
    assert found == [1, "odd 3", 2, "odd 5", 3]


def test_two_processes_write_the_bytes_of_one_and_a_bad_file_stops_no_other(tmp_path: Path) -> None:
    bad = tmp_path / "bad.yaml"
    bad.write_text(LONG, encoding="utf-8")
    said = []
    for jobs in ("1", "2"):
        words = ["report", "2-9", str(bad), "5-1", "-o", f"{tmp_path / jobs}/", "--jobs", jobs]
        done = CliRunner().invoke(app, words)
        assert done.exit_code == 2
        said.append(done.stderr.replace(f"{tmp_path / jobs}", ""))
    assert said[0] == said[1] and "bad.yaml, line " in said[0]
    written = [{path.name: path.read_bytes() for path in (tmp_path / jobs).iterdir()} for jobs in ("1", "2")]
    assert written[0] == written[1] and len(written[0]) == 2
