"""The printed tables of the library, each checked once for all that is claimed of it."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from vecpoly.check.table.whole import TableCheck, check_table
from vecpoly.problem.load import load

PRINTED = Path(__file__).resolve().parents[1] / "problems" / "homework" / "tables"


@cache
def checked(problem: str, table: str) -> TableCheck:
    """The table of this name against the problem."""
    return check_table(load(problem), PRINTED / f"{table}_printed.csv")
