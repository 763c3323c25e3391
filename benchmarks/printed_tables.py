"""Two printed tables of the course assignments checked against the oracle, slips named: CPU seconds of each."""

from __future__ import annotations

from pathlib import Path
from time import process_time

from vecpoly.check.table.whole import check_table
from vecpoly.problem.load import load

TABLES = Path(__file__).parent.parent / "problems" / "homework" / "tables"
CASES = (("A-16", "A_p16"), ("B-26.5", "B_table_1A"))


def run() -> str:
    """One line of the report."""
    parts = []
    for problem, table in CASES:
        start = process_time()
        check_table(load(problem), TABLES / f"{table}_printed.csv")
        parts.append(f"{table} against {problem} {process_time() - start:.1f} s")
    return f"printed tables checked: {', '.join(parts)}; aim < 5 s"


if __name__ == "__main__":
    print(run())
