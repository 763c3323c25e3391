"""python -m tests.fuzz --files N --seed S [--report] | --tables N | --commands N | --classes N | --kills N:
damage, ask by lot, kill, and a table of what came of it."""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from functools import partial
from pathlib import Path

import numpy as np

from .classes import damaged_classes, of_class
from .commands import commands, of_command
from .files import damaged_files, damaged_tables
from .kills import killed
from .outcome import End, Outcome, of_file, of_table
from .workers import LIMIT, outcomes


def main() -> int:
    """Run, print the figures, and leave with 1 where anything broke."""
    asked = argparse.ArgumentParser(prog="tests.fuzz", description=__doc__)
    asked.add_argument("--files", type=int, default=0)
    asked.add_argument("--tables", type=int, default=0)
    asked.add_argument("--commands", type=int, default=0, help="command lines by lot")
    asked.add_argument("--classes", type=int, default=0, help="files of a class")
    asked.add_argument("--kills", type=int, default=0)
    asked.add_argument("--seed", type=int, default=0)
    asked.add_argument("--report", action="store_true", help="set the report of what solves, too")
    asked.add_argument("--keep", type=Path, help="a folder for what broke")
    told = asked.parse_args()
    rng = np.random.default_rng(told.seed)
    broken = 0
    with tempfile.TemporaryDirectory() as folder:
        if told.files:
            tasks = damaged_files(rng, told.files, Path(folder) / "p.yaml")
            broken += _table(
                "files",
                outcomes(partial(_file, report=told.report), tasks, 4 * LIMIT if told.report else LIMIT),
                told.keep,
            )
        if told.tables:
            broken += _table("tables", outcomes(_table_file, damaged_tables(rng, told.tables, Path(folder))), told.keep)
    if told.commands:
        broken += _table("commands", outcomes(of_command, commands(rng, told.commands), SLOW), None, tell=True)
    if told.classes:
        broken += _table("classes", outcomes(of_class, damaged_classes(rng, told.classes), SLOW), None, tell=True)
    for n in range(told.kills):
        with tempfile.TemporaryDirectory() as folder:
            wrong = killed(rng, Path(folder)).wrong
        broken += bool(wrong)
        print(f"kill {n}: {wrong}") if wrong else None
    print(f"kills: {told.kills}") if told.kills else None
    print(f"broken: {broken}")
    return 1 if broken else 0


SLOW = 120.0  # s of the processor for one command


def _file(path: str, report: bool = False) -> Outcome:
    return of_file(Path(path), report)


def _table_file(path: str) -> Outcome:
    return of_table("A-27", Path(path))


def _table(what: str, found: object, keep: Path | None, *, tell: bool = False) -> int:
    """What came of all, and what broke; tell: each that did, as it does."""
    ends: Counter[str] = Counter()
    broken: Counter[str] = Counter()
    for task, outcome in found:  # type: ignore[attr-defined]
        ends[outcome.end] += 1
        if outcome.end in (End.TRACEBACK, End.HANG):
            broken[outcome.said] += 1
            if tell:
                print(f"{outcome.end}: {task}: {outcome.said}", flush=True)
            if keep is not None and broken[outcome.said] == 1:
                keep.mkdir(parents=True, exist_ok=True)
                (keep / f"{what}-{sum(broken.values())}{Path(task).suffix}").write_bytes(Path(task).read_bytes())
    print(f"{what}: " + ", ".join(f"{count} {end}" for end, count in sorted(ends.items())))
    for said, count in broken.most_common():
        print(f"  {count} × {said}")
    return sum(broken.values())


if __name__ == "__main__":
    raise SystemExit(main())
