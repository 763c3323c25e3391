"""Mutants before the tests: everything is imported and collected once;
each trial is a fork in which one function has the slip.

The spoilt file is compiled, and the code of the function that holds the slip takes the place of the healthy one;
results that were kept are forgotten. Slips outside of functions are not tried,
and a test that starts another process does not see any.
"""

from __future__ import annotations

import gc
import importlib
import os
import pkgutil
import signal
import sys
from collections.abc import Callable, Iterable, Sequence
from enum import StrEnum
from functools import _lru_cache_wrapper
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import pytest
from _pytest.runner import runtestprotocol

import vecpoly

from .slips import Mutant
from .touched import ROOT, forget, keepers

_PARTLY = (
    "-o",
    "enable_assertion_pass_hook=false",
)  # of a test with parameters only some may be chosen: none of these need reach an assertion
Chosen = Callable[[Mutant], Sequence[str]]
Keepers = Sequence["_lru_cache_wrapper[Any]"]


class Fate(StrEnum):
    """What became of a mutant."""

    KILLED = "killed"
    SURVIVED = "survived"
    HUNG = "hung"  # the tests did not end: noticed as well
    UNTESTED = "untested"  # no test calls it


class Trials:
    """A plugin of pytest that, in place of running the tests once, runs some of them for each mutant."""

    def __init__(
        self, mutants: Iterable[Mutant], chosen: Chosen | None, limit: int, tell: Callable[[Mutant, Fate], None]
    ) -> None:
        self.mutants, self.chosen, self.limit, self.tell = mutants, chosen, limit, tell

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Try one mutant after the other."""
        items = {item.nodeid: item for item in session.items}
        functions, kept = _functions(), keepers()
        for mutant in self.mutants:
            tests = [items[name] for name in self.chosen(mutant) if name in items] if self.chosen else session.items
            self.tell(mutant, _tried(mutant, functions, tests, self.limit, kept))
        return True


def try_all(
    mutants: Iterable[Mutant],
    chosen: Chosen | None,
    files: Sequence[str],
    limit: int,
    tell: Callable[[Mutant, Fate], None],
) -> None:
    """Collect the tests (of these files, where any are named),
    then try every mutant on those chosen for it, or on all."""
    pytest.main(
        ["-q", "-p", "no:xdist", "-p", "no:cacheprovider", "--no-summary", *_PARTLY, *(files or [str(ROOT / "tests")])],
        plugins=[Trials(mutants, chosen, limit, tell)],
    )


def _functions() -> dict[tuple[str, str], list[FunctionType]]:
    """Every living function of the program by file and qualified name; a part that is imported late is imported now."""
    for part in pkgutil.walk_packages(vecpoly.__path__, "vecpoly."):
        importlib.import_module(part.name)
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
    limit: int,
    kept: Keepers,
) -> Fate:
    path, outer = str(ROOT / mutant.path), mutant.function.split(".<locals>")[0]
    targets = {name: functions.get((path, name), []) for name in {outer, mutant.function}}
    if not tests or not any(targets.values()):
        return Fate.UNTESTED
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        _spoil(path, mutant.text)
        module = compile(mutant.text, path, "exec")
        _run([(one, _code(module, name)) for name, found in targets.items() for one in found], tests, limit, kept)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return Fate.HUNG if os.WTERMSIG(status) == signal.SIGVTALRM else Fate.KILLED
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
    targets: Sequence[tuple[FunctionType, CodeType]], tests: Sequence[pytest.Item], limit: int, kept: Keepers
) -> None:
    """The child: never returns. A function made by another before the slip has the code of its own."""
    signal.setitimer(signal.ITIMER_VIRTUAL, limit)  # of the processor: a busy machine is no endless loop
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)
    failed = True
    try:
        forget(kept)
        for function, code in targets:
            function.__code__ = code
        failed = any(_fails(test, following) for test, following in zip(tests, [*tests[1:], None], strict=True))
    finally:
        os._exit(int(failed))


def _fails(test: Any, following: Any) -> bool:
    return any(report.failed for report in runtestprotocol(test, nextitem=following, log=False))
