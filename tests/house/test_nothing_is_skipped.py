"""Where CI is set a skipped test is a failed one, and what the tests need is installed there;
a test that asserts nothing fails anywhere."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parents[1]
RUN = (HERE.parent / ".ci" / "run").read_text(encoding="utf-8") if (HERE.parent / ".ci").exists() else ""
SKIPPED = {
    "marked": "import pytest\n@pytest.mark.skipif(True, reason='no browser')\ndef test_it(): pass\n",
    "inside": "import pytest\ndef test_it(): pytest.skip('no browser')\n",
    "whole": "import pytest\npytest.importorskip('a_package_that_is_not_there', reason='no browser')\n"
    "def test_it(): pass\n",
}
EMPTY = "def test_it():\n    for one in []:\n        assert one\n"
HALF = (
    "import pytest\n@pytest.mark.parametrize('many', [[], [1]])\ndef test_it(many):\n    for one in many:\n"
    "        assert one\n"
)
ASSERTED = {"empty": EMPTY, "half": HALF, "never": HALF.replace("[1]", "()"), "plain": "def test_it(): assert True\n"}
PASSES = {"passes": "def test_it(): pass\n"}
NO_SKIP, NO_ASSERTION = "CI allows no skip: ", "passed without an assertion"


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., str]:
    """The suite's own conftest over all samples, in CI or not: what pytest tells in the end."""

    @cache
    def run(**env: str) -> str:
        folder = tmp_path_factory.mktemp("samples")
        shutil.copy(HERE / "conftest.py", folder / "conftest.py")
        (folder / "pytest.ini").write_text("[pytest]\nenable_assertion_pass_hook = true\n", encoding="utf-8")
        for name, sample in {**SKIPPED, **ASSERTED, **PASSES}.items():
            (folder / f"test_{name}.py").write_text(sample, encoding="utf-8")
        clean = {key: value for key, value in os.environ.items() if key != "CI" and not key.startswith("PYTEST")}
        words = ["-q", "-rA", "-p", "no:cacheprovider", "-p", "no:xdist", "--continue-on-collection-errors"]
        command = [sys.executable, "-m", "pytest", *words, f"--rootdir={folder}", str(folder)]
        return subprocess.run(
            command, capture_output=True, text=True, env=clean | {"COLUMNS": "200"} | env, cwd=folder, check=False
        ).stdout

    return run


def told(text: str, name: str) -> list[str]:
    """The lines of the summary about a sample."""
    return [line for line in text.splitlines() if line.startswith(WAYS) and f"test_{name}.py" in line]


WAYS = ("PASSED", "FAILED", "ERROR", "SKIPPED")


@pytest.mark.parametrize("name", SKIPPED)
def test_a_skipped_test_is_a_failure_in_ci_and_elsewhere_only_skipped(name: str, ran: Callable[..., str]) -> None:
    (there,), (here,) = told(ran(CI="true"), name), told(ran(), name)
    assert there.startswith(("FAILED", "ERROR")) and here.startswith("SKIPPED") and "no browser" in here
    assert ran(CI="true").count(f"{NO_SKIP}") >= len(SKIPPED)


@pytest.mark.parametrize(("name", "fails"), [("empty", True), ("half", False), ("never", True), ("plain", False)])
def test_a_test_whose_assertions_are_never_reached_fails(name: str, fails: bool, ran: Callable[..., str]) -> None:
    for text in (ran(), ran(CI="true")):
        lines = told(text, name)
        assert lines and any(line.startswith("FAILED") for line in lines) == fails
    assert ran().count(NO_ASSERTION) >= 2


def test_a_test_that_passes_passes_in_ci(ran: Callable[..., str]) -> None:
    assert [line[:6] for line in told(ran(CI="true"), "passes")] == ["PASSED"]


@pytest.mark.skipif(not RUN, reason="no checkout")
def test_ci_installs_the_browser_that_the_tests_look_for() -> None:
    from tests.chromium import NAMES

    assert (
        "export CI=true" in RUN
        and "apt-get install" in RUN
        and "chromium" in RUN
        and RUN.rstrip().endswith("make test")
    )
    assert all(name in RUN for name in NAMES)
