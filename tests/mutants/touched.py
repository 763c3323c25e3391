"""Which test calls which function: found once by running all tests and listening to every call.

A result that a test file caches is counted for the test that computed it; `chosen` therefore also takes the other tests of such a file.
"""

from __future__ import annotations

import json
import sys
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
MAP = ROOT / "out" / "mutants.json"
_HOUSE = str(ROOT / "vecpoly")


class Listener:
    """A plugin of pytest that keeps, for each test, the functions of the program that were called, and how long it took."""

    def __init__(self) -> None:
        self.calls: dict[str, set[str]] = defaultdict(set)
        self.seconds: dict[str, float] = defaultdict(float)
        self._now: set[tuple[str, str]] = set()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        self._now = set()
        sys.settrace(self._called)
        yield
        sys.settrace(None)
        for path, name in self._now:
            self.calls[f"{Path(path).relative_to(ROOT)}:{name}"].add(item.nodeid)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] += report.duration

    def _called(self, frame: FrameType, _event: str, _arg: Any) -> None:
        code = frame.f_code
        if code.co_filename.startswith(_HOUSE):
            self._now.add((code.co_filename, code.co_qualname))


def listen(*files: str) -> None:
    """Run these test files (all, where none is named) and write what they call into the map."""
    listener = Listener()
    pytest.main(["-q", "-p", "no:xdist", "-p", "no:cacheprovider", *(files or [str(ROOT / "tests")])], plugins=[listener])
    calls, seconds = _kept(files) if files else ({}, {})
    for place, tests in listener.calls.items():
        calls[place] = sorted({*calls.get(place, ()), *tests})
    MAP.parent.mkdir(exist_ok=True)
    MAP.write_text(json.dumps({"calls": calls, "seconds": seconds | listener.seconds}), encoding="utf-8")


def _kept(files: Sequence[str]) -> tuple[dict[str, list[str]], dict[str, float]]:
    """The map without what it says of these files."""
    data = json.loads(MAP.read_text(encoding="utf-8"))
    calls = {place: [test for test in tests if test.split("::")[0] not in files] for place, tests in data["calls"].items()}
    return calls, {test: took for test, took in data["seconds"].items() if test.split("::")[0] not in files}


def chosen(path: str, function: str, budget: float) -> tuple[str, ...]:
    """The tests that call the function (or anything in its file), quickest first, then their neighbours, within so many seconds."""
    data = json.loads(MAP.read_text(encoding="utf-8"))
    calls, seconds = data["calls"], data["seconds"]
    here = calls.get(f"{path}:{function}") or sorted({test for place, tests in calls.items() if place.startswith(f"{path}:") for test in tests})
    files = {test.split("::")[0] for test in here}
    near = [test for test in seconds if test.split("::")[0] in files and test not in set(here)]
    taken, spent = [], 0.0
    for test in [*sorted(here, key=lambda one: float(seconds.get(one, 1.0))), *sorted(near, key=lambda one: float(seconds[one]))]:
        spent += seconds.get(test, 1.0)
        if spent > budget and taken:
            break
        taken.append(test)
    return tuple(taken)
