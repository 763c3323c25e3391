"""An assignment to start a class from: problems with the ranges that were found for them."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...problem.library import find
from ...problem.problem import Problem
from .chosen import Proposal

_PLAIN = re.compile(r"[A-Za-z_]\w+")  # needs no quotes in YAML
_HEAD = "id: {id}\ntitle: {{zh: 作业, en: Homework}}\nproblems:\n"


def assignment(name: str, found: Sequence[tuple[Problem, Proposal]], folder: Path) -> str:
    """The text of the file, which will lie in this folder."""
    entries = ("\n".join(entry(problem, proposal, folder)) for problem, proposal in found)
    return _HEAD.format(id=json.dumps(name, ensure_ascii=False)) + "\n".join(entries) + "\n"


def entry(problem: Problem, proposal: Proposal, folder: Path | None = None) -> Iterator[str]:
    """The lines of one problem in an assignment."""
    yield f"  - problem: {_place(problem, folder)}"
    if problem.scales.given:
        yield "    scales: null"
    yield "    vary:"
    for one in proposal.ranges:
        name = one.name if _PLAIN.fullmatch(one.name) else json.dumps(one.name)
        yield f"      {name}: {one.text}"


def lies_outside(problem: Problem, folder: Path) -> bool:
    """Whether its file is none that an assignment in this folder may name without being allowed to."""
    return _place(problem, folder).startswith('"..')


def _place(problem: Problem, folder: Path | None) -> str:
    """Its id, where the library has it; else its file as the assignment sees it."""
    if problem.path is None or find(problem.id) == problem.path:
        return json.dumps(problem.id, ensure_ascii=False)
    path = os.path.relpath(problem.path, folder) if folder is not None else str(problem.path)
    return json.dumps(path, ensure_ascii=False)
