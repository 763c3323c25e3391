"""Laws are checked without a clock: a busy machine is no counterexample. Nothing is skipped in silence in CI, and no
test passes that asserted nothing."""

from __future__ import annotations

import ast
import gc
import inspect
import os
import sys
import textwrap
from collections.abc import Generator
from functools import cache
from importlib import import_module
from typing import Any, TypeVar

import pytest
from _pytest.assertion import util
from hypothesis import settings

# one thread of linear algebra, here and in every process that a test starts: matrices here are small, and threads that
# wait for each other in a busy loop take a tenth of the processors
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
gc.disable()  # until all is collected: hardly anything of what is imported and compiled till then is rubbish

Report = TypeVar("Report", pytest.TestReport, pytest.CollectReport)
settings.register_profile("house", deadline=None, max_examples=8)  # tests/laws.py
settings.register_profile("soak", deadline=None, max_examples=1000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "house"))


ASSERTED: set[str] = set()  # test functions that reached an assertion, for one of their parameters at least
LAST = pytest.StashKey[bool]()


def pytest_configure() -> None:
    """Numbers and words that stand in the house's own files, which Hypothesis reads all to try them now and then, are
    for the soak: to read them takes each worker several seconds."""
    from tests.laws import soaking

    if not soaking():
        providers: Any = import_module("hypothesis.internal.conjecture.providers")
        providers._get_local_constants = lambda: providers._local_constants  # none


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Of dear claims those whose turn it is. Where several workers run groups of tests, those that share what they make
    stand together."""
    if config.args == config.getini("testpaths"):
        _rest(config, items)
    if config.getoption("loadgroup", False):
        from tests.sharing import arrange

        arrange(items)


def _rest(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Take off the dear claims whose turn it is not."""
    from tests.dear import function_of, listed, resting, state, turns
    from tests.laws import soaking

    if soaking():
        return
    names = listed()
    dear = (one.nodeid for one in items if function_of(one.nodeid) in names)
    rest = resting(dear, state(config.rootpath), turns())
    config.hook.pytest_deselected(items=[one for one in items if one.nodeid in rest])
    items[:] = [one for one in items if one.nodeid not in rest]


@pytest.hookimpl(tryfirst=True)
def pytest_collection(session: pytest.Session) -> None:
    """Two workers that meet no compiled test compile half of them each: the second begins at the end."""
    worker = getattr(session.config, "workerinput", {}).get("workerid")
    if worker == "gw1" and session.config.args == session.config.getini("testpaths"):
        from tests.sharing import read_from_the_end

        read_from_the_end(session.config.rootpath / "tests")


@pytest.hookimpl(optionalhook=True)  # of xdist
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> object:
    """Where several workers run groups of tests, those that share what they make are run by one."""
    if config.getoption("dist") != "loadgroup":
        return None
    from tests.sharing import scheduler

    return scheduler(config, log)


def pytest_collection_finish() -> None:
    """Thousands of tests, and the drawings that many of them share, are there to stay: to look through them for
    rubbish at every turn would take a third of the time."""
    _keep_commands()
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 20, 50)
    gc.enable()


def _keep_commands() -> None:
    """The commands are built from their functions once for all tests that give them words, as once in a process."""
    runner: Any = sys.modules.get("typer.testing")
    if runner is not None:
        runner._get_command = cache(runner._get_command)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """A test that was skipped in CI has failed: what it needs was to be installed.
    So has one that asserted nothing for any of its parameters."""
    report = _no_skip((yield))
    if (
        report.passed
        and call.when == "call"
        and item.stash.get(LAST, False)
        and _function(item) not in ASSERTED
        and _asserts(item)
    ):
        report.outcome, report.longrepr = (
            "failed",
            "passed without an assertion: all of them stand in loops or branches that were never entered",
        )
    return report


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> None:
    """The last test of a function is where all its parameters have had their turn."""
    item.stash[LAST] = item.config.getini("enable_assertion_pass_hook") and (
        nextitem is None or _function(nextitem) != _function(item)
    )


def pytest_runtest_setup(item: pytest.Item) -> None:
    """What is known to assert is no longer watched."""
    if _function(item) in ASSERTED:
        _look_away()


def pytest_assertion_pass(item: pytest.Item) -> None:
    """An assertion was reached, and held: one is enough."""
    ASSERTED.add(_function(item))
    _look_away()


def _look_away() -> None:
    """Until the next test: telling of an assertion that holds writes out all its values,
    which takes half the time of the suite."""
    util._assertion_pass = None


def _function(item: pytest.Item) -> str:
    return item.nodeid.split("[")[0]


def _asserts(item: pytest.Item) -> bool:
    """Whether there is an assertion in the test itself, not only in what it calls."""
    function: Any = getattr(item, "function", None)
    law = getattr(function, "hypothesis", None)
    try:
        text = textwrap.dedent(inspect.getsource(law.inner_test if law else function))
    except (OSError, TypeError):
        return False
    return any(isinstance(node, ast.Assert) for node in ast.walk(ast.parse(text)))


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """The same for a whole file that is skipped."""
    return _no_skip((yield))


def _no_skip(report: Report) -> Report:
    if report.skipped and os.environ.get("CI", "").lower() in ("1", "true") and not hasattr(report, "wasxfail"):
        report.outcome, report.longrepr = "failed", f"skipped, where CI allows no skip: {report.longrepr}"
    return report
