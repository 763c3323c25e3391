"""Which test calls which function: found once by running all tests and listening to every call.

A result that the tests keep counts for the test that computed it, so `Touched.chosen` also takes the other tests of such a file. Where files are
named, nothing is kept from one test to the next.
"""

from __future__ import annotations

import functools
import gc
import json
import sys
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
MAP = ROOT / "out" / "mutants.json"
_HOUSE = str(ROOT / "vecpoly")


class Listener:
    """A plugin of pytest that keeps, for each test, the functions of the program that were called, and how long it took."""

    def __init__(self, forgetful: bool) -> None:
        self.forgetful = forgetful
        self.calls: dict[str, set[str]] = defaultdict(set)
        self.seconds: dict[str, float] = defaultdict(float)
        self._now: set[tuple[str, str]] = set()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        self._now = set()
        if self.forgetful:
            forget()
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


def forget() -> None:
    """Empty everything that functions keep of their results."""
    for kept in (thing for thing in gc.get_objects() if isinstance(thing, functools._lru_cache_wrapper)):
        kept.cache_clear()


def listen(*files: str) -> None:
    """Run these test files (all, where none is named) and write what they call into the map."""
    listener = Listener(forgetful=bool(files))
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


@dataclass(frozen=True, slots=True)
class Touched:
    """Which tests call a function, and how many seconds each took."""

    calls: dict[str, list[str]]
    seconds: dict[str, float]

    def chosen(self, path: str, function: str, budget: float) -> tuple[str, ...]:
        """The tests that call the function (or anything in its file), quickest first, then their neighbours, within so many seconds."""
        here = self.calls.get(f"{path}:{function}") or sorted({test for place, tests in self.calls.items() if place.startswith(f"{path}:") for test in tests})
        files, known = {test.split("::")[0] for test in here}, set(here)
        near = [test for test in self.seconds if test.split("::")[0] in files and test not in known]
        taken, spent = [], 0.0
        for test in [*sorted(here, key=self._took), *sorted(near, key=self._took)]:
            spent += self._took(test)
            if spent > budget and taken:
                break
            taken.append(test)
        return tuple(taken)

    def _took(self, test: str) -> float:
        return self.seconds.get(test, 1.0)


def touched() -> Touched:
    """The map as it was written."""
    data = json.loads(MAP.read_text(encoding="utf-8"))
    return Touched(data["calls"], data["seconds"])
