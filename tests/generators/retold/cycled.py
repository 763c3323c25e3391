"""The whole cycle of a mechanism as a table of ours:
its row at the given position is the solution, and as a printed table it is reproduced."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

from vecpoly.check.table.whole import check_table
from vecpoly.cycle import csv_bytes, cycle, table
from vecpoly.names import parse_rel
from vecpoly.solution import Solution

from ..family import family
from ..library import data_of
from .original import original, told

ROWS = 37
TURNING = (
    "change-points",
    "four-bar",
    "linkage-rrr",
    "linkage-rrp",
    "linkage-rpr",
    "linkage-prp",
    "linkage-rpp",
    "linkage-cam",
    "gears-pivots",
    "gears-arms",
    "gears-stepped",
    "offset-slot-drives",
)


def reproduced(solution: Solution) -> str:
    """What `vecpoly cycle` writes, `vecpoly check --table` finds right in every column."""
    problem = solution.problem
    keys = [
        key
        for key in solution.answers
        if parse_rel(key).ref is None and parse_rel(key).kind.name in ("OMEGA", "ALPHA", "V", "A")
    ][:8]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "t.csv"
        path.write_bytes(csv_bytes(table(cycle(problem, ROWS), tuple(keys))))
        found = check_table(problem, path)
    if len(found.columns) < len(keys):
        return f"{len(found.columns)} columns compared of {len(keys)}"
    return "" if found.agrees else "; ".join(f"{one.column.header}: {one.words.en}" for one in found.columns)


@family("retold-cycle", also=reproduced, often=1)
def whole_cycle(rng: np.random.Generator) -> str:
    """Any member of the kinematic families."""
    mark, text = original(rng, TURNING)
    return told(data_of(text), mark)
