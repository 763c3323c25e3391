"""What takes its time says so on stderr where a person watches, and nothing where none does."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

pty = pytest.importorskip("pty")

COMMAND = [sys.executable, "-m", "vecpoly", "check", "3-12", "v_D=0.4", "--lang", "en"]


def test_checking_answers_tells_a_watcher_that_it_is_at_work() -> None:
    ours, theirs = pty.openpty()
    done = subprocess.run(COMMAND, stdout=subprocess.PIPE, stderr=theirs, stdin=subprocess.DEVNULL, check=False)
    os.close(theirs)
    told = os.read(ours, 1 << 16).decode()
    os.close(ours)
    assert done.returncode == 1 and b"wrong" in done.stdout
    assert "trying the usual mistakes" in told


def test_checking_answers_writes_nothing_beside_them_where_nobody_watches() -> None:
    done = subprocess.run(COMMAND, capture_output=True, check=False)
    assert done.returncode == 1 and b"wrong" in done.stdout and not done.stderr
