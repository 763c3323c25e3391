"""One mutant before the tests: in a copy of the house, in a process of its own, with a limit of time."""

from __future__ import annotations

import contextlib
import importlib
import os
import shutil
import signal
import sys
from collections.abc import Iterator, Sequence
from enum import StrEnum
from pathlib import Path
from tempfile import TemporaryDirectory

from .slips import Mutant
from .touched import ROOT

_HEAVY = ("numpy", "shapely.geometry", "pydantic", "ruamel.yaml", "jinja2", "pypdf", "pdfplumber", "hypothesis", "openpyxl", "typer", "rich",
          "matplotlib.figure", "reportlab.pdfgen.canvas", "pypdfium2", "fontTools.ttLib", "pint", "pytest")
_HOUSE = ("vecpoly", "tests", "templates", "problems", "docs", "benchmarks")


class Fate(StrEnum):
    """What became of a mutant."""

    KILLED = "killed"
    SURVIVED = "survived"
    HUNG = "hung"  # the tests did not end: noticed as well
    UNTESTED = "untested"  # no test calls it


@contextlib.contextmanager
def copied() -> Iterator[Path]:
    """A copy of the house; what is heavy is imported once, for all trials."""
    for name in _HEAVY:
        importlib.import_module(name)
    with TemporaryDirectory(prefix="mutants-") as folder:
        house = Path(folder)
        for part in _HOUSE:
            shutil.copytree(ROOT / part, house / part)
        for path in (path for path in ROOT.iterdir() if path.is_file()):
            shutil.copy2(path, house / path.name)
        yield house


def trial(house: Path, mutant: Mutant, tests: Sequence[str], limit: int) -> Fate:
    """Put the slip into the copy, run these tests, mend the copy."""
    if not tests:
        return Fate.UNTESTED
    target = house / mutant.path
    healthy, times = target.read_bytes(), target.stat()
    target.write_text(mutant.text, encoding="utf-8")
    try:
        return _judged(house, tests, limit)
    finally:
        target.write_bytes(healthy)
        os.utime(target, ns=(times.st_atime_ns, times.st_mtime_ns))


def _judged(house: Path, tests: Sequence[str], limit: int) -> Fate:
    child = os.fork()
    if child == 0:
        _run(house, tests, limit)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return Fate.HUNG if os.WTERMSIG(status) == signal.SIGALRM else Fate.KILLED
    return Fate.SURVIVED if os.WEXITSTATUS(status) == 0 else Fate.KILLED


def _run(house: Path, tests: Sequence[str], limit: int) -> None:
    """The child: never returns."""
    import pytest

    signal.alarm(limit)
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)
    os.chdir(house)
    os.environ["PYTHONPATH"] = str(house)
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.dont_write_bytecode = True
    sys.path[:] = [str(house), *(place for place in sys.path if place not in ("", str(ROOT)))]
    for name in [name for name in sys.modules if name.split(".")[0] in ("vecpoly", "tests")]:
        del sys.modules[name]
    code = 1
    try:
        code = int(pytest.main(["-x", "-q", "-p", "no:xdist", "-p", "no:cacheprovider", "-p", "no:randomly", *tests]))
    finally:
        os._exit(min(code, 255))
