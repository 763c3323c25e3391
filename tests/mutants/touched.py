"""Which test calls which function: found once by running all tests and listening to every call.

What functions keep of their results is forgotten before each file of tests, so that no file lives on what another
computed. Within a file a kept result counts for the test that computed it; `Touched.chosen` therefore also takes the
other tests of such a file. The map is written now and then: a run that was broken off is of use as far as it came.
Seconds are those of the processor, and a test that takes many is broken off too: what it has called by then is known.
"""

from __future__ import annotations

import functools
import gc
import importlib
import json
import pkgutil
import signal
import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from cProfile import Profile
from dataclasses import dataclass
from pathlib import Path
from types import CodeType
from typing import Any

import pytest

import vecpoly

ROOT = Path(__file__).resolve().parents[2]
MAP = ROOT / "out" / "mutants.json"
_SAMPLE = 3  # parameters of a test that are listened to first
_PATIENCE = 1.0  # seconds of the processor after which a test is broken off
_PAUSE = 120.0  # seconds between two times that the map is written: it is large
_BLIND = [
    f"--ignore={ROOT}/tests/{name}.py"
    for name in ("player/test_player_browser", "cli/test_cli_process", "house/test_package", "generated/test_fuzz")
]  # they start other processes, which have no slip
_LATE = ("ezdxf", "matplotlib.pyplot", "openpyxl", "pandas", "scipy.integrate", "scipy.optimize", "scipy.spatial")
_HOUSE = str(ROOT / "vecpoly")


class Listener:
    """A plugin of pytest that keeps, for each test, the functions of the program that were called,
    and how long it took."""

    def __init__(self, write: Callable[[Listener], None], few: bool) -> None:
        self.write, self.few = write, few
        self.calls: dict[str, set[str]] = defaultdict(set)
        self.seconds: dict[str, float] = {}
        self._file = ""
        self._written = time.monotonic()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        if self._turned(item.nodeid.split("::")[0]):
            forget()
        ear = Profile(subcalls=False, builtins=False)
        started = time.process_time()
        ear.enable()
        yield
        ear.disable()
        self.seconds[item.nodeid] = time.process_time() - started
        for code in (entry.code for entry in ear.getstats()):
            if isinstance(code, CodeType) and code.co_filename.startswith(_HOUSE):
                self.calls[f"{Path(code.co_filename).relative_to(ROOT)}:{code.co_qualname}"].add(item.nodeid)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_pyfunc_call(self) -> Iterator[None]:
        signal.setitimer(signal.ITIMER_VIRTUAL, _PATIENCE)
        yield
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """A few parameters of every test first, so that the map soon knows all of the program a little;
        then the others, unless a few do."""
        alike: dict[str, list[pytest.Item]] = defaultdict(list)
        for item in items:
            alike[item.nodeid.split("[")[0]].append(item)
        first = {id(item) for group in alike.values() for item in group[:: max(1, len(group) // _SAMPLE)]}
        items.sort(key=lambda item: id(item) not in first)
        del items[len(first) if self.few else len(items) :]

    def pytest_sessionfinish(self) -> None:
        self.write(self)

    def _turned(self, file: str) -> bool:
        """Whether another file begins; what is known so far is written then, if that is long ago."""
        turned, self._file = file != self._file, file
        if turned and time.monotonic() - self._written > _PAUSE:
            self.write(self)
            self._written = time.monotonic()
        return turned


def awake() -> None:
    """Import every part of the program, and the libraries that it imports late: a test that is broken off in the midst
    of an import would spoil all that come after it."""
    for part in pkgutil.walk_packages(vecpoly.__path__, "vecpoly."):
        importlib.import_module(part.name)
    for library in _LATE:
        importlib.import_module(library)


def keepers() -> list[functools._lru_cache_wrapper[Any]]:
    """All functions that keep their results."""
    gc.unfreeze()  # what conftest.py has set aside is not listed
    return [thing for thing in gc.get_objects() if isinstance(thing, functools._lru_cache_wrapper)]


def forget(known: Sequence[functools._lru_cache_wrapper[Any]] = ()) -> None:
    """Empty everything that functions keep of their results."""
    for kept in known or keepers():
        kept.cache_clear()


def listen(*files: str, few: bool = False) -> None:
    """Run these test files (all, where none is named) and write what they call into the map; few: a few parameters
    of every test."""
    calls, seconds = _kept(files) if files else ({}, {})

    def write(heard: Listener) -> None:
        known = {
            place: sorted({*calls.get(place, ()), *heard.calls.get(place, ())}) for place in {*calls, *heard.calls}
        }
        MAP.parent.mkdir(exist_ok=True)
        MAP.write_text(json.dumps({"calls": known, "seconds": seconds | heard.seconds}), encoding="utf-8")

    awake()
    signal.signal(signal.SIGVTALRM, lambda *_: pytest.skip("it takes too long"))
    pytest.main(
        ["-q", "-p", "no:xdist", "-p", "no:cacheprovider", *(files or [*_BLIND, str(ROOT / "tests")])],
        plugins=[Listener(write, few)],
    )


def _kept(files: Sequence[str]) -> tuple[dict[str, list[str]], dict[str, float]]:
    """The map without what it says of these files."""
    data = json.loads(MAP.read_text(encoding="utf-8")) if MAP.exists() else {"calls": {}, "seconds": {}}
    calls = {
        place: [test for test in tests if test.split("::")[0] not in files] for place, tests in data["calls"].items()
    }
    return calls, {test: took for test, took in data["seconds"].items() if test.split("::")[0] not in files}


@dataclass(frozen=True, slots=True)
class Touched:
    """Which tests call a function, and how many seconds each took."""

    calls: dict[str, list[str]]
    seconds: dict[str, float]

    def knows(self, path: str) -> bool:
        """Whether any test calls anything in this file."""
        return any(place.startswith(f"{path}:") for place in self.calls)

    def chosen(self, path: str, function: str, budget: float, tests: Sequence[str]) -> tuple[str, ...]:
        """The tests that call the function (or anything in its file), with the parameters of these that the map does
        not know (`--few`), quickest first, then their neighbours, within so many seconds; tests: all that there are."""
        here = self.calls.get(f"{path}:{function}") or sorted(
            {test for place, tests in self.calls.items() if place.startswith(f"{path}:") for test in tests}
        )
        took = {test.split("[")[0]: self._took(test) for test in here}
        unheard = {test: took[of] for test in tests if test not in self.seconds and (of := test.split("[")[0]) in took}
        first = {test: self._took(test) for test in here} | unheard
        files = {test.split("::")[0] for test in here}
        near = {test: took for test, took in self.seconds.items() if test.split("::")[0] in files and test not in first}
        taken, spent = list[str](), 0.0
        for test, seconds in [*sorted(first.items(), key=_second), *sorted(near.items(), key=_second)]:
            spent += seconds
            if spent > budget and taken:
                break
            taken.append(test)
        return tuple(taken)

    def _took(self, test: str) -> float:
        return self.seconds.get(test, 1.0)


def _second(pair: tuple[str, float]) -> float:
    return pair[1]


def touched() -> Touched:
    """The map as it was written."""
    data = json.loads(MAP.read_text(encoding="utf-8"))
    return Touched(data["calls"], data["seconds"])
