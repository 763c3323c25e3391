"""Which files run on one worker, for they share what is made; which come first, so that all workers end together.

The groups of xdist itself (`xdist_group`) do nothing under pytest 9.2, which no longer lets a plug-in write into the
ids of tests: hence a scheduler of our own, by the one method that xdist leaves open for it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from _pytest.pathlib import import_path
from xdist.scheduler import LoadScopeScheduling

# who imports from one of these wants what it has made already
MADE = (
    "tests.drawn_library",
    "tests.studies",
    "tests.batch.homework",
    "tests.sources",
    "tests.checked_tables",
    "tests.player.pages",
    "tests.grading.drawings.made",
    "tests.grading.cases",
    "tests.variants.block",
)
JOINED = {"tests.projects": "tests.studies"}  # a report of a project is read with the course reports too
IMPORT = re.compile(r"^from (tests\.[\w.]+) import", re.MULTILINE)
LONGEST = (
    "tests.batch.homework",
    "tests.studies",
    "tests.drawn_library",
    "tests.checked_tables",
    "generated/test_generated",
    "tests.player.pages",
    "tests.grading.drawings.made",
    "tests.grading.cases",
    "export/test_export_geogebra",
    "problem/test_no_key_is_ignored",
    "generated/test_fuzz",
    "cycle/test_cycle_breaks",
    "report/test_force_report",
    "centres/test_centres_hard",
    "cli/test_cli_process",
)


@cache
def group(file: Path) -> str:
    """The name of those with whom a file shares a worker: what they have in common, or its own."""
    imported = IMPORT.findall(file.read_text(encoding="utf-8"))
    makers = [JOINED.get(name, name) for name in imported]
    return next((made for made in MADE if made in makers), f"{file.parent.name}/{file.stem}")


def arrange(items: list[pytest.Item]) -> None:
    """Tests that share a worker stand together, those that take longest first."""
    groups = [group(item.path) for item in items]
    place = {name: i for i, name in enumerate(_longest_first(tuple(dict.fromkeys(groups))))}
    items.sort(key=lambda item: place[group(item.path)])


def _longest_first(met: Sequence[str]) -> list[str]:
    known = [name for name in LONGEST if name in met]
    return [*known, *(name for name in met if name not in known)]


def read_from_the_end(tests: Path) -> None:
    """Import the files of tests, the last one first; what is wrong with one is told when it is collected."""
    for file in sorted(tests.rglob("test_*.py"), reverse=True):
        with suppress(Exception):
            import_path(file, root=tests.parent, consider_namespace_packages=False)


def scheduler(config: pytest.Config, log: object) -> Any:
    """Hands each group to one worker, in the order in which they stand."""
    shared = LoadScopeScheduling(config, log)
    shared._split_scope = lambda nodeid: group(config.rootpath / nodeid.partition("::")[0])
    return shared
