"""Claims about damage: no damaged file ends in a traceback or a hang, no killed run spoils a file."""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from tests.fuzz.__main__ import SLOW, _file, _table_file
from tests.fuzz.classes import FILES, damaged_classes, of_class
from tests.fuzz.commands import commands, of_command, printed, spoilt
from tests.fuzz.files import damaged_files, damaged_tables
from tests.fuzz.kills import killed
from tests.fuzz.outcome import End, Outcome
from tests.fuzz.workers import Worker, outcomes
from tests.laws import often

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="processes of another kind")


def test_no_damaged_problem_file_ends_in_a_traceback_or_a_hang(tmp_path: Path) -> None:
    ends, count = Counter[End](), often(30, 3000)
    for path, outcome in outcomes(_file, damaged_files(np.random.default_rng(3), count, tmp_path / "p.yaml")):
        ends[outcome.end] += 1
        assert outcome.end in (End.SOLVED, End.REFUSED), f"{outcome.said}\n{Path(path).read_text('utf-8', 'replace')}"
    assert ends[End.SOLVED] >= count / 15 and ends[End.REFUSED] > count / 3.75


def test_no_damaged_table_ends_in_a_traceback_or_a_hang(tmp_path: Path) -> None:
    ends: Counter[End] = Counter()
    for path, outcome in outcomes(_table_file, damaged_tables(np.random.default_rng(7), 40, tmp_path)):
        ends[outcome.end] += 1
        assert outcome.end in (End.SOLVED, End.REFUSED), f"{outcome.said}\n{path}"
    assert ends[End.SOLVED] and ends[End.REFUSED] > 10


def test_no_command_line_ends_in_a_traceback_or_spoils_a_file() -> None:
    """Commands, options and values by lot, in a folder with files that are and files that are none."""
    ends = Counter[End]()
    for line, outcome in outcomes(of_command, commands(np.random.default_rng(11), often(16, 800)), SLOW):
        ends[outcome.end] += 1
        assert outcome.end in (End.SOLVED, End.REFUSED), f"{outcome.said}\nvecpoly {line}"
    assert ends[End.SOLVED] and ends[End.REFUSED]


def test_no_damaged_file_of_a_class_ends_in_a_traceback_or_loses_a_student() -> None:
    """Rosters, profiles, registers, answers, rules, marks and drawings, as the commands of a class read them."""
    ends, count = Counter[End](), often(2 * len(FILES), 1500)
    for task, outcome in outcomes(of_class, damaged_classes(np.random.default_rng(31), count), SLOW):
        ends[outcome.end] += 1
        assert outcome.end in (End.SOLVED, End.REFUSED), f"{outcome.said}\n{task}"
    assert ends[End.SOLVED] > count / 10 and ends[End.REFUSED] > count / 10


def test_what_a_command_spoils_is_seen(tmp_path: Path) -> None:
    """A file that was given and is changed, an empty one, one left behind: the judge of commands tells of each."""
    (tmp_path / "given.yaml").write_text("id: x")
    before = printed(tmp_path)
    assert not spoilt(tmp_path, before, 0)
    (tmp_path / "empty.pdf").touch()
    assert spoilt(tmp_path, before, 0) == "empty.pdf is empty"
    (tmp_path / "empty.pdf").unlink()
    (tmp_path / "tmp1").write_text("x")
    assert spoilt(tmp_path, before, 0) == "tmp1 was left behind"
    (tmp_path / "given.yaml").write_text("id: y")
    assert spoilt(tmp_path, before, 0) == "given.yaml was overwritten"


def test_a_killed_run_leaves_whole_files_or_none(tmp_path: Path) -> None:
    rng, early = np.random.default_rng(24), 0  # a second after the start, where files are about to be written
    for n in range(often(2)):
        (tmp_path / str(n)).mkdir()
        kill = killed(rng, tmp_path / str(n))
        early += kill.early
        assert not kill.wrong
    assert early


def _naps(task: str) -> Outcome:
    time.sleep(float(task))
    return Outcome(End.SOLVED)


def _counts(task: str) -> Outcome:
    sum(range(int(float(task))))
    return Outcome(End.SOLVED)


def test_a_task_that_sleeps_too_long_is_a_hang_and_the_next_is_done() -> None:
    worker = Worker(_naps)
    assert [worker.outcome(task, 1.0).end for task in ("30", "0")] == [End.HANG, End.SOLVED]
    worker.close()


def test_a_task_that_counts_too_long_is_a_hang_and_the_next_is_done() -> None:
    worker = Worker(_counts, 0.2)
    assert [worker.outcome(task).end for task in ("1e12", "1")] == [End.HANG, End.SOLVED]
    worker.close()
