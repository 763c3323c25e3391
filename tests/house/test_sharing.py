"""Tests that share what they make are run by one worker, one group after the other."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from tests.conftest import pytest_xdist_make_scheduler
from tests.sharing import LONGEST, MADE, group

TESTS = Path(__file__).resolve().parents[1]
FILES = sorted(TESTS.rglob("test_*.py"))


def scheduler(dist: str) -> Any:
    words: Any = SimpleNamespace(rootpath=TESTS.parent, getoption=lambda _: dist, getvalue=lambda _: ["popen"])
    return pytest_xdist_make_scheduler(words, None)


def test_who_imports_from_one_maker_is_handed_to_one_worker() -> None:
    split = scheduler("loadgroup")._split_scope
    ids = ("tests/drawing/test_labels.py::test_x[3-9]", "tests/library/test_drawn_ledger.py::test_y[a::b]")
    assert {split(one) for one in ids} == {"tests.drawn_library"}
    assert split("tests/problem/test_decimal_commas.py::test_z") == "problem/test_decimal_commas"
    assert scheduler("load") is None


@pytest.mark.parametrize("made", MADE)
def test_every_maker_has_several_files(made: str) -> None:
    assert sum(group(file) == made for file in FILES) > 1


def test_those_that_take_longest_are_groups_of_this_suite() -> None:
    assert set(LONGEST) <= {group(file) for file in FILES}
