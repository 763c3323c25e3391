"""Mutants before the tests: everything is imported and collected once;
each trial is a fork in which one function has the slip.

The spoilt file is compiled, and the code of the function that holds the slip takes the place of the healthy one;
results that were kept are forgotten. Slips outside of functions are not tried,
and a test that starts another process does not see any.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from enum import StrEnum
from functools import _lru_cache_wrapper
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import pytest
from _pytest.runner import runtestprotocol

from .slips import Mutant
from .touched import ROOT, awake, forget, keepers

_PARTLY = (
    "-o",
    "enable_assertion_pass_hook=false",
)  # of a test with parameters only some may be chosen: none of these need reach an assertion
Chosen = Callable[[Mutant, Sequence[str]], Sequence[str]]  # of a mutant and all tests: those to run, in this order
Keepers = Sequence["_lru_cache_wrapper[Any]"]
Took = Mapping[str, float] | None  # seconds of each test where there is no slip


class Fate(StrEnum):
    """What became of a mutant."""

    KILLED = "killed"
    SURVIVED = "survived"
    HUNG = "hung"  # the tests did not end: noticed as well
    UNTESTED = "untested"  # no test calls it


class Trials:
    """A plugin of pytest that, in place of running the tests once, runs some of them for each mutant."""

    def __init__(
        self,
        mutants: Iterable[Mutant],
        chosen: Chosen | None,
        budget: float,
        tell: Callable[[Mutant, Fate], None],
        took: Took,
    ) -> None:
        self.mutants, self.chosen, self.budget, self.tell, self.took = mutants, chosen, budget, tell, took

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Try one mutant after the other."""
        items = {item.nodeid: item for item in session.items}
        functions, kept, names = _functions(), keepers(), tuple(items)
        gc.freeze()  # again: a child that looks through all this for rubbish would copy it, too
        for mutant in self.mutants:
            chosen = self.chosen(mutant, names) if self.chosen else names
            tests = [items[name] for name in chosen if name in items]
            self.tell(mutant, _tried(mutant, functions, tests, self.budget, kept, self.took))
        return True


def try_all(
    mutants: Iterable[Mutant],
    chosen: Chosen | None,
    files: Sequence[str],
    budget: float,
    tell: Callable[[Mutant, Fate], None],
    took: Took = None,
) -> None:
    """Collect the tests (of these files, where any are named), then try every mutant on those chosen for it, or on all;
    no test begins after so many seconds of the processor. took: how long each takes where there is no slip."""
    pytest.main(
        ["-q", "-p", "no:xdist", "-p", "no:cacheprovider", "--no-summary", *_PARTLY, *(files or [str(ROOT / "tests")])],
        plugins=[Trials(mutants, chosen, budget, tell, took)],
    )


def _functions() -> dict[tuple[str, str], list[FunctionType]]:
    """Every living function of the program by file and qualified name; a part that is imported late is imported now."""
    awake()
    gc.unfreeze()  # what conftest.py has set aside is not listed
    found: dict[tuple[str, str], list[FunctionType]] = {}
    for thing in gc.get_objects():
        if isinstance(thing, FunctionType) and thing.__code__.co_filename.startswith(str(ROOT / "vecpoly")):
            found.setdefault((thing.__code__.co_filename, thing.__code__.co_qualname), []).append(thing)
    return found


def _tried(
    mutant: Mutant,
    functions: dict[tuple[str, str], list[FunctionType]],
    tests: Sequence[pytest.Item],
    budget: float,
    kept: Keepers,
    took: Took,
) -> Fate:
    path, outer = str(ROOT / mutant.path), mutant.function.split(".<locals>")[0]
    targets = {name: functions.get((path, name), []) for name in {outer, mutant.function}}
    if not tests or not any(targets.values()):
        return Fate.UNTESTED
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        os.setpgid(0, 0)
        _spoil(path, mutant.text)
        module = compile(mutant.text, path, "exec")
        _run(
            [(one, _code(module, name)) for name, found in targets.items() for one in found], tests, budget, kept, took
        )
    _, status = os.waitpid(child, 0)
    with suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)  # processes that a test had started
    if os.WIFSIGNALED(status):
        return Fate.HUNG if os.WTERMSIG(status) in (signal.SIGVTALRM, signal.SIGPROF) else Fate.KILLED
    return Fate.SURVIVED if os.WEXITSTATUS(status) == 0 else Fate.KILLED


def _spoil(path: str, text: str) -> None:
    """Who reads the source reads the spoilt one."""
    healthy = Path.read_text
    Path.read_text = lambda self, *args, **kwargs: text if str(self) == path else healthy(self, *args, **kwargs)  # type: ignore[method-assign]


def _code(module: CodeType, name: str) -> CodeType:
    """The code of a function by its qualified name."""
    todo = [module]
    while todo:
        one = todo.pop()
        if one.co_qualname == name:
            return one
        todo += [const for const in one.co_consts if isinstance(const, CodeType)]
    raise LookupError(name)


def _run(
    targets: Sequence[tuple[FunctionType, CodeType]],
    tests: Sequence[pytest.Item],
    budget: float,
    kept: Keepers,
    took: Took,
) -> None:
    """The child: never returns. A function made by another before the slip has the code of its own."""
    signal.setitimer(signal.ITIMER_VIRTUAL, 3 * budget + 10)  # of the processor: a busy machine is no endless loop
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)
    failed = True
    try:
        forget(kept)
        for function, code in targets:
            function.__code__ = code
        end = time.process_time() + budget
        failed = any(
            _fails(test, following, max(2.0, end - time.process_time()), took)
            for test, following in zip(tests, [*tests[1:], None], strict=True)
            if time.process_time() < end
        )
    finally:
        os._exit(int(failed))


def _fails(test: Any, following: Any, seconds: float, took: Took) -> bool:
    """A test that takes longer is broken off: it hangs where it is known to be quick, else it tells nothing, for it may
    be one of a whole library."""
    hangs = took is None or took.get(test.nodeid, seconds) < seconds / 5
    signal.signal(signal.SIGPROF, signal.SIG_DFL if hangs else (lambda *_: pytest.skip("it takes too long")))
    signal.setitimer(signal.ITIMER_PROF, seconds)
    reports = runtestprotocol(test, nextitem=following, log=False)
    signal.setitimer(signal.ITIMER_PROF, 0)
    return any(report.failed for report in reports)
