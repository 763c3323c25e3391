"""Which files run on one worker, for they share what is made; which come first, so that all workers end together."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

# who imports from one of these wants what it has made already
MADE = ("tests.drawn_library", "tests.studies", "tests.batch.homework", "tests.sources")
FAMILIES = ("test_course", "test_printed_tables")  # files of one name solve the same problems
LONGEST = (
    "test_course",
    "test_generated",
    "test_printed_tables",
    "tests.drawn_library",
    "tests.batch.homework",
    "test_player",
    "test_no_key_is_ignored",
    "test_labels",
    "test_export_geogebra",
    "test_fuzz",
    "test_cli_process",
    "test_centres_hard",
    "test_solution",
    "test_nothing_is_skipped",
    "test_centres",
    "test_cycle_breaks",
    "test_force_report",
    "test_plugins",
    "test_architecture",
)


def group(item: pytest.Item) -> str:
    """The name of those with whom a test shares a worker: its file, or several."""
    stem = item.path.stem
    if family := next((one for one in FAMILIES if stem.startswith(one)), None):
        return family
    wanted = {getattr(value, "__module__", None) for value in vars(getattr(item, "module", item)).values()}
    return next((made for made in MADE if made in wanted), stem)


def arrange(items: list[pytest.Item]) -> None:
    """Tests that share a worker stand together, those that take longest first."""
    groups = {item.nodeid: group(item) for item in items}
    for item in items:
        item.add_marker(pytest.mark.xdist_group(groups[item.nodeid]))
    met = list(dict.fromkeys(groups.values()))
    place = {name: i for i, name in enumerate(_longest_first(met))}
    items.sort(key=lambda item: place[groups[item.nodeid]])


def _longest_first(met: Sequence[str]) -> list[str]:
    known = [name for name in LONGEST if name in met]
    return [*known, *(name for name in met if name not in known)]
