"""Tests for a function of which the map knows nothing: those of files whose names say most of what its path says."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import zip_longest

_FILES = 8  # files of tests that are tried
_ALL = "tests/library/"  # claims about all that is drawn and told: after those that are near
_SILENT = frozenset({"vecpoly", "tests", "test", "py", "init", "methods", "and", "of", "by", "in", "laws", "drawn"})


def alike(path: str, tests: Sequence[str]) -> tuple[str, ...]:
    """The tests of the files that share most words with the path: one of each function first, then the others."""
    wanted = _words(path)
    files = sorted({test.split("::")[0] for test in tests}, key=lambda file: (-_shared(wanted, _words(file)), file))
    best = [file for file in files[:_FILES] if _shared(wanted, _words(file))]
    near = {file: rank for rank, file in enumerate([*best, *(file for file in files if file.startswith(_ALL))])}
    functions: dict[str, list[str]] = defaultdict(list)
    for test in tests:
        if test.split("::")[0] in near:
            functions[test.split("[")[0]].append(test)
    ordered = [functions[name] for name in sorted(functions, key=lambda name: near[name.split("::")[0]])]
    return tuple(test for turn in zip_longest(*ordered) for test in turn if test is not None)


def _words(path: str) -> dict[str, int]:
    """The stems of a path's words (a cam is found where cams are, a grade where grading is), and what each counts: a
    word of the file's own name twice."""
    folder, _, name = path.rpartition("/")
    return {
        word[:4].rstrip("s"): weight
        for part, weight in ((folder, 1), (name, 2))
        for word in re.split(r"[/_.]", part)
        if word and word not in _SILENT
    }


def _shared(wanted: Mapping[str, int], words: Mapping[str, int]) -> int:
    return sum(weight * words[word] for word, weight in wanted.items() if word in words)
