"""Where CI is set a skipped test is a failed one, and what the tests need is installed there;
a test that asserts nothing fails anywhere."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parents[1]
RUN = (HERE.parent / ".ci" / "run").read_text(encoding="utf-8") if (HERE.parent / ".ci").exists() else ""
SAMPLES = {
    "marked": "import pytest\n@pytest.mark.skipif(True, reason='no browser')\ndef test_it(): pass\n",
    "inside": "import pytest\ndef test_it(): pytest.skip('no browser')\n",
    "whole": "import pytest\npytest.importorskip('a_package_that_is_not_there', reason='no browser')\n"
    "def test_it(): pass\n",
}


def ran(folder: Path, sample: str, **env: str) -> subprocess.CompletedProcess[str]:
    """The suite's own conftest over a file of one test."""
    shutil.copy(HERE / "conftest.py", folder / "conftest.py")
    (folder / "test_sample.py").write_text(sample, encoding="utf-8")
    clean = {key: value for key, value in os.environ.items() if key != "CI" and not key.startswith("PYTEST")}
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "-p",
        "no:xdist",
        f"--rootdir={folder}",
        str(folder),
    ]
    return subprocess.run(command, capture_output=True, text=True, env=clean | env, cwd=folder, check=False)


@pytest.mark.parametrize("kind", SAMPLES)
def test_a_skipped_test_is_a_failure_in_ci(kind: str, tmp_path: Path) -> None:
    done = ran(tmp_path, SAMPLES[kind], CI="true")
    assert done.returncode in (1, 2) and "CI allows no skip" in done.stdout and "no browser" in done.stdout


def test_elsewhere_a_skipped_test_is_only_skipped(tmp_path: Path) -> None:
    done = ran(tmp_path, SAMPLES["marked"])
    assert done.returncode == 0 and "1 skipped" in done.stdout


EMPTY = "def test_it():\n    for one in []:\n        assert one\n"
HALF = (
    "import pytest\n@pytest.mark.parametrize('many', [[], [1]])\ndef test_it(many):\n    for one in many:\n"
    "        assert one\n"
)


@pytest.mark.parametrize(
    ("sample", "fails"),
    [(EMPTY, True), (HALF, False), (HALF.replace("[1]", "()"), True), ("def test_it(): assert True\n", False)],
)
def test_a_test_whose_assertions_are_never_reached_fails(sample: str, fails: bool, tmp_path: Path) -> None:
    (tmp_path / "pytest.ini").write_text("[pytest]\nenable_assertion_pass_hook = true\n", encoding="utf-8")
    done = ran(tmp_path, sample)
    assert (done.returncode == 1) == fails == ("passed without an assertion" in done.stdout), done.stdout


def test_a_test_that_passes_passes_in_ci(tmp_path: Path) -> None:
    assert ran(tmp_path, "def test_it(): pass\n", CI="true").returncode == 0


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
